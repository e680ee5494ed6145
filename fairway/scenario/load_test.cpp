// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view crossing = R"(fairway: 1
name: crossing
summary: two vehicles meet at right angles
step_s: 0.1
duration_s: 300
seed: 7
water: {density_kgpm3: 1025, current_mps: [0.1, -0.2, 0]}
exam: {crit_dist_m: 7, safety_distance_m: 2, time_coefficient_ratio: 5, progress_window_s: 20}
perception: {kind: acoustic, range_m: 100, drop_ratio: 0.1}
stop_when_done: false
obstacles:
  - sphere: {position_m: [50, 0, 5], radius_m: 2}
  - segment: {from_m: [60, -5, 0], to_m: [60, 5, 0]}
  - polygon: {vertices_m: [[70, 0], [80, 0], [80, 10, 3]]}
missions:
  out: [{transit: {position_m: [20, 0, 5]}}]
  circle: [{run: out}, {keep_position: {duration_s: 5}}, {transit: {position_m: [0, 0, 5], arrival_m: 2}}]
defaults:
  model: {name: sparus2, mass_kg: 52}
  avoider: {algorithm: orca3d, time_horizon_s: 5}
  radius_m: 3
  limits: {max_speed_mps: 0.5, max_climb_rate_mps: 0.2}
vehicles:
  - id: 4
    name: north
    steering: {ori_error_rad: 0.6}
    start: {position_m: [0, 0, 5], yaw_deg: 30, speed_mps: 0.1, delay_s: 2}
    limits: {max_turn_rate_degps: 10, min_depth_m: 1, max_depth_m: 90}
    mission:
      - run: circle
      - rendezvous: {}
  - avoider: apf
    model: zarco
    start: {position_m: [10, -10, 5]}
    priority_count: -3
    mission:
      - go_to: {position_m: [10, 10, 0], speed_mps: 0.7, box_m: [5, 5, 4]}
      - section: {from_m: [10, 10, 0], to_m: [20, 10, 0], arrival_m: 0.5}
expect:
  collision_count: 0
  makespan_s: {max: 120}
  min_separation_m: {min: 3, max: 50}
)";

