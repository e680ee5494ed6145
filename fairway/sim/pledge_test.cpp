// SPDX-License-Identifier: Apache-2.0
// What vehicles do that agree by `pledge`, and what one says that cannot.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

/// "[{start: ..., mission: ...}, ...]" and what else the scenario says.
Scenario agreeing(const std::string& vehicles, const std::string& rest = "") {
  return parse_scenario(
      "{fairway: 1, name: s, duration_s: 1200, exchange: {kind: perfect}" + rest +
          ", defaults: {model: sparus2, avoider: pledge, radius_m: 1.5, limits: {max_speed_mps: 0.5}}"
          ", vehicles: [" +
          vehicles + "]}",
      "s.yaml");
}

std::string vehicle(const std::string& from, const std::string& to, const std::string& rest = "") {
  return "{start: {position_m: " + from + "}, mission: [{transit: {position_m: " + to + ", arrival_m: 2}}]" +
         rest + "}";
}

/// A run of it, and how near two vehicles came to each other.
struct Watched {
  Simulation simulation;
  double nearest = 1e9;  ///< [m]
  double deepest = 0.0;  ///< [m]

  explicit Watched(const Scenario& scenario) : simulation{scenario, builtin_catalogs()} {
    while (!simulation.is_done()) {
      simulation.step({});
      const auto& all = simulation.agents();
      for (std::size_t i = 0; i < all.size(); ++i) {
        deepest = std::max(deepest, place(i).z());
        for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (place(i) - place(j)).norm());
      }
    }
  }

  Vec3 place(std::size_t i) const { return simulation.agents()[i].vehicle.state().p_n; }
  std::string note(std::size_t i) const { return std::string(simulation.agents()[i].note); }
  bool all_arrived() const {
    return std::ranges::all_of(simulation.agents(),
                               [](const Agent& a) { return a.mission.phase() == Phase::arrived; });
  }
};

TEST(PledgeRuns, TwoWhoStartTooNearEachOtherPart) {
  for (const double apart : {3.3, 3.8, 4.6}) {
    const Watched run{agreeing(vehicle("[0, 0, 8]", "[-20, 0, 8]") + ", " +
                               vehicle("[" + std::to_string(apart) + ", 0, 8]", "[24, 0, 8]"))};
    EXPECT_TRUE(run.all_arrived()) << apart;
    EXPECT_GT(run.nearest, apart - 0.3) << "but for what they are off their places";
  }
}

/// Nine beside each other, eight of whom go straight on.
Scenario nine(const std::string& first) {
  std::string all = first;
  for (int i = 1; i < 9; ++i) {
    const std::string east = std::to_string(10 * i);
    all += ", " + vehicle("[0, " + east + ", 8]", "[20, " + east + ", 8]");
  }
  return agreeing(all);
}

TEST(PledgeRuns, OfNineWhoHasTwoLegsArrivesToo) {
  const Watched run{
      nine("{start: {position_m: [0, 0, 8]}, mission: [{transit: {position_m: [10, 0, 8], arrival_m: 2}}, "
           "{transit: {position_m: [20, 0, 8], arrival_m: 2}}]}")};
  EXPECT_TRUE(run.all_arrived());
  EXPECT_LT(run.simulation.time(), 300.0);
}

TEST(PledgeRuns, OfNineWhoseGoalChangesOnItsWayGoesThere) {
  const Scenario before = nine(vehicle("[0, 0, 8]", "[20, 0, 8]"));
  Scenario changed = before;
  changed.vehicles[0].mission[0].position = {15, -20, 8};
  Simulation simulation{before, builtin_catalogs()};
  const auto place = [&] { return simulation.agents()[0].vehicle.state().p_n; };
  while (place().x() < 5.0 && simulation.time() < 100.0) simulation.step({});
  ASSERT_GT(place().x(), 4.9) << "it is on its way";
  simulation.change(before, changed, builtin_catalogs());
  while (!simulation.is_done()) simulation.step({});
  EXPECT_LT((place() - Vec3{15, -20, 8}).norm(), 2.5);
  EXPECT_LT(simulation.time(), 400.0);
}

TEST(PledgeRuns, WhoseFloorLeavesNoRoomForLevelsKeepsItsOwn) {
  const std::string walls =
      ", obstacles: [{polygon: {vertices_m: [[-40, -6], [40, -6], [40, -4], [-40, -4]]}}, "
      "{polygon: {vertices_m: [[-40, 4], [40, 4], [40, 6], [-40, 6]]}}]";
  const std::string floor = ", limits: {max_speed_mps: 0.5, max_depth_m: 10}";
  Scenario scenario = agreeing(
      vehicle("[-20, 0, 8]", "[20, 0, 8]", floor) + ", " + vehicle("[20, 0, 8]", "[-20, 0, 8]", floor),
      walls);
  scenario.duration_s = 300;
  const Watched run{scenario};
  EXPECT_LT(run.deepest, 9.0);
  EXPECT_EQ(run.note(0).find("off its promised way"), std::string::npos) << run.note(0);
}

