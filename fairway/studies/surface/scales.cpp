// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/scales.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/claim.hpp"
#include "fairway/studies/page_blocks.hpp"

namespace fairway::surface {
namespace {

using nlohmann::json;

constexpr std::array lengths{15.0, 20.0, 25.0, 30.0, 35.0, 40.0};     // [m]
constexpr std::array limits{0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2, 1.5};  // [m/s]
constexpr std::array timed{Course::cluttered, Course::orthogonal, Course::diagonal};
constexpr std::array sailors{"avoa", "teb"};
constexpr double wanted_ratio =
    0.8;                            // of the limit, by AVOA, as in the published part; TEB goes at the limit
constexpr double arrival_m = 1.0;   // from the goal a run has arrived
constexpr double patience = 200.0;  // of a run [s]
constexpr double within = 0.15;     // of a printed time, as a verdict has it

std::string mode_of(double length, double limit) { return fmt::format("{:g}m_{:g}mps", length, limit); }

Scenario scaled_passage(Course course, double length, double limit, std::string_view sailor) {
  ParamValues params;
  if (sailor == "teb") params = {{"max_vel_x_mps", limit}, {"max_vel_theta_radps", 0.3751}};
  Scenario scenario =
      passage(course, scaled(course, length), Vessel::zarco, {sailor, sailor, std::move(params)}, 1);
  scenario.duration_s = patience;
  scenario.vehicles.front().limits.max_speed = limit;
  scenario.vehicles.front().mission.front().speed_mps = wanted_ratio * limit;
  return scenario;
}

/// Where the own vessel crosses the way of the other.
class Crossing final : public FrameSink {
 public:
  explicit Crossing(const Scenario& scenario) {
    const auto other = std::ranges::find_if(scenario.obstacles, &ObstacleSpec::moves);
    if (other != scenario.obstacles.end()) other_ = *other;
  }

  void write(const Frame& frame) override {
    if (!other_ || ahead_) return;
    const Vec3 course = other_->velocity.normalized();
    const Vec3 offset = frame.vehicles.front().state.p_n - other_->position - frame.time * other_->velocity;
    const double side = course.cross(offset).z();
    if (side_ && *side_ * side <= 0.0) ahead_ = course.dot(offset);
    side_ = side;
  }

  std::optional<double> ahead() const { return ahead_; }

