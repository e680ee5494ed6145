// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/study_runs.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

Scenario lone_vehicle() {
  Scenario scenario{.name = "lone"};
  VehicleSpec vehicle{.name = "one"};
  vehicle.model = {.name = "kinematic"};
  vehicle.avoider = {.name = "direct"};
  vehicle.mission = {{.kind = LegKind::transit, .position = {10.0, 0.0, 0.0}}};
  scenario.vehicles = {vehicle};
  return scenario;
}

/// What the run was given.
std::vector<Measure> measure_exchange(const Scenario& scenario, const std::atomic<bool>*) {
  const double rate =
      scenario.exchange.params.empty() ? 0.0 : std::get<double>(scenario.exchange.params.front().second);
  return {{"rate_hz", Measure::fleet, rate}};
}

const Overrides half_a_hertz{{"exchange.kind", "acoustic"}, {"exchange.update_rate_hz", "0.5"}};

TEST(StudyOverrides, ReachTheScenarioOfEveryRun) {
  const std::vector<StudyRun> runs{{{"a", {}, 1}, lone_vehicle}, {{"b", {}, 2}, lone_vehicle}};
  const auto measures = make_runs(runs, measure_exchange, {.jobs = 1, .overrides = half_a_hertz});
  ASSERT_TRUE(measures);
  for (const auto& run : *measures) EXPECT_EQ(run.front().value, 0.5);
}

TEST(StudyOverrides, MakeOtherRunsOfTheSameOnes) {
  Store store = Store::in_memory();
  const std::vector<StudyRun> runs{{{"a", {}, 1}, lone_vehicle}};
  const auto plain = make_runs(runs, measure_exchange, {.jobs = 1, .store = &store});
  const auto changed =
      make_runs(runs, measure_exchange, {.jobs = 1, .store = &store, .overrides = half_a_hertz});
  EXPECT_EQ(plain->front().front().value, 0.0);
  EXPECT_EQ(changed->front().front().value, 0.5);
  EXPECT_EQ(store.size(), 2U);
}

TEST(StudyOverrides, ThatDoNotFitAreRefusedBeforeAnyRun) {
  Store store = Store::in_memory();
  const std::vector<StudyRun> runs{{{"a", {}, 1}, lone_vehicle}};
  const StudyOptions options{.jobs = 1, .store = &store, .overrides = {{"exchang.kind", "acoustic"}}};
  EXPECT_THROW(make_runs(runs, measure_exchange, options), InputError);
  EXPECT_EQ(store.size(), 0U);
}

}  // namespace
}  // namespace fairway
