// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/cube_case.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::cubes {
namespace {

constexpr std::array cases{
    CubeCase{"cube20_4", 10, 4, false},        CubeCase{"cube20_8", 10, 8, false},
    CubeCase{"cube20_8_retuned", 10, 8, true}, CubeCase{"cube60_4", 30, 4, false},
    CubeCase{"cube60_8", 30, 8, false},        CubeCase{"cube60_8_retuned", 30, 8, true},
};

constexpr std::array all_methods{
    Method{"apf", false, false},
    Method{"orca3d", true, false},
    Method{"apf+saw", false, true},
    Method{"orca3d+saw", true, true},
};

/// Means over robots and five runs, from the published result files; the counts are totals.
struct PublishedCell {
  std::string_view cube;
  std::string_view method;
  double navigation_time_s, avoidance_time_s, avoided_count, distance_m, collision_count, stuck_count;
};

constexpr std::array published_cells{
    PublishedCell{"cube20_4", "apf", 79.6, 13.5, 2.9, 38.2, 0, 0},
    PublishedCell{"cube20_4", "orca3d", 77.6, 72.3, 3.0, 30.4, 0, 0},
    PublishedCell{"cube20_4", "apf+saw", 116.5, 46.7, 7.5, 45.8, 0, 0},
    PublishedCell{"cube20_4", "orca3d+saw", 144.8, 141.3, 3.1, 28.7, 0, 0},
    PublishedCell{"cube20_8", "apf", 151.7, 65.6, 15.9, 69.7, 6, 0},
    PublishedCell{"cube20_8", "orca3d", 116.5, 116.6, 7.0, 40.0, 4, 0},
    PublishedCell{"cube20_8", "apf+saw", 217.9, 129.5, 26.2, 70.0, 0, 0},
    PublishedCell{"cube20_8", "orca3d+saw", 371.0, 371.0, 8.2, 33.8, 0, 4},
    PublishedCell{"cube20_8_retuned", "apf", 176.6, 82.7, 20.9, 80.0, 0, 0},
    PublishedCell{"cube20_8_retuned", "orca3d", 131.9, 132.0, 7.1, 42.7, 0, 0},
    PublishedCell{"cube20_8_retuned", "apf+saw", 397.4, 275.8, 51.5, 112.1, 0, 0},
    PublishedCell{"cube20_8_retuned", "orca3d+saw", 322.5, 322.5, 8.9, 34.9, 0, 0},
    PublishedCell{"cube60_4", "apf", 218.9, 23.3, 5.5, 114.6, 0, 0},
    PublishedCell{"cube60_4", "orca3d", 227.4, 80.3, 3.0, 103.1, 0, 0},
    PublishedCell{"cube60_4", "apf+saw", 213.1, 19.5, 3.5, 107.8, 0, 0},
    PublishedCell{"cube60_4", "orca3d+saw", 303.9, 141.0, 3.6, 101.5, 0, 0},
    PublishedCell{"cube60_8", "apf", 311.0, 86.4, 22.8, 153.7, 8, 0},
    PublishedCell{"cube60_8", "orca3d", 255.3, 124.5, 6.9, 107.3, 4, 0},
    PublishedCell{"cube60_8", "apf+saw", 359.6, 131.0, 29.1, 150.2, 0, 0},
    PublishedCell{"cube60_8", "orca3d+saw", 470.6, 340.5, 10.3, 105.3, 0, 0},
    PublishedCell{"cube60_8_retuned", "apf", 319.6, 92.9, 23.2, 158.2, 0, 0},
    PublishedCell{"cube60_8_retuned", "orca3d", 260.4, 130.7, 7.1, 108.2, 0, 0},
    PublishedCell{"cube60_8_retuned", "apf+saw", 400.1, 163.2, 35.6, 160.2, 0, 0},
    PublishedCell{"cube60_8_retuned", "orca3d+saw", 478.0, 348.0, 10.3, 105.4, 0, 0},
};

/// The vertex a robot starts from, in units of h: north, east, and whether it is deep.
struct Vertex {
  double north, east;
  bool deep;
};
constexpr std::array<Vertex, 8> vertices{{{+1, +1, false},
                                          {-1, -1, false},
                                          {+1, -1, true},
                                          {-1, +1, true},
                                          {-1, -1, true},
                                          {+1, +1, true},
                                          {-1, +1, false},
                                          {+1, -1, false}}};

constexpr double speed = 0.5;           // DES_VEL, GOTO_VEL [m/s]
constexpr double safety_radius = 3.0;   // [m]
constexpr double goto_tolerance = 5.0;  // per axis [m]
constexpr double time_coefficient = 10;

std::vector<Leg> mission_of(const Vertex& vertex, double h) {
  const Vec3 start{h * vertex.north, h * vertex.east, vertex.deep ? 2 * h : 0.0};
  const Vec3 goal{-h * vertex.north, -h * vertex.east, vertex.deep ? 0.0 : 2 * h};
  return {{.kind = LegKind::go_to,
           .position = start,
           .speed_mps = speed,
           .box_m = Vec3::Constant(goto_tolerance)},
          {.kind = LegKind::rendezvous},
          {.kind = LegKind::transit, .position = goal, .speed_mps = speed, .arrival_m = safety_radius}};
}

Choice avoider_of(const Method& method, Code code, const Tuning& tuning) {
  Choice choice{
      .name =
          std::string(method.orca ? "orca3d" : "apf") + (is_as_coded(code) ? "_as_coded" : "") +
          (method.stop_and_wait ? (is_as_coded(code) ? "+stop_and_wait_as_coded" : "+stop_and_wait") : ""),
      .path = "avoider"};
  choice.params = {{"crit_dist_m", tuning.crit_dist_m}};
  if (!method.orca) choice.params.emplace_back("w2_ratio", tuning.w2_ratio);
  if (method.orca) choice.params.emplace_back("time_horizon_s", tuning.time_horizon_s);
  if (method.orca && is_as_coded(code)) choice.params.emplace_back("time_step_s", tuning.time_step_s);
  return choice;
}

}  // namespace

