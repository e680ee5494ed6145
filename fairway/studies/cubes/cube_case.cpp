// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/cube_case.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/studies/cubes/published.hpp"

namespace fairway::cubes {
namespace {

constexpr std::array cases{
    CubeCase{"cube20_4", 10, 4, false},        CubeCase{"cube20_8", 10, 8, false},
    CubeCase{"cube20_8_retuned", 10, 8, true}, CubeCase{"cube60_4", 30, 4, false},
    CubeCase{"cube60_8", 30, 8, false},        CubeCase{"cube60_8_retuned", 30, 8, true},
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

Choice avoider_of(const Method& method, Code code, const Tuning& tuning, const ParamValues& heard) {
  Choice choice{.name = std::string(method.algorithm), .path = "avoider"};
  if (is_as_coded(code)) {
    choice.name += "_as_coded";
    if (const auto wrapper = choice.name.find('+'); wrapper != std::string::npos)
      choice.name.insert(wrapper, "_as_coded");
  }
  if (!heard.empty()) choice.name += "+as_heard";

  const bool orca = is_orca(method.algorithm);
  choice.params = {{"crit_dist_m", tuning.crit_dist_m}};
  if (!orca) choice.params.emplace_back("w2_ratio", tuning.w2_ratio);
  if (orca) choice.params.emplace_back("time_horizon_s", tuning.time_horizon_s);
  if (orca && is_as_coded(code)) choice.params.emplace_back("time_step_s", tuning.time_step_s);
  choice.params = merged(choice.params, merged(method.params, heard));
  return choice;
}

/// A robot where its distance to the goal puts it as the crossing begins: under the diagonal on which it went
/// out, a little below the surface or as deep as the tolerance lets it stop, facing outward, at rest.
void put_at_recorded_start(VehicleSpec& vehicle, const CubeCase& cube, Rng& chance) {
  constexpr double afloat = 0.3;  // [m]
  const Vertex& vertex = vertices[vehicle.id];
  const PublishedMean start = recorded_start(cube, vehicle.id);
  const double h = cube.half_edge_m;
  const double depth = vertex.deep ? 2 * h - goto_tolerance + afloat : afloat;
  const double rise = (vertex.deep ? 0.0 : 2 * h) - depth;
  const double distance = start.mean + start.deviation * chance.normal();
  const double out = std::sqrt((distance * distance - rise * rise) / 2) - h;
  vehicle.position = {out * vertex.north, out * vertex.east, depth};
  vehicle.yaw = math::atan2(vertex.east, vertex.north);
  vehicle.start_delay_s = chance.uniform(0.0, 0.1);
  vehicle.mission.erase(vehicle.mission.begin(), vehicle.mission.end() - 1);
}

}  // namespace

std::span<const CubeCase> comparison_cases() { return cases; }

std::span<const Method> methods() {
  static const std::array all{Method{"apf", "apf", {}}, Method{"orca3d", "orca3d", {}},
                              Method{"apf+saw", "apf+stop_and_wait", {}},
                              Method{"orca3d+saw", "orca3d+stop_and_wait", {}}};
  return all;
}

std::string_view name_of(Code code) {
  constexpr std::array names{"as_coded",        "as_coded_north",  "as_coded_replicas",
                             "as_coded_starts", "as_coded_timing", "as_coded_starts_timing",
                             "corrected",       "corrected_told"};
  return names[static_cast<std::size_t>(code)];
}

Tuning comparison_tuning(const CubeCase& cube, const Method& method) {
  if (is_orca(method.algorithm))
    return {.crit_dist_m = 20, .ori_error_rad = 0.6, .time_step_s = cube.retuned ? 0.5 : 1.0};
  return {.crit_dist_m = cube.retuned ? 7.0 : 6.0, .ori_error_rad = 0.8};
}

Scenario cube_scenario(const CubeCase& cube, const Method& method, Code code, const Tuning& tuning,
                       std::uint64_t seed, const ParamValues& heard) {
  const double diagonal = 2 * cube.half_edge_m * std::sqrt(3.0);
  Scenario scenario{
      .name = std::string(cube.name) + " " + std::string(method.name) + " " + std::string(name_of(code)),
      .summary = "raja2024: cross a cube to the opposite vertex",
      .step_s = 0.05,
      .duration_s = (time_coefficient + 2) * diagonal / speed,
      .seed = seed,
      .coincident_start = !is_from_recorded_starts(code),
      .exam = {.crit_dist_m = tuning.crit_dist_m,
               .safety_distance_m = safety_radius,
               .time_coefficient_ratio = time_coefficient}};

  // what the published runs left to chance
  Rng chance = Rng{seed}.stream("deployment");
  Rng starts = Rng{seed}.stream("recorded starts");
  for (std::size_t i = 0; i < cube.team; ++i) {
    const auto id = static_cast<std::uint32_t>(i);
    VehicleSpec vehicle{.id = id,
                        .name = "robot" + std::to_string(id),
                        .model = Choice{.name = "sparus2", .path = "model"},
                        .avoider = avoider_of(method, code, tuning, heard),
                        .steering = Choice{.name = "turn_then_go",
                                           .params = {{"ori_error_rad", tuning.ori_error_rad}},
                                           .path = "steering"},
                        .yaw = chance.uniform(-pi, pi) * (code == Code::as_coded_north ? 0.0 : 1.0),
                        .start_delay_s = chance.uniform(0.0, 5.0),
                        .radius_m = tuning.radius_m,
                        .priority = static_cast<std::int32_t>(i),
                        .mission = mission_of(vertices[i], cube.half_edge_m)};
    if (is_orca(method.algorithm)) vehicle.limits.max_speed = speed;
    if (is_from_recorded_starts(code)) put_at_recorded_start(vehicle, cube, starts);
    scenario.vehicles.push_back(std::move(vehicle));
  }
  return scenario;
}

}  // namespace fairway::cubes
