// SPDX-License-Identifier: Apache-2.0
// What a run makes of what is changed of it on its way.
#include <gtest/gtest.h>

#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

/// One that holds for a while and then sets out.
Scenario holding(double duration_s) {
  Scenario scenario{.name = "holding", .duration_s = 100};
  VehicleSpec vehicle{
      .model = Choice{.name = "kinematic"}, .avoider = Choice{.name = "direct"}, .position = {0, 0, 5}};
  vehicle.limits.max_speed = 0.5;
  vehicle.mission = {{.kind = LegKind::keep_position, .duration_s = duration_s},
                     {.kind = LegKind::transit, .position = {20, 0, 5}}};
  scenario.vehicles.push_back(vehicle);
  return scenario;
}

TEST(Change, AHoldThatIsToBeLongerIsLonger) {
  const Scenario before = holding(10), changed = holding(30);
  Simulation run{before, builtin_catalogs()};
  while (run.time() < 5.0) run.step({});
  run.change(before, changed, builtin_catalogs());
  while (run.agents()[0].mission.phase() != Phase::under_way) run.step({});
  EXPECT_NEAR(run.time(), 30.0, 0.1);
}

TEST(Change, AFasterLegIsGoneFasterByWhoIsLimitedByItsMission) {
  Scenario before = holding(1);
  before.vehicles[0].avoider = Choice{.name = "orca2d+trackable"};
  before.vehicles[0].limits.max_speed = Limits::none;
  before.vehicles[0].mission[1] = {.kind = LegKind::transit, .position = {90, 0, 5}, .speed_mps = 0.3};
  Scenario changed = before;
  changed.vehicles[0].mission[1].speed_mps = 0.45;
  Simulation run{before, builtin_catalogs()};
  while (run.time() < 20.0) run.step({});
  EXPECT_NEAR(run.agents()[0].vehicle.state().v_b.x(), 0.3, 0.01);
  run.change(before, changed, builtin_catalogs());
  while (run.time() < 40.0) run.step({});
  EXPECT_NEAR(run.agents()[0].vehicle.state().v_b.x(), 0.45, 0.01);
}

TEST(Change, ARendezvousThatIsToWaitForTheMethodDoes) {
  Scenario before = holding(10);
  before.vehicles[0].mission[0] = {.kind = LegKind::rendezvous};
  before.vehicles.push_back(holding(30).vehicles[0]);
  before.vehicles[1].id = 1;
  before.vehicles[1].position.y() = 50.0;
  before.vehicles[1].mission.insert(before.vehicles[1].mission.begin() + 1, {.kind = LegKind::rendezvous});
  Scenario changed = before;
  changed.vehicles[0].mission[0].agreed = true;
  Simulation run{before, builtin_catalogs()};
  while (run.time() < 5.0) run.step({});
  EXPECT_FALSE(run.agents()[0].mission.leg()->agreed);
  run.change(before, changed, builtin_catalogs());
  EXPECT_TRUE(run.agents()[0].mission.leg()->agreed);
  EXPECT_EQ(run.agents()[0].mission.phase(), Phase::waiting);
}

}  // namespace
}  // namespace fairway