TEST(LoadTest, EveryKeyArrivesWhereItBelongs) {
  const Scenario s = parse_scenario(crossing, "crossing.yaml");
  EXPECT_EQ(s.name, "crossing");
  EXPECT_EQ(s.summary, "two vehicles meet at right angles");
  EXPECT_EQ(s.step_s, 0.1);
  EXPECT_EQ(s.duration_s, 300.0);
  EXPECT_EQ(s.seed, 7U);
  EXPECT_EQ(s.water.density_kgpm3, 1025.0);
  EXPECT_EQ(s.water.current_n, Vec3(0.1, -0.2, 0));
  EXPECT_EQ(s.exam.crit_dist_m, 7.0);
  EXPECT_EQ(s.exam.safety_distance_m, 2.0);
  EXPECT_EQ(s.exam.time_coefficient_ratio, 5.0);
  EXPECT_EQ(s.exam.progress_window_s, 20.0);
  EXPECT_EQ(s.perception.kind.name, "acoustic");
  EXPECT_EQ(s.perception.range_m, 100.0);
  EXPECT_EQ(s.perception.kind.params, (ParamValues{{"drop_ratio", 0.1}}));
  EXPECT_FALSE(s.stop_when_done);
  EXPECT_FALSE(s.coincident_start);

  ASSERT_EQ(s.obstacles.size(), 3U);
  EXPECT_EQ(s.obstacles[0].kind, Obstacle::Kind::sphere);
  EXPECT_EQ(s.obstacles[0].radius, 2.0);
  EXPECT_EQ(s.obstacles[1].kind, Obstacle::Kind::segment);
  EXPECT_EQ(s.obstacles[1].to, Vec3(60, 5, 0));
  EXPECT_EQ(s.obstacles[2].kind, Obstacle::Kind::polygon);
  EXPECT_EQ(s.obstacles[2].vertices, (std::vector<Vec3>{{70, 0, 0}, {80, 0, 0}, {80, 10, 3}}));

  ASSERT_EQ(s.vehicles.size(), 2U);
  const VehicleSpec& north = s.vehicles[0];
  EXPECT_EQ(north.id, 4U);
  EXPECT_EQ(north.name, "north");
  EXPECT_EQ(north.priority, 4);
  EXPECT_EQ(north.model->name, "sparus2");
  EXPECT_EQ(north.model->params, (ParamValues{{"mass_kg", 52.0}}));
  EXPECT_EQ(north.avoider->name, "orca3d");
  EXPECT_EQ(north.avoider->path, "vehicles[0].avoider");
  EXPECT_EQ(north.steering->name, "");
  EXPECT_EQ(north.steering->params, (ParamValues{{"ori_error_rad", 0.6}}));
  EXPECT_EQ(north.position, Vec3(0, 0, 5));
  EXPECT_EQ(north.yaw, radians(30.0));
  EXPECT_EQ(north.speed, 0.1);
  EXPECT_EQ(north.start_delay_s, 2.0);
  EXPECT_EQ(north.radius_m, 3.0);
  EXPECT_EQ(north.limits.max_speed, 0.5) << "limits are filled from the defaults one by one";
  EXPECT_EQ(north.limits.max_turn_rate, radians(10.0));
  EXPECT_EQ(north.limits.max_acceleration, Limits::none);

  ASSERT_EQ(north.mission.size(), 4U) << "named missions are spliced, also within each other";
  EXPECT_EQ(north.mission[0].kind, LegKind::transit);
  EXPECT_EQ(north.mission[0].position, Vec3(20, 0, 5));
  EXPECT_EQ(north.mission[1].kind, LegKind::keep_position);
  EXPECT_EQ(north.mission[1].duration_s, 5.0);
  EXPECT_EQ(north.mission[2].arrival_m, 2.0);
  EXPECT_EQ(north.mission[3].kind, LegKind::rendezvous);

  const VehicleSpec& second = s.vehicles[1];
  EXPECT_EQ(second.id, 1U);
  EXPECT_EQ(second.name, "robot1");
  EXPECT_EQ(second.priority, -3);
  EXPECT_EQ(second.model->name, "zarco");
  EXPECT_TRUE(second.model->params.empty()) << "a choice that names itself takes no parameters of another";
  EXPECT_EQ(second.avoider->name, "apf");
  EXPECT_TRUE(second.avoider->params.empty());
  EXPECT_EQ(second.mission[0].box_m, Vec3(5, 5, 4));
  EXPECT_EQ(second.mission[1].from, Vec3(10, 10, 0));
  EXPECT_EQ(second.mission[1].position, Vec3(20, 10, 0));
  EXPECT_EQ(second.mission[1].speed_mps, 0.5);

  ASSERT_EQ(s.expect.size(), 3U);
  EXPECT_EQ(s.expect[0].metric, "collision_count");
  EXPECT_EQ(s.expect[0].min, 0.0);
  EXPECT_EQ(s.expect[0].max, 0.0);
  EXPECT_EQ(s.expect[1].min, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(s.expect[2].max, 50.0);
}

TEST(LoadTest, AChoiceKnowsTheLineOfItsNameAndOfEachParameter) {
  const Scenario s = parse_scenario(crossing, "crossing.yaml");
  EXPECT_EQ(s.vehicles[0].avoider->where.prefix(), "crossing.yaml:20:24: ");
  EXPECT_EQ(s.vehicles[0].avoider->param_where.at(0).prefix(), "crossing.yaml:20:32: ");
  EXPECT_EQ(s.vehicles[1].avoider->where.prefix(), "crossing.yaml:32:14: ");
  EXPECT_EQ(s.expect[1].where.prefix(), "crossing.yaml:41:15: ");
}

TEST(LoadTest, WhatIsNotWrittenHasItsDefault) {
  const Scenario s = parse_scenario(
      "{fairway: 1, name: a, vehicles: [{model: m, avoider: direct, start: {position_m: [0, 0, 0]}}]}", "a");
  EXPECT_EQ(s.step_s, 0.05);
  EXPECT_EQ(s.duration_s, 600.0);
  EXPECT_EQ(s.seed, 1U);
  EXPECT_EQ(s.perception.kind.name, "perfect");
  EXPECT_EQ(s.perception.range_m, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(s.stop_when_done);
  EXPECT_EQ(s.vehicles[0].name, "robot0");
  EXPECT_EQ(s.vehicles[0].radius_m, 1.0);
  EXPECT_EQ(s.vehicles[0].limits, Limits{});
  EXPECT_TRUE(s.vehicles[0].mission.empty());
}

TEST(LoadTest, ParametersKeepTheirTypes) {
  const Scenario s = parse_scenario(
      "{fairway: 1, name: a, vehicles: [{model: {name: m, a: 5, b: '5', c: true, d: 'true', e: word, f: "
      "+1e3}, avoider: direct, start: {position_m: [0, 0, 0]}}]}",
      "a");
  const ParamValues expected{{"a", 5.0},
                             {"b", std::string("5")},
                             {"c", true},
                             {"d", std::string("true")},
                             {"e", std::string("word")},
                             {"f", 1000.0}};
  EXPECT_EQ(s.vehicles[0].model->params, expected);
}

/// A document with one vehicle, whose start and other keys are given.
std::string scenario_with(const std::string& document, const std::string& vehicle = "",
                          const std::string& start = "") {
  return "fairway: 1\nname: a\n" + document +
         "\nvehicles:\n  - model: m\n    avoider: direct\n    start: {position_m: [0, 0, 0]" + start + "}\n" +
         (vehicle.empty() ? "" : "    " + vehicle + "\n");
}

TEST(DistributionTest, EachDrawsFromTheStreamOfItsPath) {
  const Scenario s = parse_scenario(
      scenario_with("seed: 9\nexam: {crit_dist_m: {uniform: [5, 8]}}",
                    "radius_m: {normal: [2, 0.5]}\n    limits: {max_speed_mps: {uniform: [1, 2]}}"),
      "a");
  EXPECT_EQ(s.exam.crit_dist_m, Rng{9}.stream("exam.crit_dist_m").uniform(5, 8));
  EXPECT_EQ(s.vehicles[0].radius_m, 2 + 0.5 * Rng{9}.stream("vehicles[0].radius_m").normal());
  EXPECT_EQ(s.vehicles[0].limits.max_speed, Rng{9}.stream("vehicles[0].limits.max_speed_mps").uniform(1, 2));
}

TEST(DistributionTest, DefaultsAreDrawnAnewForEachVehicle) {
  const std::string text =
      "{fairway: 1, name: a, defaults: {model: {name: m, mass_kg: {uniform: [1, 2]}}, avoider: direct, "
      "start: {position_m: [{uniform: [0, 9]}, {uniform: [0, 9]}, 0]}, mission: [{run: far}]}, "
      "missions: {far: [{transit: {position_m: [{uniform: [0, 9]}, 0, 0]}}]}, vehicles: [{}, {}, {id: 7}]}";
  const Scenario s = parse_scenario(text, "a", {}, 3);
  EXPECT_EQ(s.seed, 3U);
  EXPECT_EQ(s.vehicles[1].position.y(), Rng{3}.stream("vehicles[1].start.position_m[1]").uniform(0, 9));
  EXPECT_EQ(std::get<double>(s.vehicles[2].model->params[0].second),
            Rng{3}.stream("vehicles[2].model.mass_kg").uniform(1, 2));
  EXPECT_EQ(s.vehicles[2].mission[0].position.x(),
            Rng{3}.stream("vehicles[2].mission[0].transit.position_m[0]").uniform(0, 9));
  EXPECT_NE(s.vehicles[0].position, s.vehicles[1].position);
  EXPECT_NE(parse_scenario(text, "a", {}, 4).vehicles[0].position, s.vehicles[0].position);
}

TEST(DistributionTest, OnlyTheAcceptedPartOfABellIsDrawn) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    EXPECT_GE(
        parse_scenario(scenario_with("", "radius_m: {normal: [0, 1]}"), "a", {}, seed).vehicles[0].radius_m,
        0.0);
  }
}

