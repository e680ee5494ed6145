// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/agent.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "fairway/dynamics/kinematic/kinematic.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

/// A boat of some program, which goes so fast [mps] whatever it is told.
template <int speed>
struct OwnBoat : Kinematic {
  static constexpr VehicleInfo info{.name = "own_boat", .title = "A boat", .source = "none"};
  explicit OwnBoat(const Params& params) : Kinematic{with_speed(params)} {}
  static Params with_speed(Params params) {
    params.max_speed_mps = speed;
    return params;
  }
};

/// How fast its envelope says that it goes ahead.
template <int speed>
double known_speed() {
  Catalogs catalogs = builtin_catalogs();
  catalogs.vehicles.add<OwnBoat<speed>>();
  Scenario scenario{.name = "own"};
  VehicleSpec vehicle{.model = Choice{.name = "own_boat"},
                      .avoider = Choice{.name = "orca3d"},
                      .tracking = Tracking::trackable,
                      .position = {0, 0, 5}};
  vehicle.mission = {{.kind = LegKind::transit, .position = {20, 0, 5}, .speed_mps = 9.0}};
  scenario.vehicles.push_back(vehicle);
  return Simulation{scenario, catalogs}.agents()[0].ship().envelope->ahead;
}

TEST(Agent, AnEnvelopeIsOfTheModelAndNotOfItsName) {
  EXPECT_NEAR(known_speed<1>(), 1.0, 0.01);
  EXPECT_NEAR(known_speed<3>(), 3.0, 0.01) << "of another catalog in the same program";
}

// At 1.2 m/s and more a hull that slips outwards in its turns would go round and round such goals.
TEST(Agent, WhoSlipsInTurnsComesToAGoalAbeamOrAstern) {
  for (const double speed : {1.2, 2.0}) {
    for (const double yaw_deg : {45.0, 90.0, 180.0}) {
      const Scenario scenario = parse_scenario(
          fmt::format(
              "{{fairway: 1, name: s, duration_s: 60, vehicles: [{{model: sparus2, avoider: orca2d, start: "
              "{{position_m: [0, 0, 5], yaw_deg: {}}}, mission: [{{transit: {{position_m: [6, 0, 5], "
              "speed_mps: {}}}}}]}}]}}",
              yaw_deg, speed),
          "s.yaml");
      Simulation simulation{scenario, builtin_catalogs()};
      while (!simulation.is_done()) simulation.step({});
      EXPECT_EQ(simulation.agents()[0].mission.phase(), Phase::arrived) << speed << " " << yaw_deg;
    }
  }
}

}  // namespace
}  // namespace fairway