 private:
  std::optional<ObstacleSpec> other_;
  std::optional<double> side_, ahead_;
};

const Cell& cell_at(const std::vector<Cell>& cells, Course course, std::string_view sailor, double length,
                    double limit) {
  return find_cell(cells, name_of(course), sailor, mode_of(length, limit));
}

/// The time of a run that arrived.
double time_of(const Cell& cell) {
  return arrived(cell, 0) ? cell.value(0, "navigation_time_s") : std::nan("");
}

double printed_time(Course course, std::string_view sailor) {
  return *published(course, sailor, "navigation_time_s");
}

/// All three printed times come out.
bool fits(const std::vector<Cell>& cells, std::string_view sailor, double length, double limit) {
  return std::ranges::all_of(timed, [&](Course course) {
    const double printed = printed_time(course, sailor);
    return std::abs(time_of(cell_at(cells, course, sailor, length, limit)) - printed) <= within * printed;
  });
}

bool touches_something(const std::vector<Cell>& cells, std::string_view sailor, double length, double limit) {
  return std::ranges::any_of(
      timed, [&](Course course) { return touched(cell_at(cells, course, sailor, length, limit), 0); });
}

/// "0.4 m/s, 0.5 m/s touching something", or "none".
std::string limits_that_fit(const std::vector<Cell>& cells, std::string_view sailor, double length) {
  std::vector<std::string> fitting;
  for (const double limit : limits) {
    if (!fits(cells, sailor, length, limit)) continue;
    const bool touches = touches_something(cells, sailor, length, limit);
    fitting.push_back(fmt::format("{:g} m/s{}", limit, touches ? " touching something" : ""));
  }
  return fitting.empty() ? "none" : fmt::format("{}", fmt::join(fitting, ", "));
}

constexpr double slow = 0.6, fast = 1.0;  // TEB's limits up to and from here are told apart [m/s]

/// At how many lengths and limits TEB is so, of those at which that can be said.
struct Share {
  int so{}, all{};
};

using IsSo = std::function<std::optional<bool>(double length, double limit)>;

Share share_of(double least, double most, const IsSo& is_so) {
  Share share;
  for (const double length : lengths) {
    for (const double limit : limits) {
      if (limit < least || limit > most) continue;
      const std::optional<bool> answer = is_so(length, limit);
      share.all += answer ? 1 : 0;
      share.so += answer.value_or(false) ? 1 : 0;
    }
  }
  return share;
}

std::string slow_against_fast(std::string_view claim, const IsSo& is_so) {
  const Share of_slow = share_of(0.0, slow, is_so), of_fast = share_of(fast, limits.back(), is_so);
  if (of_slow.all == 0 && of_fast.all == 0) return stated(claim, Standing::not_measured, "");
  return fmt::format("{}: so at {} of {} lengths and limits up to {:g} m/s, and at {} of {} from {:g} m/s.",
                     claim, of_slow.so, of_slow.all, slow, of_fast.so, of_fast.all, fast);
}

json crossing_of(const std::vector<Cell>& cells, Course course, double length, double limit) {
  return page::number(cell_at(cells, course, "teb", length, limit).value(0, "ahead_of_vessel_m"));
}

}  // namespace

std::vector<Cell> scale_cells() {
  std::vector<Cell> cells;
  for (const Course course : timed) {
    for (const std::string_view sailor : sailors) {
      for (const double length : lengths) {
        for (const double limit : limits) {
          const auto scenario = [=](std::uint64_t) { return scaled_passage(course, length, limit, sailor); };
          cells.push_back(
              planned_cell("surface", name_of(course), sailor, mode_of(length, limit), 1, scenario));
        }
      }
    }
  }
  return cells;
}

std::vector<Measure> measure_scale(const Scenario& scenario, const Catalogs& catalogs,
                                   const std::atomic<bool>* stop, std::span<FrameSink* const> more) {
  Crossing crossing{scenario};
  std::vector<Measure> measures = measure_run(scenario, catalogs, stop, sinks_of({&crossing}, more));
  if (const auto ahead = crossing.ahead()) measures.push_back({"ahead_of_vessel_m", 0, *ahead});
  return measures;
}

std::vector<StudyRow> scale_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    for (const std::string_view quantity : {"navigation_time_s", "heading_change_rad", "speed_change_mps",
                                            "footprint_clearance_m", "ahead_of_vessel_m"}) {
      const double measured = cell.value(0, quantity);
      if (!std::isfinite(measured)) continue;
      rows.push_back(cell_row(cell, quantity, measured, measured, measured, "one run"));
      const Scenario scenario = cell.runs.front().scenario();
      rows.back().params = {{"length_m", scenario.vehicles.front().mission.front().position.x()},
                            {"limit_mps", scenario.vehicles.front().limits.max_speed}};
    }
  }
  return rows;
}

