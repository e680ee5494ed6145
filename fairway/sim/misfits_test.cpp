// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/misfits.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/agent.hpp"

namespace fairway {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

Scenario alone(const std::string& model, const std::string& avoider, const std::string& tracking = "raw",
               const std::string& rest = "") {
  return parse_scenario(
      "{fairway: 1, name: alone, vehicles: [{model: " + model + ", avoider: " + avoider +
          ", tracking: " + tracking +
          ", start: {position_m: [0, 0, 0]}, mission: [{transit: {position_m: [50, 0, 0]}}]}]" + rest + "}",
      "alone.yaml");
}

std::vector<std::string> told(const std::string& model, const std::string& avoider,
                              const std::string& tracking = "raw", const std::string& rest = "") {
  return misfits(alone(model, avoider, tracking, rest), builtin_catalogs());
}

std::string in_force(const std::string& model, const std::string& avoider, const std::string& tracking,
                     const std::string& rest = "") {
  const Scenario scenario = alone(model, avoider, tracking, rest);
  const std::vector<Shared<Limits>> limits = limits_in_force(scenario, builtin_vehicles());
  return avoider_in_force(scenario.vehicles[0], limits[0], scenario.obstacles, builtin_catalogs().avoiders);
}

TEST(Tracking, WrapsWhoeverMustTurnUnlessTheScenarioSaysRaw) {
  for (const std::string model : {"zarco", "otter_by_thrust", "remus100", "sparus2", "kinematic"}) {
    EXPECT_EQ(in_force(model, "orca2d", "auto"), "orca2d+trackable") << model;
    EXPECT_EQ(in_force(model, "orca2d", "raw"), "orca2d") << model;
    EXPECT_EQ(in_force(model, "direct", "auto"), "direct") << model;
    EXPECT_EQ(in_force(model, "orca2d+safety_filter", "auto"), "orca2d+safety_filter") << model;
  }
  for (const std::string model : {"minerva", "minerva_transport", "{name: kinematic, max_sway_mps: 0.5}"}) {
    EXPECT_EQ(in_force(model, "orca2d", "auto"), "orca2d") << model;
    EXPECT_EQ(in_force(model, "orca2d", "trackable"), "orca2d+trackable") << model;
  }
}

TEST(Tracking, ShowsAWayRoundWhatStandsToWhoFindsNone) {
  const std::string buoy = ", obstacles: [{sphere: {position_m: [25, 0, 0], radius_m: 1}}]";
  EXPECT_EQ(in_force("zarco", "orca2d", "auto", buoy), "orca2d+trackable+way_round");
  EXPECT_EQ(in_force("zarco", "direct+safety_filter", "auto", buoy), "direct+safety_filter+way_round");
  EXPECT_EQ(in_force("zarco", "avoa_improved", "auto", buoy), "avoa_improved+trackable");
  EXPECT_EQ(in_force("zarco", "direct", "auto", buoy), "direct");
  EXPECT_EQ(in_force("zarco", "orca2d", "trackable", buoy), "orca2d+trackable");
  EXPECT_EQ(in_force("zarco", "orca2d", "raw", buoy), "orca2d");
  EXPECT_EQ(in_force("minerva", "orca2d", "auto", buoy), "orca2d");
  const std::string drifter =
      ", obstacles: [{sphere: {position_m: [25, 0, 0], radius_m: 1, velocity_mps: [0, 0.1, 0]}}]";
  EXPECT_EQ(in_force("zarco", "orca2d", "auto", drifter), "orca2d+trackable");
}

TEST(Tracking, LimitsWhoIsForeseenByItsMission) {
  const auto most_of = [](const std::string& avoider, const std::string& tracking, const std::string& rest) {
    const Scenario scenario = parse_scenario(
        "{fairway: 1, name: s, vehicles: [{model: sparus2, avoider: " + avoider + ", tracking: " + tracking +
            ", start: {position_m: [0, 0, 0]}, mission: [{transit: {position_m: [9, 0, 0], speed_mps: 0.4}}, "
            "{transit: {position_m: [0, 0, 0], speed_mps: 0.6}}]" +
            rest + "}]}",
        "s.yaml");
    return make_agent(scenario.vehicles[0], scenario, builtin_catalogs()).ship().limits->max_speed;
  };
  EXPECT_EQ(most_of("orca2d", "auto", ""), 0.6);
  EXPECT_EQ(most_of("orca2d", "auto", ", limits: {max_speed_mps: 1}"), 1.0);
  EXPECT_EQ(most_of("orca2d", "auto", ", limits: {max_speed_mps: 3}"), 1.2);
  EXPECT_EQ(most_of("orca2d+safety_filter", "raw", ", limits: {max_speed_mps: 3}"), 1.2);
  EXPECT_EQ(most_of("orca2d", "raw", ", limits: {max_speed_mps: 3}"), 3.0);
  EXPECT_EQ(most_of("orca2d", "raw", ""), Limits::none);
}

TEST(Tracking, IsAutomaticInAFileThatDoesNotSayIt) {
  const Scenario scenario = parse_scenario(
      "{fairway: 1, name: s, vehicles: [{model: zarco, avoider: orca2d, start: {position_m: [0, 0, 0]}}]}",
      "s.yaml");
  EXPECT_EQ(scenario.vehicles[0].tracking, Tracking::automatic);
  EXPECT_EQ(make_agent(scenario.vehicles[0], scenario, builtin_catalogs()).avoider.info().name, "trackable");
}

/// What every method is told on every kind of vehicle, as printed.
TEST(Misfits, AreTheseForEachMethodOnEachVehicle) {
  const std::vector<std::string> moving_any_way{
      "apf",      "orca3d", "orca2d", "vo", "rvo", "hrvo", "hard_switching", "wall_following",
      "rrt_star", "blend",  "bvc"};
  const std::vector<std::string> turning{
      "direct", "avoa", "avoa_improved", "teb", "orca2d+trackable", "orca2d+safety_filter"};
  const std::vector<std::string> boats{"zarco", "otter_by_thrust", "sparus2", "kinematic"};
  for (const std::string& boat : boats) {
    for (const std::string& method : moving_any_way)
      EXPECT_THAT(told(boat, method),
                  ElementsAre("robot0: " + method + " moves a point that goes any way at once, and " + boat +
                              " has to turn first"));
    for (const std::string& method : turning) EXPECT_THAT(told(boat, method), IsEmpty()) << boat << method;
    EXPECT_THAT(told(boat, "orca2d", "auto"), IsEmpty()) << boat;
    EXPECT_THAT(told(boat, "avoa+stop_and_wait"), IsEmpty()) << boat;
  }
  for (const std::string& method : moving_any_way)
    EXPECT_THAT(told("minerva_transport", method), IsEmpty()) << method;
  EXPECT_THAT(
      told("remus100", "avoa+stop_and_wait"),
      ElementsAre("robot0: avoa+stop_and_wait has to stop now and then, and remus100 cannot: it circles",
                  "robot0: avoa+stop_and_wait is to go 0.5 m/s, and remus100 goes 0.96 at least"));
  EXPECT_EQ(told("remus100", "blend").size(), 3u);
}

TEST(Misfits, TellOfGroundThatAMethodDoesNotSee) {
  const std::string buoy = ", obstacles: [{sphere: {position_m: [20, 0, 0], radius_m: 1";
  const std::string transport = "minerva_transport";
  EXPECT_THAT(told(transport, "rrt_star", "raw", buoy + "}}]"), IsEmpty());
  EXPECT_THAT(told(transport, "rrt_star", "raw", buoy + ", charted: false}}]"),
              ElementsAre("robot0: rrt_star avoids only what is charted, and obstacles[0] is not"));
  EXPECT_THAT(told(transport, "blend", "raw", buoy + ", charted: false}}]"), IsEmpty());
  const std::string drifter =
      ", obstacles: [{sphere: {position_m: [20, 0, 0], radius_m: 1, velocity_mps: [0.1, 0, 0]}}]";
  EXPECT_THAT(told(transport, "rrt_star", "raw", drifter),
              ElementsAre("robot0: rrt_star ignores whatever moves, and obstacles[0] drifts"));
  EXPECT_THAT(told("zarco", "rrt_star", "auto", drifter), IsEmpty());  // trackable sees it
  EXPECT_THAT(told(transport, "direct", "raw", drifter), IsEmpty());   // it is there to avoid nobody
  EXPECT_THAT(told(transport, "stop_and_wait", "raw", buoy + "}}]"),
              ElementsAre("robot0: stop_and_wait ignores obstacles, and there are some"));
  const std::string alone = "robot0: pledge agrees with others before it moves, and there are none";
  EXPECT_THAT(told("sparus2", "pledge", "auto", buoy + "}}], exchange: acoustic"), ElementsAre(alone));
  EXPECT_THAT(
      told("sparus2", "pledge", "auto", buoy + ", charted: false}}], exchange: acoustic"),
      UnorderedElementsAre("robot0: pledge avoids only what is charted, and obstacles[0] is not", alone));
  EXPECT_THAT(told("sparus2", "pledge", "auto", drifter + ", exchange: acoustic"),
              UnorderedElementsAre("robot0: pledge ignores whatever moves, and obstacles[0] drifts", alone));
  EXPECT_THAT(told("sparus2", "delay_check", "auto", buoy + "}}], exchange: acoustic"),
              ElementsAre("robot0: delay_check ignores obstacles, and there are some"));
  const std::string deep = ", obstacles: [{sphere: {position_m: [20, 0, 8], radius_m: 1}}]";
  EXPECT_THAT(
      told(transport, "orca2d", "raw", deep),
      ElementsAre("robot0: orca2d thinks in a horizontal plane, and not all that it meets is at one depth"));
  EXPECT_THAT(told(transport, "orca3d", "raw", deep), IsEmpty());
}

TEST(Misfits, TellWhoIsInNoTeamAndWhoseTeamIsNotThere) {
  const auto told_of = [](int count, const std::string& team) {
    return misfits(
        parse_scenario("{fairway: 1, name: s, exchange: acoustic, defaults: {model: sparus2, avoider: "
                       "{algorithm: pledge" +
                           team + "}}, fleet: {count: " + std::to_string(count) +
                           ", places: {lattice: {spacing_m: 11, centre_m: [0, 0, 50]}}}}",
                       "s.yaml"),
        builtin_catalogs());
  };
  for (const int all : {2, 7, 8, 10, 32}) EXPECT_THAT(told_of(all, ""), IsEmpty()) << all;
  EXPECT_THAT(
      told_of(10, ", team_count: 8"),
      ElementsAre("robot8 and 1 other: pledge agrees among the ids 0 to 7 (team_count: 8), at most 32, "
                  "and stays where it is with any other id"));
  EXPECT_THAT(told_of(10, ", team_count: 10"), IsEmpty());
  EXPECT_THAT(
      told_of(34, ", team_count: 32"),
      ElementsAre("robot32 and 1 other: pledge agrees among the ids 0 to 31 (team_count: 32), at most "
                  "32, and stays where it is with any other id"));
  EXPECT_THAT(
      told_of(7, ", team_count: 8"),
      ElementsAre("robot0 and 6 others: pledge waits for words of the ids 0 to 7 (team_count: 8), and "
                  "not all of these are there and say such"));
}

TEST(Misfits, TellOfWhatKeepsThoseWhoAgreeByWordsFromIt) {
  const auto told_of = [](const std::string& first, const std::string& second) {
    return misfits(parse_scenario("{fairway: 1, name: s, exchange: acoustic, defaults: {model: sparus2, "
                                  "avoider: pledge}, vehicles: [{start: {position_m: [0, 0, 0]}, mission: "
                                  "[{transit: {position_m: " +
                                      first + "}}]}, {" + second + "}]}",
                                  "s.yaml"),
                   builtin_catalogs());
  };
  const std::string goal = "[50, 0, 0]", start = "start: {position_m: [0, 20, 0]}, ";
  EXPECT_THAT(told_of(goal, start + "avoider: pledge"), IsEmpty());
  EXPECT_THAT(told_of(goal, start + "avoider: {algorithm: pledge, headway_s: 5}"), IsEmpty())
      << "that is its own choice";
  EXPECT_THAT(told_of(goal, start + "avoider: direct"),
              testing::Contains("robot0: pledge avoids nobody but those with whom it agrees, and robot1 does "
                                "not speak its words"));
  const std::string same = ", and all have to have the same for its claims to hold";
  EXPECT_THAT(told_of(goal, start + "avoider: {algorithm: pledge, datum_north_m: 20}"),
              ElementsAre("robot1: pledge has another datum_north_m (20) than robot0 (0)" + same));
  EXPECT_THAT(told_of(goal, start + "avoider: {algorithm: pledge, tube_m: 2}"),
              ElementsAre("robot1: pledge has another tube_m (2) than robot0 (1)" + same));
  const std::string reach =
      "pledge tells places within 163 m of its datum, from the surface down to 327 m, and ";
  EXPECT_THAT(told_of("[170, 0, 0]", start + "avoider: pledge"),
              ElementsAre("robot0: " + reach + "a place of its mission lies beyond"));
  EXPECT_THAT(told_of(goal, "start: {position_m: [0, 400, 0]}"),
              ElementsAre("robot1: " + reach + "its start lies beyond: it stays there"));
}

/// A vehicle of `radius_m` to each, on one course at 90 m from the next.
std::vector<std::string> told_of_spheres(const std::vector<double>& radii, const std::string& perception,
                                         const std::string& avoider = "orca3d") {
  std::string vehicles;
  for (std::size_t i = 0; i < radii.size(); ++i)
    vehicles += fmt::format("{}{{start: {{position_m: [0, {}, 0]}}, radius_m: {}}}", i == 0 ? "" : ", ",
                            90 * i, radii[i]);
  return misfits(
      parse_scenario("{fairway: 1, name: s, defaults: {model: minerva_transport, avoider: " + avoider +
                         "}, perception: " + perception + ", vehicles: [" + vehicles + "]}",
                     "s.yaml"),
      builtin_catalogs());
}

TEST(Misfits, TellOfSpheresThatTouchBeforeTheyArePerceived) {
  const std::string within = "perceives others within 15 m (perception.range_m), and spheres touch at ";
  EXPECT_THAT(told_of_spheres({40, 40}, "{range_m: 15}"),
              ElementsAre("robot0 and 1 other: orca3d " + within + "80 m"));
  EXPECT_THAT(told_of_spheres({1, 14.5, 1}, "{range_m: 15}"),
              ElementsAre("robot0 and 2 others: orca3d " + within + "15.5 m"));
  EXPECT_THAT(told_of_spheres({1, 12, 13}, "{range_m: 15}"),
              ElementsAre("robot1 and 1 other: orca3d " + within + "25 m"));
  EXPECT_THAT(told_of_spheres({7, 8}, "{range_m: 15}"), IsEmpty());  // as they touch, they perceive
  EXPECT_THAT(told_of_spheres({40}, "{range_m: 15}"), IsEmpty());    // nobody else is there
  EXPECT_THAT(told_of_spheres({40, 40}, "perfect"), IsEmpty());      // without a bound
  EXPECT_THAT(told_of_spheres({40, 40}, "{kind: sonar, range_m: 15}"), IsEmpty());  // it sees by itself
  EXPECT_THAT(told_of_spheres({40, 40}, "{range_m: 15}", "direct"),
              IsEmpty());  // it is there to avoid nobody
  EXPECT_THAT(told_of_spheres({40, 40}, "{range_m: 15}", "direct+safety_filter"),
              ElementsAre("robot0 and 1 other: direct+safety_filter " + within + "80 m"));
}

TEST(Misfits, NameTheFirstOfManyAndCountTheOthers) {
  const Scenario scenario = parse_scenario(
      "{fairway: 1, name: s, defaults: {model: sparus2, avoider: orca3d, tracking: raw}, "
      "fleet: {count: 8, places: {lattice: {spacing_m: 11}}}}",
      "s.yaml");
  EXPECT_THAT(
      misfits(scenario, builtin_catalogs()),
      ElementsAre("robot0 and 7 others: orca3d moves a point that goes any way at once, and sparus2 has "
                  "to turn first"));
}

TEST(Tracking, OfAVehicleThatCannotTurnIsRefused) {
  const auto refused = [](const std::string& model, const std::string& avoider) {
    const Scenario scenario = alone(model, avoider, "auto");
    return refusal_by([&] { (void)make_agent(scenario.vehicles[0], scenario, builtin_catalogs()); });
  };
  EXPECT_THAT(refused("{name: kinematic, max_turn_rate_radps: 0}", "orca2d"),
              testing::AllOf(testing::HasSubstr("vehicles[0].model"), testing::HasSubstr("orca2d+trackable"),
                             testing::HasSubstr("turn rates above zero")));
  EXPECT_EQ(refused("{name: kinematic, max_turn_rate_radps: 0, max_sway_mps: 0.5}", "orca2d+safety_filter"),
            "accepted");
  EXPECT_EQ(refused("kinematic", "orca2d"), "accepted");
}

TEST(Misfits, WhatGoesSidewaysWithInertiaNeedsRoomAmongWhatStandsOrDrifts) {
  const std::string buoy = ", obstacles: [{sphere: {position_m: [20, 0, 0], radius_m: 1}}]";
  const std::string wanted =
      "robot0: orca2d leaves no room for the time that minerva takes to follow, and something stands or "
      "drifts: "
      "orca2d+safety_filter+way_round does";
  EXPECT_THAT(told("minerva", "orca2d", "auto", buoy), Contains(wanted));
  EXPECT_THAT(told("minerva", "orca2d", "raw", buoy), Not(Contains(wanted)));
  EXPECT_THAT(told("minerva", "orca2d", "auto"), Not(Contains(wanted)));
  EXPECT_THAT(told("minerva", "orca2d+safety_filter+way_round", "auto", buoy), IsEmpty());
}

}  // namespace
}  // namespace fairway
