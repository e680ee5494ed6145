// SPDX-License-Identifier: Apache-2.0
// What becomes of a vehicle when something on board breaks.
#include <gtest/gtest.h>

#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

/// One that goes north at 0.5 m/s, and one that lies still and may look.
Scenario pair(FailureKind kind, const std::string& exchange = "acoustic") {
  Scenario scenario{.name = "pair", .duration_s = 100, .stop_when_done = false};
  scenario.exchange = {.name = exchange, .path = "exchange"};
  const auto add = [&](const Vec3& from, const Vec3& to) {
    VehicleSpec vehicle{.id = static_cast<std::uint32_t>(scenario.vehicles.size()),
                        .model = Choice{.name = "sparus2", .path = "model"},
                        .avoider = Choice{.name = "direct", .path = "avoider"},
                        .position = from};
    vehicle.limits.max_speed = 0.5;
    vehicle.mission = {{.kind = LegKind::transit, .position = to}};
    scenario.vehicles.push_back(vehicle);
  };
  add({0, 0, 5}, {20, 0, 5});
  add({0, 20, 5}, {60, 20, 5});
  scenario.vehicles[0].failure = {kind, 20.0};
  return scenario;
}

struct Seen {
  Vec3 place;     ///< of the first vehicle
  Vec3 velocity;  ///< likewise
  double age{};   ///< of the second one's track of it [s]
};

Seen seen_after(const Scenario& scenario, double time) {
  Simulation simulation{scenario, builtin_catalogs()};
  while (simulation.time() < time - 1e-9) simulation.step({});
  simulation.look();
  const VehicleState& x = simulation.agents()[0].vehicle.state();
  const auto& tracks = simulation.sight(1).tracks;
  return {x.p_n, x.v_n(), tracks.empty() ? -1.0 : tracks.front().age};
}

TEST(Failure, BeginsSoLongAfterTheVehicleHasSetOut) {
  const Seen whole = seen_after(pair(FailureKind::none), 20.0);
  for (const FailureKind kind : {FailureKind::silent, FailureKind::stops, FailureKind::leaves})
    EXPECT_EQ(seen_after(pair(kind), 20.0).place, whole.place);
  EXPECT_NEAR(whole.velocity.x(), 0.5, 0.05);
}

TEST(Failure, WhoIsSilentGoesOnAndIsKnownByItsLastWord) {
  const Seen whole = seen_after(pair(FailureKind::none), 35.0);
  const Seen silent = seen_after(pair(FailureKind::silent), 35.0);
  EXPECT_EQ(silent.place, whole.place);
  EXPECT_LT(whole.age, 11.0);
  EXPECT_GE(silent.age, 15.0);
  EXPECT_EQ(seen_after(pair(FailureKind::silent, "perfect"), 35.0).age, 0.0)
      << "who told all at once is seen instead";
}

TEST(Failure, WhoStopsComesToRest) {
  const Seen stopped = seen_after(pair(FailureKind::stops), 60.0);
  EXPECT_LT(stopped.velocity.norm(), 0.15);
  EXPECT_LT(stopped.place.x(), 17.0);
}

TEST(Failure, WhoLeavesGoesOnBeyondItsGoal) {
  const Seen away = seen_after(pair(FailureKind::leaves), 80.0);
  EXPECT_GT(away.place.x(), 30.0) << "its goal is at 20 m";
  EXPECT_NEAR(seen_after(pair(FailureKind::none), 80.0).place.x(), 20.0, 1.5);
}

}  // namespace
}  // namespace fairway