std::vector<std::string> scale_findings(const std::vector<Cell>& cells) {
  std::vector<std::string> made_good;
  for (const Course course : timed) {
    const double longest = limits.back() * printed_time(course, "avoa") + arrival_m;
    made_good.push_back(fmt::format("{} {:.1f} m and {:.2f} m/s", name_of(course), longest,
                                    longest / printed_time(course, "teb")));
  }
  std::vector<std::string> lines{
      fmt::format("The paper prints neither the length of its courses nor what limit TEB really had. From "
                  "its own numbers alone: in the times that it prints AVOA makes good, at no more than {:g} "
                  "m/s, at most so long a course, and TEB on it at most so much speed: {}. What limit that "
                  "is takes runs: each course at several scales, buoys and vessels of the same size.",
                  limits.back(), fmt::join(made_good, ", "))};
  for (const double length : lengths) {
    lines.push_back(fmt::format(
        "At {:g} m the three printed times come out within 15 % under limits of: TEB {}; AVOA {}.", length,
        limits_that_fit(cells, "teb", length), limits_that_fit(cells, "avoa", length)));
  }
  lines.push_back(slow_against_fast(
      "\"C takes TEB longer than B\" (printed 70 s and 64 s)", [&](double length, double limit) {
        const double b = time_of(cell_at(cells, Course::orthogonal, "teb", length, limit));
        const double c = time_of(cell_at(cells, Course::diagonal, "teb", length, limit));
        return std::isfinite(b) && std::isfinite(c) ? std::optional{c > b} : std::nullopt;
      }));
  lines.push_back(slow_against_fast(
      "\"TEB lets the other vessel pass first\" in B and in C", [&](double length, double limit) {
        const double b =
            cell_at(cells, Course::orthogonal, "teb", length, limit).value(0, "ahead_of_vessel_m");
        const double c = cell_at(cells, Course::diagonal, "teb", length, limit).value(0, "ahead_of_vessel_m");
        return std::isfinite(b) && std::isfinite(c) ? std::optional{b < 0.0 && c < 0.0} : std::nullopt;
      }));
  return lines;
}

json scale_table(const std::vector<Cell>& cells, const RunIndex& runs) {
  json lines = json::array();
  for (const double length : lengths) {
    for (const double limit : limits) {
      json line{{"length", length}, {"limit", limit}};
      for (const std::string_view sailor : sailors) {
        for (const Course course : timed) {
          const Cell& cell = cell_at(cells, course, sailor, length, limit);
          line[fmt::format("{}_{}", sailor, name_of(course))] = page::number(time_of(cell));
        }
        const bool touches = touches_something(cells, sailor, length, limit);
        line[fmt::format("{}_fits", sailor)] = !fits(cells, sailor, length, limit) ? ""
                                               : touches                           ? "yes, touching"
                                                                                   : "yes";
      }
      const Cell& clutter = cell_at(cells, Course::cluttered, "teb", length, limit);
      line["turned"] = page::number(clutter.value(0, "heading_change_rad"));
      line["ahead_b"] = crossing_of(cells, Course::orthogonal, length, limit);
      line["ahead_c"] = crossing_of(cells, Course::diagonal, length, limit);
      lines.push_back(runs.line(std::move(line), clutter.labels(), "navigation_time_s"));
    }
  }
  const auto number = [](const char* key, const char* label, const char* unit, int digits) {
    return json{{"key", key}, {"label", label}, {"unit", unit}, {"type", "number"}, {"digits", digits}};
  };
  const auto text = [](const char* key, const char* label) {
    return json{{"key", key}, {"label", label}, {"type", "text"}};
  };
  return {{"kind", "table"},
          {"title", "Times of arrival by the length of the course and the speed limit"},
          {"columns",
           {number("length", "Length", "m", 0), number("limit", "Limit", "m/s", 2),
            number("teb_cluttered", "TEB, clutter", "s", 1), number("teb_orthogonal", "B", "s", 1),
            number("teb_diagonal", "C", "s", 1), text("teb_fits", "All as printed"),
            number("avoa_cluttered", "AVOA, clutter", "s", 1), number("avoa_orthogonal", "B", "s", 1),
            number("avoa_diagonal", "C", "s", 1), text("avoa_fits", "All as printed"),
            number("turned", "TEB turns, clutter", "rad", 1), number("ahead_b", "TEB ahead, B", "m", 1),
            number("ahead_c", "TEB ahead, C", "m", 1)}},
          {"rows", std::move(lines)},
          {"filter", {"length", "limit"}},
          {"note",
           "Printed: TEB 71, 64, 70 s, AVOA 25, 27, 22 s. Ahead: of the other vessel's centre as its way is "
           "crossed; negative is astern. A row leads to TEB's run through the clutter."}};
}

}  // namespace fairway::surface
