// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "fairway/scenario/load.hpp"

namespace fairway {
namespace {

using ::testing::HasSubstr;

std::string fleet_document(const std::string& fleet, const std::string& more = "") {
  return "fairway: 1\nname: a\ndefaults: {model: kinematic, avoider: orca3d, radius_m: 1}\nfleet: " + fleet +
         "\n" + more + "\n";
}

Scenario loaded_fleet(const std::string& fleet, const std::string& more = "",
                      std::optional<std::uint64_t> seed = {}) {
  return parse_scenario(fleet_document(fleet, more), "f.yaml", {}, seed);
}

std::string refused_fleet(const std::string& fleet, const std::string& more = "") {
  try {
    loaded_fleet(fleet, more);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

double least_distance(const Scenario& scenario) {
  double least = INFINITY;
  for (const VehicleSpec& a : scenario.vehicles) {
    for (const VehicleSpec& b : scenario.vehicles) {
      if (a.id != b.id) least = std::fmin(least, (a.position - b.position).norm());
    }
  }
  return least;
}

TEST(Fleet, ALatticeIsACubeRoundItsCentre) {
  const Scenario scenario =
      loaded_fleet("{count: 27, places: {lattice: {spacing_m: 5, centre_m: [1, 2, 30]}}}");
  ASSERT_EQ(scenario.vehicles.size(), 27U);
  EXPECT_NEAR(least_distance(scenario), 5.0, 1e-12);
  EXPECT_EQ(scenario.vehicles[0].position, Vec3(-4, -3, 25));
  EXPECT_EQ(scenario.vehicles[26].position, Vec3(6, 7, 35));
  EXPECT_EQ(scenario.vehicles[26].name, "robot26");
  EXPECT_EQ(scenario.vehicles[3].model->name, "kinematic");
}

TEST(Fleet, EachGoesToThePlaceOppositeTheMiddleAndHeadsForIt) {
  for (const VehicleSpec& vehicle :
       loaded_fleet("{count: 50, places: {sphere: {radius_m: 40, centre_m: [0, 0, "
                    "50]}}, speed_mps: 0.3, arrival_m: 2}")
           .vehicles) {
    const Vec3 from = vehicle.position - Vec3{0, 0, 50};
    EXPECT_NEAR(from.norm(), 40.0, 1e-9);
    ASSERT_EQ(vehicle.mission.size(), 1U);
    const Leg& leg = vehicle.mission[0];
    EXPECT_NEAR((leg.position - Vec3(0, 0, 50) + from).norm(), 0.0, 1e-9);
    EXPECT_EQ(leg.speed_mps, 0.3);
    EXPECT_EQ(leg.arrival_m, 2.0);
    EXPECT_NEAR(vehicle.yaw, std::atan2(-from.y(), -from.x()), 1e-9);
  }
}

TEST(Fleet, ABoxIsFilledEvenly) {
  const Scenario scenario = loaded_fleet("{count: 100, places: {box: {size_m: [90, 90, 0]}}}");
  EXPECT_NEAR(least_distance(scenario), 10.0, 1e-9);
  for (const VehicleSpec& vehicle : scenario.vehicles) EXPECT_EQ(vehicle.position.z(), 0.0);
}

TEST(Fleet, ABoxWithRoomToSpareIsFilledFromTopToBottomAndEachFacesAnother) {
  const Scenario scenario =
      loaded_fleet("{count: 10, places: {box: {size_m: [100, 100, 100], centre_m: [0, 0, 60]}}}");
  std::map<double, int> at_depth;  // 27 places for ten
  for (const VehicleSpec& vehicle : scenario.vehicles) {
    ++at_depth[vehicle.position.z()];
    const Vec3 opposite = Vec3{0, 0, 120} - vehicle.position;
    EXPECT_TRUE(std::ranges::any_of(scenario.vehicles, [&](const VehicleSpec& other) {
      return (other.position - opposite).norm() < 1e-9;
    })) << vehicle.name;
  }
  EXPECT_EQ(at_depth, (std::map<double, int>{{10.0, 3}, {60.0, 4}, {110.0, 3}}));
  EXPECT_GE(least_distance(scenario), 50.0 - 1e-9);
}

TEST(Fleet, PlacesAreDrawnBySeedAndKeepTheirDistance) {
  const std::string fleet =
      "{count: 200, places: {draw: {size_m: [100, 100, 20], spacing_m: 6}}, goals: shuffled}";
  const Scenario one = loaded_fleet(fleet, "", 1);
  EXPECT_GE(least_distance(one), 6.0);
  EXPECT_EQ(one.vehicles[7].position, loaded_fleet(fleet, "seed: 1").vehicles[7].position);
  EXPECT_NE(one.vehicles[7].position, loaded_fleet(fleet, "", 2).vehicles[7].position);
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::set<Vec3, decltype(less)> starts(less), goals(less);
  for (const VehicleSpec& vehicle : one.vehicles) {
    starts.insert(vehicle.position);
    goals.insert(vehicle.mission[0].position);
  }
  EXPECT_EQ(starts, goals);
}

TEST(Fleet, ItFollowsTheVehiclesThatAreListedAndYieldsToTheDefaults) {
  const Scenario scenario = parse_scenario(
      "{fairway: 1, name: a, defaults: {model: m, avoider: b, start: {yaw_deg: 90}, mission: []}, "
      "vehicles: [{name: first, start: {position_m: [99, 0, 0]}}], "
      "fleet: {count: 4, places: {lattice: {spacing_m: 9}}}}",
      "f.yaml", {{"fleet.count", "8"}, {"vehicles[5].radius_m", "2"}});
  ASSERT_EQ(scenario.vehicles.size(), 9U);
  EXPECT_EQ(scenario.vehicles[0].name, "first");
  EXPECT_EQ(scenario.vehicles[5].radius_m, 2.0);
  EXPECT_DOUBLE_EQ(scenario.vehicles[8].yaw, std::acos(0.0));
  EXPECT_TRUE(scenario.vehicles[8].mission.empty());
}

TEST(Fleet, WrittenAndReadAgainItIsTheSame) {
  const Scenario scenario = loaded_fleet("{count: 300, places: {sphere: {radius_m: 200}}}");
  const std::string text = to_yaml(scenario);
  EXPECT_EQ(to_yaml(parse_scenario(text, "again.yaml")), text);
}

TEST(Fleet, WhatCannotBeIsRefusedInOneLine) {
  EXPECT_EQ(refused_fleet("{count: 0, places: {lattice: {spacing_m: 5}}}"),
            "f.yaml:4:16: fleet.count: expected a whole number in [1, 100000], got 0");
  EXPECT_EQ(refused_fleet("{count: 10000000, places: {lattice: {spacing_m: 5}}}"),
            "f.yaml:4:16: fleet.count: expected a whole number in [1, 100000], got 10000000");
  EXPECT_EQ(refused_fleet("{count: 8, places: {latice: {spacing_m: 5}}}"),
            "f.yaml:4:28: fleet.places.latice: unknown kind; did you mean lattice?");
  EXPECT_EQ(refused_fleet("{count: 8, places: {lattice: {spacing: 5}}}"),
            "f.yaml:4:38: fleet.places.lattice.spacing: unknown key; did you mean spacing_m?");
  EXPECT_THAT(refused_fleet("{count: 8, places: {lattice: {spacing_m: .nan}}}"),
              HasSubstr("fleet.places.lattice.spacing_m"));
  EXPECT_EQ(refused_fleet("{count: 8, places: {lattice: {spacing_m: 1.5}}}"),
            "f.yaml:4:8: fleet: robot0 and robot1 start 1.5 m apart, and their spheres of radius_m 1 and 1 "
            "overlap; "
            "give them room, or write coincident_start: true");
  EXPECT_EQ(refused_fleet("{count: 8, places: {lattice: {spacing_m: 1.5}}}", "coincident_start: true"), "");
  EXPECT_EQ(refused_fleet("{count: 8, places: {box: {size_m: [0, 0, 0]}}}"),
            "f.yaml:4:8: fleet: a box without any size has one place");
  EXPECT_THAT(refused_fleet("{count: 900, places: {draw: {size_m: [10, 10, 10], spacing_m: 5}}}"),
              HasSubstr("fleet: no room was found for 900 vehicles 5 m apart"));
  EXPECT_EQ(
      refused_fleet("{count: 8, places: {lattice: {spacing_m: 5}, box: {size_m: [9, 9, 0]}}}"),
      "f.yaml:4:27: fleet.places: expected a mapping with one key of lattice, sphere, box, draw, got one "
      "with 2, such as lattice and box");
  EXPECT_EQ(
      refused_fleet("{count: 6, places: {lattice: {spacing_m: 9}}}",
                    "vehicles: [{name: robot5, start: {position_m: [0, 50, 0]}}]"),
      "f.yaml:4:8: vehicles[5].name: robot5 is the name of vehicles[0], too; expected another name there, "
      "since this one follows from an id");
  EXPECT_THAT(refused_fleet("{count: 8, places: {lattice: {spacing_m: 9}}, goals: there}"),
              HasSubstr("fleet.goals: expected opposite or shuffled"));
  EXPECT_THAT(refused_fleet("{count: 99999, places: {lattice: {spacing_m: 9}}}",
                            "vehicles: [{start: {position_m: [0, 0, 0]}}, {start: {position_m: [2, 0, 0]}}]"),
              HasSubstr("100001 vehicles; a scenario has 1 to 100000"));
}

}  // namespace
}  // namespace fairway
