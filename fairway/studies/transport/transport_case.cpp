// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/transport_case.hpp"

#include <fmt/format.h>

#include "fairway/studies/disc.hpp"
#include "fairway/studies/transport/field.hpp"

namespace fairway::transport {
namespace {

/// Table 6 and the gains printed with it; Tables 1 and 2 are the methods' defaults.
ParamValues four_obstacle_gains() {
  return {{"sensor_range_m", 1.0},      {"goal_gain_hz", 0.1},        {"wall_gain_hz", 1.0},
          {"alpha_ratio", 1.0},         {"goal_surge_kp_kgps", 20.0}, {"goal_surge_kd_kg", 50.0},
          {"goal_sway_kp_kgps", 30.0},  {"goal_sway_kd_kg", 100.0},   {"goal_yaw_kp_nmprad", 5.0},
          {"goal_yaw_kd_kgm2ps", 0.0},  {"wall_surge_kp_kgps", 20.0}, {"wall_surge_kd_kg", 5.0},
          {"wall_sway_kp_kgps", 100.0}, {"wall_sway_kd_kg", 5.0},     {"wall_yaw_kp_nmprad", 5.0},
          {"wall_yaw_kd_kgm2ps", 0.0}};
}

/// Table 7 with 28 s a segment, under the PID control of Table 8, which is the method's default.
ParamValues printed_trajectory() {
  constexpr std::array<std::array<double, 2>, 11> table_7{{{0, 0},
                                                           {4.2, 2.4},
                                                           {5.3, 6.9},
                                                           {2.7, 11.2},
                                                           {3, 16},
                                                           {6.2, 19.7},
                                                           {9.6, 23.4},
                                                           {13.2, 26.8},
                                                           {14.6, 31.6},
                                                           {17.9, 34.9},
                                                           {22, 35}}};
  ParamValues params{{"feed_forward", false},
                     {"clearance_m", 0.0},
                     {"segment_time_s", 28.0},
                     {"waypoints", 1.0 * table_7.size()}};
  for (std::size_t i = 0; i < table_7.size(); ++i) {
    params.emplace_back(fmt::format("waypoints[{}].n_m", i), table_7[i][0]);
    params.emplace_back(fmt::format("waypoints[{}].e_m", i), table_7[i][1]);
  }
  return params;
}

struct PublishedValue {
  Case which;
  std::string_view method;
  std::string_view quantity;
  double value;
};

// Tables 3, 4, 9 and 10 and the numbers of the text
constexpr std::array published_values{
    PublishedValue{Case::one_obstacle, "hard_switching", "initial_surge_force_n", 130},
    PublishedValue{Case::one_obstacle, "hard_switching", "initial_sway_force_n", 129},
    PublishedValue{Case::one_obstacle, "hard_switching", "peak_yaw_moment_nm", 313},
    PublishedValue{Case::one_obstacle, "hard_switching", "displacement_m", 141.8},
    PublishedValue{Case::one_obstacle, "hard_switching", "goal_time_s", 500},
    PublishedValue{Case::one_obstacle, "hard_switching", "rms_surge_power_w", 41.08},
    PublishedValue{Case::one_obstacle, "hard_switching", "rms_sway_power_w", 21.22},
    PublishedValue{Case::one_obstacle, "hard_switching", "rms_yaw_power_w", 88.98},
    PublishedValue{Case::one_obstacle, "hard_switching", "net_power_w", 151.28},
    PublishedValue{Case::one_obstacle, "hard_switching", "switch_distance_m", 25},
    PublishedValue{Case::one_obstacle, "wall_following", "initial_surge_force_n", 150},
    PublishedValue{Case::one_obstacle, "wall_following", "initial_sway_force_n", 250},
    PublishedValue{Case::one_obstacle, "wall_following", "detection_1_surge_force_n", -54},
    PublishedValue{Case::one_obstacle, "wall_following", "peak_surge_force_n", 187},
    PublishedValue{Case::one_obstacle, "wall_following", "peak_sway_force_n", 487},
    PublishedValue{Case::one_obstacle, "wall_following", "peak_yaw_moment_nm", 0},
    PublishedValue{Case::one_obstacle, "wall_following", "displacement_m", 141.2},
    PublishedValue{Case::one_obstacle, "wall_following", "goal_time_s", 350},
    PublishedValue{Case::one_obstacle, "wall_following", "rms_surge_power_w", 29.84},
    PublishedValue{Case::one_obstacle, "wall_following", "rms_sway_power_w", 57.50},
    PublishedValue{Case::one_obstacle, "wall_following", "rms_yaw_power_w", 0},
    PublishedValue{Case::one_obstacle, "wall_following", "net_power_w", 87.34},
    PublishedValue{Case::one_obstacle, "wall_following", "switch_distance_m", 25},
    PublishedValue{Case::four_obstacles, "wall_following", "detection_1_surge_force_n", -29},
    PublishedValue{Case::four_obstacles, "wall_following", "detection_1_sway_force_n", 441},
    PublishedValue{Case::four_obstacles, "wall_following", "detection_3_surge_force_n", 93},
    PublishedValue{Case::four_obstacles, "wall_following", "detection_3_sway_force_n", 154},
    PublishedValue{Case::four_obstacles, "wall_following", "detection_4_surge_force_n", 52},
    PublishedValue{Case::four_obstacles, "wall_following", "detection_4_sway_force_n", 4},
    PublishedValue{Case::four_obstacles, "wall_following", "rms_surge_power_w", 1.64},
    PublishedValue{Case::four_obstacles, "wall_following", "rms_sway_power_w", 5.77},
    PublishedValue{Case::four_obstacles, "wall_following", "net_power_w", 7.41},
    PublishedValue{Case::four_obstacles, "wall_following", "switch_distance_m", 2},
    PublishedValue{Case::four_obstacles, "rrt_star", "rmse_north_m", 0.7},
    PublishedValue{Case::four_obstacles, "rrt_star", "rmse_east_m", 0.9},
    PublishedValue{Case::four_obstacles, "rrt_star", "rms_surge_power_w", 1.35},
    PublishedValue{Case::four_obstacles, "rrt_star", "rms_sway_power_w", 3.25},
    PublishedValue{Case::four_obstacles, "rrt_star", "net_power_w", 4.6},
};

VehicleSpec transport_system(const Method& method, Plant plant, const Vec3& goal) {
  VehicleSpec vehicle{.name = "transport"};
  vehicle.model = Choice{.name = "minerva_transport",
                         .params = {{"plant", std::string(name_of(plant))}},
                         .path = "vehicles[0].model"};
  vehicle.avoider =
      Choice{.name = std::string(method.algorithm), .params = method.params, .path = "vehicles[0].avoider"};
  vehicle.radius_m = footprint_radius;
  vehicle.mission = {{.kind = LegKind::transit, .position = goal, .speed_mps = 0.5}};
  return vehicle;
}

}  // namespace

std::string_view name_of(Plant plant) { return plant == Plant::physical ? "physical" : "paper_compat"; }

std::string_view name_of(Case which) {
  constexpr std::array names{"one_obstacle", "four_obstacles", "unknown_obstacle"};
  return names[static_cast<std::size_t>(which)];
}

std::span<const PublishedRun> published_runs() {
  static const std::array runs{
      PublishedRun{Case::one_obstacle, {"hard_switching", "hard_switching", {}}, 500.0},
      PublishedRun{Case::one_obstacle, {"wall_following", "wall_following", {}}, 350.0},
      PublishedRun{Case::four_obstacles, {"wall_following", "wall_following", four_obstacle_gains()}, 400.0},
      PublishedRun{Case::four_obstacles, {"rrt_star", "rrt_star", printed_trajectory()}, 300.0}};
  return runs;
}

std::optional<double> published(Case which, std::string_view method, std::string_view quantity) {
  for (const PublishedValue& value : published_values) {
    if (value.which == which && value.method == method && value.quantity == quantity) return value.value;
  }
  return {};
}

std::vector<ObstacleSpec> obstacles_of(Case which) {
  if (which == Case::one_obstacle) return {disc({50, 40, 0}, 20)};
  std::vector<ObstacleSpec> table_5{disc({10, 12, 0}, 1), disc({20, 20, 0}, 1), disc({10, 33, 0}, 1),
                                    disc({20, 30, 0}, 1)};
  if (which != Case::unknown_obstacle) return table_5;
  table_5.push_back(disc({8, 21.5, 0}, 1));
  table_5.back().charted = false;
  return table_5;
}

Vec3 goal_of(Case which) {
  return which == Case::one_obstacle ? Vec3{100.0, 100.0, 0.0} : Vec3{22.0, 35.0, 0.0};
}

Scenario scenario_of(const PublishedRun& run, Plant plant) {
  Scenario scenario{.name = fmt::format("{}_{}", name_of(run.which), run.method.name),
                    .step_s = 0.02,
                    .duration_s = run.duration_s,
                    .stop_when_done = false};
  scenario.exam.time_coefficient_ratio = 1e6;
  scenario.obstacles = obstacles_of(run.which);
  VehicleSpec vehicle = transport_system(run.method, plant, goal_of(run.which));
  vehicle.allocation = Choice{.name = "pseudo_inverse", .path = "vehicles[0].allocation"};
  vehicle.mission.front().arrival_m = 1e-9;
  scenario.vehicles = {vehicle};
  return scenario;
}

Scenario voyage(std::string_view name, const Method& method, std::vector<ObstacleSpec> obstacles,
                const Vec3& goal, double duration_s, std::uint64_t seed) {
  Scenario scenario{.name = std::string(name), .duration_s = duration_s, .seed = seed};
  scenario.exam.time_coefficient_ratio = 1e6;
  scenario.perception.obstacle_range_m = 5.0;
  scenario.obstacles = std::move(obstacles);
  VehicleSpec vehicle = transport_system(method, Plant::physical, goal);
  vehicle.limits.max_speed = 0.5;
  scenario.vehicles = {vehicle};
  return scenario;
}

Scenario case_voyage(Case which, const Method& method) {
  return voyage(name_of(which), method, obstacles_of(which), goal_of(which), voyage_duration, 1);
}

}  // namespace fairway::transport
