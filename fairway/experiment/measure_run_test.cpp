// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/measure_run.hpp"

#include <gtest/gtest.h>

#include "fairway/experiment/executor.hpp"
#include "fairway/sim/testing/runaway.hpp"

namespace fairway {
namespace {

TEST(MeasureRun, ARunThatBrokeIsStoredAsAFailureWithItsReason) {
  const Catalogs catalogs = catalogs_with_runaway();
  const std::vector<RunSpec> specs{{.key = "broken"}, {.key = "whole"}};
  Store store = Store::in_memory();
  const auto make = [&](std::size_t i) {
    Scenario scenario = breaking_scenario();
    if (i == 1) scenario.duration_s = 5.2;
    return measure_run(scenario, catalogs);
  };
  const ExecutorReport report = run_missing(specs, make, store);
  EXPECT_EQ(report.made, 2U);
  EXPECT_EQ(report.failed, 1U);
  for (const RunRecord& record : store.all()) {
    const bool broken = record.spec.key == "broken";
    EXPECT_EQ(record.failure, broken ? "diverged: broken at 5.3 s: its speed is beyond 200 m/s" : "");
    EXPECT_EQ(record.measures.empty(), broken);
  }
}

TEST(MeasureRun, WhoMayGoFasterThanOnALegIsNotTakenToKeepPace) {
  Scenario scenario{.name = "pace"};
  VehicleSpec vehicle{.model = Choice{.name = "kinematic"}, .avoider = Choice{.name = "direct"}};
  vehicle.limits.max_speed = 0.5;
  vehicle.mission = {{.kind = LegKind::transit, .position = {20, 0, 5}, .speed_mps = 0.5}};
  scenario.vehicles = {vehicle, vehicle};
  scenario.vehicles[1].mission.push_back({.kind = LegKind::transit, .speed_mps = 0.3});
  EXPECT_EQ(surroundings_of(scenario).keeps_pace, (std::vector<bool>{true, false}));
  scenario.water.current_n.x() = 0.1;
  EXPECT_EQ(surroundings_of(scenario).keeps_pace, (std::vector<bool>{false, false}));
}

}  // namespace
}  // namespace fairway