TEST(OverrideTest, ReplacesAndAddsValuesByPath) {
  const Scenario s = parse_scenario(crossing, "c.yaml",
                                    {{"exam.crit_dist_m", "9"},
                                     {"water.current_mps", "[0.3, 0, 0]"},
                                     {"water.current_mps[1]", "0.4"},
                                     {"vehicles[0].limits.max_speed_mps", "1.5"},
                                     {"vehicles[1].radius_m", "{uniform: [4, 5]}"},
                                     {"vehicles[0].mission[1].rendezvous", "{}"},
                                     {"vehicles[1].mission[0].go_to.position_m[2]", "6"},
                                     {"perception.drop_ratio", "0.5"},
                                     {"seed", "12"}});
  EXPECT_EQ(s.exam.crit_dist_m, 9.0);
  EXPECT_EQ(s.water.current_n, Vec3(0.3, 0.4, 0));
  EXPECT_EQ(s.vehicles[0].limits.max_speed, 1.5);
  EXPECT_EQ(s.vehicles[1].radius_m, Rng{12}.stream("vehicles[1].radius_m").uniform(4, 5));
  EXPECT_EQ(s.vehicles[1].mission[0].position.z(), 6.0);
  EXPECT_EQ(s.perception.kind.params, (ParamValues{{"drop_ratio", 0.5}}));
  EXPECT_EQ(s.seed, 12U);
}

