// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/plan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fairway::uuv {
namespace {

constexpr std::array chosen_settings{"fit_head_on", "fit_ships", "common"};

struct PublishedMoment {
  Encounter encounter{};
  std::string_view quantity;
  double value{};
};

/// cao2022, sections 4.1 and 4.2.
constexpr std::array moments{
    PublishedMoment{Encounter::head_on, "slow_down_time_s", 10.0},
    PublishedMoment{Encounter::head_on, "pass_time_s", 12.0},
    PublishedMoment{Encounter::head_on, "resume_time_s", 13.0},
    PublishedMoment{Encounter::head_on, "arrive_time_s", 20.0},
    PublishedMoment{Encounter::head_on, "contact_count", 0.0},
    PublishedMoment{Encounter::head_on, "keeps_right_ratio", 1.0},
    PublishedMoment{Encounter::multi_obstacle, "slow_down_time_s", 7.0},
    PublishedMoment{Encounter::multi_obstacle, "slowest_time_s", 9.0},
    PublishedMoment{Encounter::multi_obstacle, "resume_time_s", 11.0},
    PublishedMoment{Encounter::multi_obstacle, "arrive_time_s", 20.0},
    PublishedMoment{Encounter::multi_obstacle, "contact_count", 0.0},
};

std::string mode_of(const Setting& setting, Hull hull) {
  return fmt::format("{} {}", setting.name, name_of(hull));
}

Cell published_cell(Encounter encounter, const Setting& setting, Hull hull, const Method& method) {
  return planned_cell("uuv", name_of(encounter), method.name, mode_of(setting, hull), 1,
                      [encounter, &setting, hull, &method](std::uint64_t seed) {
                        return encounter_scenario(encounter, meeting_of(encounter), setting, hull, method,
                                                  seed);
                      });
}

}  // namespace

std::string_view fit_of(Encounter encounter) {
  return encounter == Encounter::head_on ? "fit_head_on" : "fit_ships";
}

std::optional<double> published(Encounter encounter, std::string_view quantity) {
  for (const PublishedMoment& moment : moments) {
    if (moment.encounter == encounter && moment.quantity == quantity) return moment.value;
  }
  return {};
}

Labels published_labels(Encounter encounter, const Setting& setting, Hull hull, const Method& method) {
  return cell_labels(name_of(encounter), method.name, mode_of(setting, hull));
}

std::vector<Cell> published_cells() {
  const Method& rvo = planar_methods().front();
  std::vector<Cell> cells;
  for (const Encounter encounter : encounters) {
    const std::string_view fit = fit_of(encounter);
    cells.push_back(published_cell(encounter, find_setting(fit), Hull::point, rvo));
    for (const Setting& setting : settings()) {
      if (setting.name != fit) cells.push_back(published_cell(encounter, setting, Hull::point, rvo));
    }
    for (const std::string_view name : chosen_settings)
      cells.push_back(published_cell(encounter, find_setting(name), Hull::unicycle, rvo));
    for (const Method& method : planar_methods().subspan(1))
      cells.push_back(published_cell(encounter, find_setting("common"), hull_of(method), method));
  }
  return cells;
}

std::vector<Cell> varied_cells(int seeds) {
  std::vector<Cell> cells;
  for (const Encounter encounter : {Encounter::head_on, Encounter::multi_obstacle}) {
    for (const Method& method : planar_methods()) {
      const auto scenario = [encounter, &method](std::uint64_t seed) {
        return encounter_scenario(encounter, varied(encounter, seed), find_setting("common"), hull_of(method),
                                  method, seed);
      };
      cells.push_back(planned_cell("uuv", name_of(encounter), method.name, "varied", seeds, scenario));
    }
  }
  return cells;
}

std::vector<Cell> gathering_cells(int seeds) {
  std::vector<Cell> cells;
  for (const Gathering& gathering : gatherings()) {
    const int runs = gathering.count < 32 ? seeds : (seeds + 4) / 5;
    for (const Awareness& awareness : awarenesses()) {
      for (const Method& method : gathering_methods()) {
        const auto scenario = [&gathering, &awareness, &method](std::uint64_t seed) {
          return gathering_scenario(gathering, awareness, method, seed);
        };
        cells.push_back(planned_cell("uuv", gathering.name(), method.name, awareness.name, runs, scenario));
      }
    }
  }
  return cells;
}

std::vector<Cell> silence_cells(int seeds) {
  std::vector<Channel> channels{{Channel::Kind::perfect}, {Channel::Kind::modem}};
  for (const double loss : loss_ratios) {
    for (const double rate : update_rates_hz) channels.push_back({Channel::Kind::acoustic, rate, loss});
  }
  std::vector<Cell> cells;
  for (const std::string_view cube : silent_cubes()) {
    for (const Method& method : silence_methods()) {
      for (const Channel& channel : channels) {
        const auto scenario = [cube, &method, channel](std::uint64_t seed) {
          return silence_scenario(cube, method, channel, seed);
        };
        cells.push_back(planned_cell("uuv", cube, method.name, channel.name(), seeds, scenario));
      }
    }
  }
  return cells;
}

}  // namespace fairway::uuv
