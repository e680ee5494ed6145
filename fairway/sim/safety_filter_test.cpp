// SPDX-License-Identifier: Apache-2.0
// safety_filter in the loop of five vehicles, among spheres that it learns of by the chart.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

/// A vehicle and the field that it crosses: ten spheres in a current, on a way of 50 m times `scale`.
struct FilteredVehicle {
  std::string model;
  double scale;     ///< of the field
  double radius;    ///< of own sphere [m]
  double depth;     ///< [m]
  double speed;     ///< wanted, and at the start [m/s]
  double current;   ///< at most, along each axis [m/s]
  double duration;  ///< four times the straight way, or more [s]
  double least;     ///< what is kept to every surface at least [m]; the margin is 0.5
  int arrived;      ///< of twenty seeds; nobody shows the others a way round
};

Scenario field_of(const FilteredVehicle& of, std::uint64_t seed) {
  const auto within = [](double lo, double hi) { return fmt::format("{{uniform: [{:g}, {:g}]}}", lo, hi); };
  const std::string current = within(-of.current, of.current);
  const std::string sphere = fmt::format(
      "{{sphere: {{position_m: [{}, {}, {}], radius_m: {}}}}}", within(8 * of.scale, 42 * of.scale),
      within(-8 * of.scale, 8 * of.scale), of.depth, within(0.3 * of.scale, 1.2 * of.scale));
  std::string spheres = sphere;
  for (int i = 1; i < 10; ++i) spheres += ", " + sphere;
  return parse_scenario(
      fmt::format(
          "{{fairway: 1, name: field, duration_s: {}, steps_per_decision_count: 4, water: {{current_mps: "
          "[{}, "
          "{}, 0]}}, obstacles: [{}], vehicles: [{{model: {}, avoider: direct+safety_filter, tracking: raw, "
          "radius_m: {}, limits: {{max_speed_mps: {}, max_climb_rate_mps: 0.3}}, start: {{position_m: [0, 0, "
          "{}], speed_mps: {}}}, mission: [{{transit: {{position_m: [{}, 0, {}], speed_mps: {}, arrival_m: "
          "{}}}}}]}}]}}",
          of.duration, current, current, spheres, of.model, of.radius, 1.25 * of.speed, of.depth, of.speed,
          50.0 * of.scale, of.depth, of.speed, std::max(1.0, of.scale)),
      "field.yaml", {}, seed);
}

/// How near the only vehicle comes to a sphere, and whether it gets to the end of its way.
struct Passage final : FrameSink {
  explicit Passage(const Scenario& scenario) : field{scenario} {}
  void write(const Frame& frame) override {
    const VehicleFrame& own = frame.vehicles[0];
    for (const ObstacleSpec& each : field.obstacles)
      clearance = std::min(clearance,
                           (own.state.p_n - each.position).norm() - each.radius - field.vehicles[0].radius_m);
    arrived = own.phase == Phase::arrived;
  }

  const Scenario& field;
  double clearance{std::numeric_limits<double>::infinity()};  ///< between the surfaces [m]
  bool arrived{};
};

class SafetyFilterOn : public testing::TestWithParam<FilteredVehicle> {};

TEST_P(SafetyFilterOn, TouchesNothing) {
  const FilteredVehicle& vehicle = GetParam();
  int arrived = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Scenario scenario = field_of(vehicle, seed);
    Passage passage{scenario};
    const std::array<FrameSink*, 1> sinks{&passage};
    Simulation{scenario, builtin_catalogs()}.run(sinks);
    arrived += passage.arrived ? 1 : 0;
    least = std::min(least, passage.clearance);
  }
  EXPECT_GE(least, vehicle.least);
  EXPECT_EQ(arrived, vehicle.arrived);
}

// Measured: 0.517, 0.522, 0.620, 0.478 and 0.500 m.
INSTANTIATE_TEST_SUITE_P(
    EachOfFive, SafetyFilterOn,
    testing::Values(FilteredVehicle{"zarco", 1.0, 0.75, 0, 1.2, 0.15, 170, 0.5, 20},
                    FilteredVehicle{"otter_by_thrust", 1.2, 1.2, 0, 1.2, 0.15, 200, 0.5, 20},
                    FilteredVehicle{"remus100", 10.0, 1.0, 20, 1.5, 0.15, 1350, 0.55, 20},
                    FilteredVehicle{"sparus2", 1.0, 1.0, 5, 0.5, 0.0625, 400, 0.2, 19},
                    FilteredVehicle{"minerva_transport", 2.0, 2.7, 5, 0.5, 0.0625, 800, 0.49, 15}),
    [](const auto& info) { return info.param.model; });

}  // namespace
}  // namespace fairway
