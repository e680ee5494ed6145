// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/study_runs.hpp"
#include "fairway/studies/uuv/plan.hpp"

namespace fairway::uuv {
namespace {

using nlohmann::json;

constexpr double millimetres = 1000.0;

/// What the paper's figures show.
std::vector<double> shown_times(Encounter encounter) {
  if (encounter == Encounter::head_on) return {10.0, 12.0, 13.0, 20.0};
  return {7.0, 9.0, 11.0, 20.0};
}

/// One vehicle's way, ten times a second.
struct Wake {
  page::Way way{millimetres};
  std::vector<double> speed;

  /// Where it was at a time, or at the end if it had ended.
  std::array<double, 3> place_at(double time) const {
    const std::vector<double>& t = way.t();
    const auto later = std::ranges::lower_bound(t, time - 1e-6);
    const auto i = static_cast<std::size_t>(std::min(later, std::prev(t.end())) - t.begin());
    return {way.n()[i], way.e()[i], 0.0};
  }
};

class Wakes final : public FrameSink {
 public:
  explicit Wakes(std::size_t count) : wakes_(count) {}

  void write(const Frame& frame) override {
    if (count(frame.tick) % 2 != 0) return;
    for (std::size_t i = 0; i < wakes_.size(); ++i) {
      const VehicleState& x = frame.vehicles[i].state;
      wakes_[i].way.add(frame.time, {x.p_n.x(), x.p_n.y(), 0.0});
      wakes_[i].speed.push_back(page::rounded(x.v_b.norm(), millimetres));
    }
  }

  const std::vector<Wake>& all() const { return wakes_; }

 private:
  std::vector<Wake> wakes_;
};

std::vector<Wake> sailed(const Scenario& scenario) {
  Wakes wakes{scenario.vehicles.size()};
  run_into(scenario, builtin_catalogs(), sinks_of({&wakes}, {}), nullptr);
  return wakes.all();
}

/// The way of a ship, which nothing turns.
page::Way drifted(const ObstacleSpec& ship, double duration) {
  page::Way way{millimetres};
  for (int i = 0; i <= 10; ++i) {
    const double time = duration * i / 10.0;
    way.add(time, ship.position + time * ship.velocity);
  }
  return way;
}

json sphere(const std::array<double, 3>& centre, double radius, const std::string& label) {
  return {{"centre", centre}, {"radius", radius}, {"label", label}};
}

json goals_of(const Scenario& scenario) {
  json goals = json::array();
  for (const VehicleSpec& vehicle : scenario.vehicles) {
    const Vec3& goal = vehicle.mission.back().position;
    goals.push_back({goal.x(), goal.y(), goal.z()});
  }
  return goals;
}

json speeds_over_time(const std::vector<Wake>& wakes, const std::string& title) {
  json curves = json::array();
  for (std::size_t i = 0; i < wakes.size(); ++i)
    curves.push_back(page::series(fmt::format("UUV{}", i + 1), wakes[i].way.t(), wakes[i].speed));
  return page::lines(title, "time [s]", "speed [m/s]", std::move(curves));
}

Scenario as_published(Encounter encounter, const Setting& setting, const Method& method,
                      const Overrides& overrides) {
  return under(overrides,
               encounter_scenario(encounter, meeting_of(encounter), setting, hull_of(method), method, 1));
}

}  // namespace

std::vector<json> redrawn(Encounter encounter, const Setting& setting, const std::string& title,
                          const Overrides& overrides, const RunIndex& runs) {
  const Method& rvo = planar_methods().front();
  const Scenario scenario = as_published(encounter, setting, rvo, overrides);
  const json run = runs.run_of(published_labels(encounter, setting, hull_of(rvo), rvo), 1);
  const std::vector<Wake> wakes = sailed(scenario);
  const double end = wakes.front().way.t().back();
  json tracks = json::array();
  json spheres = json::array();
  for (std::size_t i = 0; i < wakes.size(); ++i) {
    tracks.push_back(wakes[i].way.track(fmt::format("UUV{}", i + 1)));
    for (const double time : shown_times(encounter)) {
      spheres.push_back(sphere(wakes[i].place_at(time), setting.uuv_radius_m,
                               fmt::format("UUV{} at {:.0f} s", i + 1, time)));
    }
  }
  for (std::size_t i = 0; i < scenario.obstacles.size(); ++i) {
    const ObstacleSpec& ship = scenario.obstacles[i];
    tracks.push_back(drifted(ship, end).track(fmt::format("ship {}", i + 1)));
    for (const double time : shown_times(encounter)) {
      const Vec3 place = ship.position + time * ship.velocity;
      spheres.push_back(
          sphere({place.x(), place.y(), 0.0}, ship.radius, fmt::format("ship {} at {:.0f} s", i + 1, time)));
    }
  }
  json ways{{"kind", "trajectories"},
            {"title", title},
            {"vehicles", std::move(tracks)},
            {"goals", goals_of(scenario)},
            {"spheres", std::move(spheres)}};
  return {page::linked(std::move(ways), run, {}),
          page::linked(speeds_over_time(wakes, "Speeds: " + title), run, {})};
}

json ways_of(Encounter encounter, std::span<const std::string_view> methods, const std::string& title,
             const Overrides& overrides, const RunIndex& runs) {
  json tracks = json::array();
  json goals = json::array();
  for (const std::string_view name : methods) {
    const Method& method = *std::ranges::find(planar_methods(), name, &Method::name);
    const Setting& common = find_setting("common");
    const Scenario scenario = as_published(encounter, common, method, overrides);
    const Labels cell = published_labels(encounter, common, hull_of(method), method);
    tracks.push_back(page::linked(sailed(scenario).front().way.track(name), runs.run_of(cell, 1), {}));
    goals = goals_of(scenario);
  }
  return {{"kind", "trajectories"},
          {"title", title},
          {"vehicles", std::move(tracks)},
          {"goals", std::move(goals)}};
}

}  // namespace fairway::uuv