TEST(OverrideTest, AWordGrowsIntoAMapping) {
  const Scenario s = parse_scenario(
      crossing, "c.yaml", {{"vehicles[1].avoider.gain_ratio", "2"}, {"vehicles[1].model.mass_kg", "60"}});
  EXPECT_EQ(s.vehicles[1].avoider->name, "apf");
  EXPECT_EQ(s.vehicles[1].avoider->params, (ParamValues{{"gain_ratio", 2.0}}));
  EXPECT_EQ(s.vehicles[1].model->name, "zarco");
}

TEST(OverrideTest, EveryVehicleIsReachedAlsoWhereTheDefaultsSpeak) {
  const Scenario s = parse_scenario(
      crossing, "c.yaml", {{"vehicles[*].avoider.time_horizon_s", "9"}, {"vehicles[*].radius_m", "1"}});
  EXPECT_EQ(s.vehicles[0].avoider->name, "orca3d");
  EXPECT_EQ(s.vehicles[0].avoider->params, (ParamValues{{"time_horizon_s", 9.0}}));
  EXPECT_EQ(s.vehicles[1].avoider->name, "apf");
  EXPECT_EQ(s.vehicles[1].avoider->params, (ParamValues{{"time_horizon_s", 9.0}}));

  const Scenario other = parse_scenario(crossing, "c.yaml", {{"vehicles[*].avoider", "vo"}});
  EXPECT_EQ(other.vehicles[0].avoider->name, "vo");
  EXPECT_TRUE(other.vehicles[0].avoider->params.empty());
  EXPECT_EQ(parse_scenario(crossing, "c.yaml", {{"defaults.avoider", "vo"}}).vehicles[0].avoider->name, "vo");
}

TEST(OverrideTest, AVehicleReplacedAsAWholeStillTakesTheDefaults) {
  const Scenario s =
      parse_scenario(crossing, "c.yaml", {{"vehicles[1]", "{start: {position_m: [1, 2, 30]}}"}});
  EXPECT_EQ(s.vehicles[1].avoider->name, "orca3d");
  EXPECT_EQ(s.vehicles[1].position, Vec3(1, 2, 30));
}

TEST(OverrideTest, AnAngleInAnotherUnitReplacesTheDefault) {
  const Scenario s =
      parse_scenario(scenario_with("defaults: {start: {yaw_deg: 90}}", "", ", yaw_rad: 1"), "a");
  EXPECT_EQ(s.vehicles[0].yaw, 1.0);
}

TEST(LoadTest, AFileThatCannotBeReadIsRefused) {
  for (const std::string file : {"/nonexistent.yaml", "/"})
    EXPECT_EQ(refusal_by([&] { load_scenario(file); }), file + ": cannot be read");
}

}  // namespace
}  // namespace fairway
