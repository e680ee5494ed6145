// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

VehicleSpec sparus(std::uint32_t id, const Vec3& from, const Vec3& to) {
  VehicleSpec spec{.id = id,
                   .name = "v" + std::to_string(id),
                   .model = Choice{.name = "sparus2", .path = "model"},
                   .avoider = Choice{.name = "orca3d",
                                     .params = {{"time_horizon_s", 20.0}, {"responsibility_ratio", 1.0}},
                                     .path = "avoider"},
                   .steering = Choice{.name = "proportional", .path = "steering"},
                   .position = from,
                   .yaw = std::atan2(to.y() - from.y(), to.x() - from.x()),
                   .radius_m = 2.0,
                   .priority = static_cast<std::int32_t>(id)};
  spec.limits.max_speed = 0.5;
  spec.mission = {{.kind = LegKind::transit, .position = to, .speed_mps = 0.5, .arrival_m = 2.0}};
  return spec;
}

/// Two that meet nose to nose and tell each other nothing.
Scenario head_on(const std::string& perception) {
  Scenario scenario{.name = "head_on", .duration_s = 300, .seed = 1};
  scenario.perception.kind = {.name = perception, .path = "perception"};
  scenario.exchange.name = "none";
  scenario.vehicles = {sparus(0, {-30, 0, 5}, {30, 0, 5}), sparus(1, {30, 0.5, 5}, {-30, 0.5, 5})};
  return scenario;
}

/// The hash over all frames.
struct Hashes final : FrameSink {
  std::uint64_t all{};
  void write(const Frame& frame) override { all = mix_hash(all, frame_hash(frame)); }
};

struct Outcome {
  std::uint64_t hash{};
  double min_separation{};
  double arrived{};
  double collisions{};
};

Outcome outcome_of(const Scenario& scenario) {
  RunMetrics metrics{{scenario.exam.crit_dist_m, scenario.exam.safety_distance_m}};
  Hashes hash;
  const std::array<FrameSink*, 2> sinks{&metrics, &hash};
  Simulation{scenario, builtin_catalogs()}.run(sinks);
  Outcome outcome{.hash = hash.all};
  for (const Measure& m : metrics.measures()) {
    if (m.quantity == "min_separation_m") outcome.min_separation = m.value;
    if (m.quantity == "arrived_ratio") outcome.arrived = m.value;
    if (m.quantity == "pair_collision_count") outcome.collisions = m.value;
  }
  return outcome;
}

TEST(SonarInTheLoop, TwoThatMeetHeadOnAndTellNothingPassEachOther) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    Scenario scenario = head_on("sonar");
    scenario.seed = seed;
    const Outcome outcome = outcome_of(scenario);
    EXPECT_EQ(outcome.collisions, 0.0) << seed;
    EXPECT_EQ(outcome.arrived, 1.0) << seed;
    EXPECT_GT(outcome.min_separation, 3.0) << seed;
  }
}

TEST(SonarInTheLoop, WithoutASonarTheyWouldNotSeeEachOther) {
  Scenario blind = head_on("sonar");
  blind.perception.kind.params = {{"max_range_m", 1.5}};
  EXPECT_GT(outcome_of(blind).collisions, 0.0);
}

TEST(SonarInTheLoop, TheSameSeedGivesTheSameBitsAndAnotherDoesNot) {
  Scenario scenario = head_on("sonar");
  scenario.duration_s = 80;
  const std::uint64_t first = outcome_of(scenario).hash;
  EXPECT_EQ(outcome_of(scenario).hash, first);
  scenario.seed = 2;
  EXPECT_NE(outcome_of(scenario).hash, first);
}

TEST(SonarInTheLoop, WithDriftingNavigationTheyStillPass) {
  Scenario scenario = head_on("sonar");
  scenario.navigation.name = "drifting";
  Simulation simulation{scenario, builtin_catalogs()};
  simulation.look();
  EXPECT_EQ(simulation.agents()[0].own.position_sigma, 1.0) << "its methods are told what it states";
  const Outcome outcome = outcome_of(scenario);
  EXPECT_EQ(outcome.collisions, 0.0);
  EXPECT_GT(outcome.min_separation, 3.0);
}

TEST(SonarInTheLoop, WhoSaysAWordOfItsMethodHasNotSaidWhereItIs) {
  Scenario scenario{.name = "astern", .duration_s = 60};
  scenario.exchange.name = "acoustic";
  scenario.exchange.params = {{"range_m", 2000.0}};
  scenario.vehicles = {sparus(0, {0, 0, 5}, {100, 0, 5}), sparus(1, {-150, 0, 5}, {-60, 0, 5})};
  for (VehicleSpec& spec : scenario.vehicles) spec.avoider = Choice{.name = "delay_check", .path = "avoider"};
  for (const char* perception : {"perfect", "sonar"}) {
    scenario.perception.kind = {.name = perception, .path = "perception"};
    Simulation simulation{scenario, builtin_catalogs()};
    for (int i = 0; i < 600; ++i) {
      simulation.look();
      // before its method has begun it told its place once
      for (const Track& track : simulation.sight(0).tracks)
        ASSERT_GT(track.age, simulation.time() - 3.0) << perception << " after " << simulation.time() << " s";
      simulation.act({});
    }
    EXPECT_FALSE(simulation.heard_by(0).empty()) << perception;
  }
}

TEST(SonarInTheLoop, AStepAllocatesNothingInSteadyState) {
  Scenario scenario = head_on("sonar");
  scenario.perception.kind.params = {{"false_echoes_count", 5.0}};
  Simulation simulation{scenario, builtin_catalogs()};
  for (int i = 0; i < 40; ++i) simulation.step({});
  const long before = allocation_count();
  for (int i = 0; i < 2000; ++i) simulation.step({});
  EXPECT_EQ(allocation_count() - before, 0);
}

TEST(SonarInTheLoop, ARefusalNamesThePlaceInTheScenario) {
  Scenario scenario = head_on("sonar");
  scenario.perception.kind.params = {{"beams_count", 0.0}};
  try {
    Simulation{scenario, builtin_catalogs()};
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "perception.beams_count: is 0; expected a whole number in [1, 1024]");
  }
}

}  // namespace
}  // namespace fairway
