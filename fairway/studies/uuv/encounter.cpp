// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/encounter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fairway/core/rng.hpp"
#include "fairway/studies/disc.hpp"

namespace fairway::uuv {
namespace {

constexpr double duration = 60.0;   // [s]
constexpr double max_speed = 10.0;  // [m/s], as published
constexpr double ship_speed = 6.0;  // [m/s], likewise

constexpr std::array known_settings{
    Setting{"fit_head_on", 6.8, 1.0, 0.0, 1.5, 1.5, 2.0}, Setting{"fit_ships", 6.0, 2.0, 6.0, 2.0, 3.0, 2.0},
    Setting{"literal", 7.07, 0.8, 0.0, 1.0, 1.0, 4.0},    Setting{"common", 6.0, 2.0, 6.0, 1.5, 2.0, 2.0},
    Setting{"common_3s", 6.0, 2.0, 6.0, 1.5, 2.0, 3.0},   Setting{"from_rest", 6.0, 2.0, 0.0, 1.5, 2.0, 3.0},
    Setting{"slower", 6.5, 1.0, 0.0, 1.0, 1.0, 4.0},      Setting{"top_speed", 10.0, 1.0, 0.0, 2.5, 2.5, 6.0},
    Setting{"short", 7.07, 1.0, 0.0, 1.0, 1.0, 2.0}};

/// A point of the paper, whose x is east and y north.
Vec3 place(double x, double y) { return {y, x, 0.0}; }

Vec3 anywhere_near(const Vec3& at, double reach, Rng& rng) {
  const double n = rng.uniform(-reach, reach);
  return at + Vec3{n, rng.uniform(-reach, reach), 0.0};
}

/// Whoever is within the horizon is within this range.
constexpr double sight = 1000.0;  // [m]

ParamValues params_of(const Method& method, const Setting& setting) {
  ParamValues params = method.params;
  const auto begins = [&](std::string_view name) { return method.algorithm.starts_with(name); };
  if (std::ranges::any_of(std::array{"vo", "rvo", "hrvo", "orca"}, begins)) {
    params.emplace_back("time_horizon_s", setting.time_horizon_s);
    params.emplace_back("crit_dist_m", sight);
  }
  return params;
}

Agility agility_of(const Setting& setting) {
  return {.speed_mps = max_speed,
          .acceleration_mps2 = setting.acceleration_mps2,
          .turn_acceleration_radps2 = 100.0,
          .time_constant_s = 0.05};
}

VehicleSpec meeting_uuv(const Meeting& meeting, std::size_t index, const Setting& setting, Hull hull,
                        const Method& method) {
  VehicleSpec uuv = uuv_of(index, meeting.starts[index], meeting.goals[index], setting.speed_mps, hull,
                           agility_of(setting));
  uuv.avoider =
      Choice{.name = std::string(method.algorithm), .params = params_of(method, setting), .path = "avoider"};
  uuv.speed = setting.start_speed_mps;
  uuv.start_delay_s = meeting.start_delays_s[index];
  uuv.radius_m = setting.uuv_radius_m;
  return uuv;
}

}  // namespace

std::string_view name_of(Encounter encounter) {
  constexpr std::array names{"head_on", "multi_obstacle", "parallel_goals"};
  return names[static_cast<std::size_t>(encounter)];
}

std::span<const Setting> settings() { return known_settings; }

const Setting& find_setting(std::string_view name) {
  const auto found = std::ranges::find(known_settings, name, &Setting::name);
  if (found == known_settings.end()) throw std::out_of_range("no setting " + std::string(name));
  return *found;
}

Hull hull_of(const Method& method) {
  const bool by_heading =
      method.algorithm.starts_with("avoa") || method.algorithm.starts_with("wall_following");
  return by_heading ? Hull::unicycle : Hull::point;
}

std::span<const Method> planar_methods() {
  static const ParamValues fast{{"window_s", 4.0},
                                {"thruster_speed_mps", max_speed},
                                {"beta_m", 7.5},
                                {"turn_gain_hz", 2.0},
                                {"least_speed_mps", 1.3},
                                {"danger_threshold_mps", 2.0},
                                {"max_speed_mps", max_speed},
                                {"max_turn_rate_radps", 1.0}};
  static const std::vector<Method> methods{
      {"rvo", "rvo", {}},
      {"vo", "vo", {}},
      {"hrvo", "hrvo", {}},
      {"orca2d", "orca2d", {}},
      {"orca3d", "orca3d", {}},
      {"apf", "apf", {{"crit_dist_m", 20.0}}},
      {"avoa", "avoa", fast},
      {"avoa_improved", "avoa_improved", {{"turn_gain_hz", 2.0}, {"response_s", 0.1}}},
      {"orca3d+stop_and_wait", "orca3d+stop_and_wait", {}},
      {"direct+filter", "direct+safety_filter", {}},
      {"wall_following", "wall_following", {{"form", std::string("corrected")}}},
      {"direct", "direct", {}},
  };
  return methods;
}

Meeting meeting_of(Encounter encounter) {
  if (encounter == Encounter::head_on) {
    const Vec3 p1 = place(20.0, 20.0);
    const Vec3 p2 = place(100.0, 100.0);
    return {.starts = {p1, p2}, .goals = {p2, p1}};
  }
  const Vec3 one = place(100.0, 80.0);
  const Vec3 other = place(80.0, 100.0);
  Meeting meeting{.starts = {place(0.0, 20.0), place(20.0, 0.0)}, .goals = {one, other}};
  if (encounter == Encounter::parallel_goals) std::swap(meeting.goals[0], meeting.goals[1]);
  meeting.ships = {place(20.0, 80.0), place(15.0, 90.0), place(10.0, 85.0)};
  meeting.ship_velocity = ship_speed * std::sqrt(0.5) * place(1.0, -1.0);
  return meeting;
}

Meeting varied(Encounter encounter, std::uint64_t seed) {
  Meeting meeting = meeting_of(encounter);
  Rng rng = Rng{seed}.stream(name_of(encounter));
  for (Vec3& start : meeting.starts) start = anywhere_near(start, 2.0, rng);
  for (double& delay : meeting.start_delays_s) delay = rng.uniform(0.0, 1.0);
  for (Vec3& ship : meeting.ships) ship = anywhere_near(ship, 2.0, rng);
  const double speed_ratio = rng.uniform(0.9, 1.1);
  meeting.ship_velocity.head<2>() = turned(meeting.ship_velocity.head<2>(), rng.uniform(-0.1, 0.1));
  meeting.ship_velocity *= speed_ratio;
  return meeting;
}

Scenario encounter_scenario(Encounter encounter, const Meeting& meeting, const Setting& setting, Hull hull,
                            const Method& method, std::uint64_t seed) {
  Scenario scenario{.name = std::string(name_of(encounter)), .duration_s = duration, .seed = seed};
  scenario.steps_per_decision = 2;
  scenario.exam = {
      .crit_dist_m = 20.0, .safety_distance_m = 2.0 * setting.uuv_radius_m, .time_coefficient_ratio = 1e6};
  for (const Vec3& ship : meeting.ships)
    scenario.obstacles.push_back(disc(ship, setting.ship_radius_m, meeting.ship_velocity));
  for (std::size_t i = 0; i < meeting.starts.size(); ++i)
    scenario.vehicles.push_back(meeting_uuv(meeting, i, setting, hull, method));
  return scenario;
}

}  // namespace fairway::uuv