TEST(PledgeRuns, WhoIsSlowKeepsToWhatItPromises) {
  const std::string slow = ", limits: {max_speed_mps: 0.035}";
  const std::string patient = ", exam: {crit_dist_m: 20, safety_distance_m: 3, time_coefficient_ratio: 1000}";
  Scenario scenario = agreeing(
      vehicle("[0, 0, 8]", "[20, 0, 8]", slow) + ", " + vehicle("[0, 30, 8]", "[-15, 40, 8]", slow), patient);
  scenario.duration_s = 2500;
  const Watched run{scenario};
  EXPECT_TRUE(run.all_arrived()) << run.note(0) << ", " << run.note(1);
}

TEST(PledgeRuns, WhoIsRefusedInACurrentKeepsItsPlace) {
  Scenario scenario =
      agreeing(vehicle("[0, 0, 8]", "[30, 0, 8]") + ", " + vehicle("[10, 10, 8]", "[30, -20, 8]") + ", " +
                   vehicle("[-8, 0, 8]", "[40, 40, 8]"),
               ", water: {current_mps: [0.2, 0.1, 0]}");
  for (VehicleSpec& spec : scenario.vehicles)
    spec.avoider = Choice{.name = "pledge", .params = {{"team_count", 2.0}}, .path = "avoider"};
  scenario.duration_s = 600;
  const Watched run{scenario};
  EXPECT_EQ(run.note(2), "its id is beyond those of the group (team_count)");
  EXPECT_LT((run.place(2) - Vec3{-8, 0, 8}).norm(), 3.0) << "it would be 130 m away";
}

TEST(PledgeRuns, WhoIsRefusedAndCannotStopComesBackAgainAndAgain) {
  Scenario scenario =
      agreeing(vehicle("[0, 60, 8]", "[30, 60, 8]") + ", " +
               vehicle("[0, 0, 8]", "[0, 100, 8]", ", model: remus100, limits: {max_speed_mps: 1.5}"));
  scenario.duration_s = 300;
  const Watched run{scenario};
  EXPECT_EQ(run.note(1), "it turns too slowly for its words");
  EXPECT_LT(run.place(1).norm(), 40.0) << "it would be hundreds of metres away";
}

TEST(PledgeRuns, WhoLeavesItsWaySaysSoAndWhoKeepsToItSaysNothingThatIsOver) {
  Scenario scenario = agreeing(
      vehicle("[0, 0, 8]", "[40, 0, 8]") +
      ", {start: {position_m: [0, 30, 8]}, failure: {kind: leaves, under_way_s: 30}, mission: [{transit: "
      "{position_m: [20, 30, 8], arrival_m: 2}}, {transit: {position_m: [20, 60, 8], arrival_m: 2}}]}");
  scenario.duration_s = 70;
  const Watched early{scenario};
  EXPECT_EQ(early.note(0), "");
  scenario.duration_s = 200;
  const Watched late{scenario};
  EXPECT_EQ(late.note(0), "has arrived, and is held for ever");
  EXPECT_EQ(late.note(1), "is off its promised way, holds and says so");
}

TEST(PledgeRuns, WhoLiesAgainstACurrentHasTurnedToItsWayWhenThePlanStarts) {
  Scenario scenario = agreeing(vehicle("[0, 0, 8], yaw_deg: 180", "[40, 0, 8]") + ", " +
                                   vehicle("[0, 30, 8], yaw_deg: 180", "[0, 60, 8]"),
                               ", water: {current_mps: [0.2, 0, 0]}");
  scenario.exchange = {.name = "acoustic", .params = {{"bit_rate_bps", 100.0}}, .path = "exchange"};
  Simulation simulation{scenario, builtin_catalogs()};
  const auto off_course = [&](std::size_t i, double course) {
    return std::fabs(wrap_angle(yaw_of(simulation.agents()[i].vehicle.state().q_nb) - course));
  };
  while (simulation.time() < 1.0 || !simulation.agents()[0].note.empty()) {
    simulation.step({});
    ASSERT_LT(simulation.time(), 200.0);
  }
  EXPECT_LT(off_course(0, 0.0), 0.8);
  EXPECT_LT(off_course(1, 0.5 * pi), 0.8) << "it steers somewhat against the current";
}

TEST(PledgeRuns, WhoStopsOnItsWaySaysSoBeforeItIsOffItsTube) {
  Scenario scenario =
      agreeing(vehicle("[0, 0, 8]", "[40, 0, 8]") + ", " +
               vehicle("[0, 30, 8]", "[40, 30, 8]", ", failure: {kind: stops, under_way_s: 30}"));
  scenario.duration_s = 35.5;
  const Watched run{scenario};
  EXPECT_EQ(run.note(1), "is off its promised way, holds and says so");
  EXPECT_EQ(run.note(0), "");
}

}  // namespace
}  // namespace fairway
