// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/symmetry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/testing/fleet.hpp"

namespace fairway {
namespace {

using encounters::Fleet;

constexpr double degree = pi / 180.0;
constexpr double range = 20.0;

/// How far the preferred velocity is turned to starboard [rad].
double lean(const Situation& s, Symmetry symmetry, std::uint64_t seed = 1) {
  Rng rng{seed};
  const Vec3 v = preferred_velocity(s, symmetry, Context{rng}, range), straight = s.preferred_velocity();
  EXPECT_NEAR(v.norm(), straight.norm(), 1e-15);
  EXPECT_EQ(rng, Rng{seed});
  return wrap_angle(std::atan2(v.y(), v.x()) - std::atan2(straight.y(), straight.x()));
}

TEST(Symmetry, EveryoneLeansToStarboardForTheMiddleOfWhatIsAhead) {
  EXPECT_EQ(lean(encounters::head_on(), Symmetry::none), 0.0);
  EXPECT_NEAR(lean(encounters::head_on(), Symmetry::starboard), 10 * degree, 1e-15);
  EXPECT_EQ(lean(encounters::open_water(), Symmetry::starboard), 0.0);
}

TEST(Symmetry, AQuarterOfTheRadiiAsideIsNoSymmetry) {
  for (const double aside : {0.49, 0.51, -0.49, -0.51}) {  // of radii that sum to 2 m
    encounters::OwnedSituation e = encounters::open_water();
    e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {8, aside, 50}, .radius = 1}};
    EXPECT_EQ(lean(e, Symmetry::starboard) != 0.0, std::abs(aside) < 0.5) << aside;
  }
}

TEST(Symmetry, WhatIsAsternOrOutOfRangeIsNone) {
  EXPECT_EQ(lean(encounters::head_on(-8.0), Symmetry::starboard), 0.0);
  EXPECT_EQ(lean(encounters::head_on(21.0), Symmetry::starboard), 0.0);
}

TEST(Symmetry, AWallSquareToTheCourseIsOneToo) {
  encounters::OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {8, -5, 50}, .to = {8, 5, 50}}};
  EXPECT_NEAR(lean(e, Symmetry::starboard), 10 * degree, 1e-15);
}

TEST(Symmetry, WhatIsDrawnStaysAndIsToEitherSide) {
  int to_starboard = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const double angle = lean(encounters::head_on(), Symmetry::drawn, seed);
    EXPECT_EQ(lean(encounters::head_on(), Symmetry::drawn, seed), angle);
    EXPECT_GE(std::abs(angle), 5 * degree - 1e-15);
    EXPECT_LE(std::abs(angle), 15 * degree + 1e-15);
    to_starboard += angle > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(to_starboard, 50, 20);  // four standard deviations of 100 fair draws
}

TEST(Symmetry, ByIdTheLargerOneLeansAndEveryoneForWhatDoesNotReact) {
  encounters::OwnedSituation e = encounters::head_on();
  EXPECT_EQ(lean(e, Symmetry::by_id), 0.0);  // own ship has id 0
  e.situation.own.id = VehicleId{2};
  EXPECT_NEAR(lean(e, Symmetry::by_id), 10 * degree, 1e-15);
  e.situation.own.id = VehicleId{0};
  e.tracks[0].reacts = false;
  EXPECT_NEAR(lean(e, Symmetry::by_id), 10 * degree, 1e-15);
}

void sail(Fleet& fleet, const std::string& method, const std::string& rule, double duration) {
  fleet.sail(duration, [&](std::size_t i) {
    return builtin_avoiders().make(method, {{"symmetry", rule}}, Rng{1}.stream("avoider", i));
  });
}

Fleet circle(int count) {
  Fleet fleet;
  for (int i = 0; i < count; ++i) {
    const double bearing = 2.0 * pi * i / count;
    const Vec3 out{15.0 * std::cos(bearing), 15.0 * std::sin(bearing), 0.0};
    fleet.add(out, -out);
  }
  return fleet;
}

class SymmetryOf : public ::testing::TestWithParam<const char*> {};

TEST_P(SymmetryOf, ASphereExactlyAheadIsPassedByEveryRule) {
  for (const char* rule : {"starboard", "drawn", "by_id"}) {
    Fleet fleet;
    fleet.add({0, 0, 0}, {30, 0, 0});
    fleet.obstacles = {encounters::sphere(15, 0, 2)};
    sail(fleet, GetParam(), rule, 120.0);
    EXPECT_EQ(fleet.arrived(), 1) << rule;
  }
}

TEST_P(SymmetryOf, FourOnACrossAndEightOnACircleChangePlacesByEveryRule) {
  for (const char* rule : {"starboard", "drawn", "by_id"}) {
    for (const int count : {2, 4, 8}) {
      Fleet fleet = circle(count);
      sail(fleet, GetParam(), rule, 300.0);
      EXPECT_EQ(fleet.arrived(), count) << rule << " " << count << " least " << fleet.separation;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfThose, SymmetryOf, ::testing::Values("vo", "rvo", "hrvo", "orca2d", "orca3d"));

}  // namespace
}  // namespace fairway