std::span<const CubeCase> comparison_cases() { return cases; }
std::span<const Method> methods() { return all_methods; }

std::string_view name_of(Code code) {
  constexpr std::array names{"as_coded", "as_coded_north", "corrected"};
  return names[static_cast<std::size_t>(code)];
}

Tuning comparison_tuning(const CubeCase& cube, const Method& method) {
  if (method.orca) return {.crit_dist_m = 20, .ori_error_rad = 0.6, .time_step_s = cube.retuned ? 0.5 : 1.0};
  return {.crit_dist_m = cube.retuned ? 7.0 : 6.0, .ori_error_rad = 0.8};
}

std::optional<double> published(std::string_view cube, std::string_view method, std::string_view quantity) {
  for (const PublishedCell& cell : published_cells) {
    if (cell.cube != cube || cell.method != method) continue;
    if (quantity == "navigation_time_s") return cell.navigation_time_s;
    if (quantity == "avoidance_time_s") return cell.avoidance_time_s;
    if (quantity == "avoided_count") return cell.avoided_count;
    if (quantity == "distance_m") return cell.distance_m;
    if (quantity == "collision_count") return cell.collision_count;
    if (quantity == "stuck_count") return cell.stuck_count;
  }
  return std::nullopt;
}

Scenario cube_scenario(const CubeCase& cube, const Method& method, Code code, const Tuning& tuning,
                       std::uint64_t seed) {
  const double diagonal = 2 * cube.half_edge_m * std::sqrt(3.0);
  Scenario scenario{
      .name = std::string(cube.name) + " " + std::string(method.name) + " " + std::string(name_of(code)),
      .summary = "raja2024: cross a cube to the opposite vertex",
      .step_s = 0.05,
      .duration_s = (time_coefficient + 2) * diagonal / speed,
      .seed = seed,
      .coincident_start = true,
      .exam = {.crit_dist_m = tuning.crit_dist_m,
               .safety_distance_m = safety_radius,
               .time_coefficient_ratio = time_coefficient}};

  // what the published runs left to chance
  Rng chance = Rng{seed}.stream("deployment");
  for (std::size_t i = 0; i < cube.team; ++i) {
    const auto id = static_cast<std::uint32_t>(i);
    VehicleSpec vehicle{.id = id,
                        .name = "robot" + std::to_string(id),
                        .model = {.name = "sparus2", .path = "model"},
                        .avoider = avoider_of(method, code, tuning),
                        .steering = {.name = "turn_then_go",
                                     .params = {{"ori_error_rad", tuning.ori_error_rad}},
                                     .path = "steering"},
                        .yaw = chance.uniform(-pi, pi) * (code == Code::as_coded_north ? 0.0 : 1.0),
                        .start_delay_s = chance.uniform(0.0, 5.0),
                        .radius_m = safety_radius,
                        .priority = static_cast<std::int32_t>(i),
                        .mission = mission_of(vertices[i], cube.half_edge_m)};
    if (method.orca) vehicle.limits.max_speed = speed;
    scenario.vehicles.push_back(std::move(vehicle));
  }
  return scenario;
}

}  // namespace fairway::cubes
