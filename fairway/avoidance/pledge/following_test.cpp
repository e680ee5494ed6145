// SPDX-License-Identifier: Apache-2.0
// How a member steers.
#include "fairway/avoidance/pledge/following.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fairway/core/angles.hpp"

namespace fairway::pledge {
namespace {

// A hull without sway thrusters that turns is set aside by its own turning: were all of that made up for, it
// would go on turning after it, round and round.
TEST(Following, WhoIsHeldInACurrentTurnsItsBowAgainstItHoweverItIsSetAside) {
  const Vec3 current{0.1, 0.0, 0.0};
  for (int tenth = -31; tenth <= 31; ++tenth) {
    for (const double sway : {-0.2, -0.12, 0.0, 0.12, 0.2}) {
      Situation s{.period = 0.1, .current = current};
      s.own.yaw = 0.1 * tenth;
      const Vec2 abeam = starboard_of(unit_at(s.own.yaw));
      s.own.velocity = current + sway * Vec3{abeam.x(), abeam.y(), 0.0};
      s.limits = {.max_speed = 0.5, .max_climb_rate = 0.3};
      const double off = wrap_angle(std::numbers::pi - s.own.yaw);
      const double turn_rate = *held(s, Vec3::Zero(), "").turn_rate;
      if (std::fabs(off) < 0.6 || std::fabs(off) > 2.5) continue;
      EXPECT_GT(turn_rate * off, 0.0) << "heading " << s.own.yaw << ", set aside by " << sway;
    }
  }
}

TEST(Following, WhoIsHeldGoesALittleWayBackAsternWithoutTurningRound) {
  Envelope envelope;
  envelope.astern = 0.3;
  Situation s{.period = 0.1, .envelope = &envelope};
  s.limits = {.max_speed = 0.5, .max_climb_rate = 0.3};
  s.own.position = {0.5, 0.0, 0.0};
  const Command astern = held(s, Vec3::Zero(), "");
  EXPECT_LT(astern.velocity.x(), -0.1);
  EXPECT_EQ(*astern.turn_rate, 0.0);
  s.own.position = {0.0, 0.5, 0.0};  // its anchor is to port
  EXPECT_LT(*held(s, Vec3::Zero(), "").turn_rate, -0.1);
  envelope.astern = 0.0;
  s.own.position = {0.5, 0.0, 0.0};
  EXPECT_GT(std::fabs(*held(s, Vec3::Zero(), "").turn_rate), 0.1) << "who cannot go astern turns round";
}

TEST(Following, OwnSphereIsLargerByWhatTheTubeDoesNotHoldOfAnUnsurePlace) {
  EXPECT_EQ(beyond_tube({}, 0.1), 0.0) << "whose navigation states nothing keeps its tube as it always did";
  EXPECT_EQ(beyond_tube({.position_sigma = 0.25}, 1.0), 0.0);
  EXPECT_EQ(beyond_tube({.position_sigma = 1.0}, 1.0), 1.5);
  EXPECT_EQ(beyond_tube({.position_sigma = 1.0}, 2.5), 0.0);
}

TEST(Following, WhoseFloorLeavesNoRoomForAllLevelsTellsThatItKeepsItsOwn) {
  Situation s{.period = 0.1};
  s.own.radius = 1.5;
  s.limits = {.max_speed = 0.5, .max_climb_rate = 0.3};
  s.goal = {.position = {40.0, 0.0, 5.0}, .cruise_speed = 0.5};
  const Vec3 here{0.0, 0.0, 5.0}, below{40.0, 0.0, 15.0};
  EXPECT_TRUE(has_levels(member_of(s, 0.9, here, s.goal.position)));
  const double deepest = 5.0 + most_levels * level_step(member_of(s, 0.9));
  s.limits.max_depth = deepest + 1.1;
  EXPECT_TRUE(has_levels(member_of(s, 0.9, here, s.goal.position)));
  s.limits.max_depth = deepest;
  EXPECT_FALSE(has_levels(member_of(s, 0.9, here, s.goal.position)));
  EXPECT_GT(member_of(s, 0.9, here, below).descent, 0.2) << "to a place that is deeper it dives as ever";
}

TEST(Following, WhoIsSlowPromisesNoMoreThanItCanKeepAndOthersTheNearestThatCanBeTold) {
  const auto promised = [](double most) {
    Situation s{.period = 0.1};
    s.limits = {.max_speed = most, .max_climb_rate = 0.3};
    s.goal = {.position = {40.0, 0.0, 0.0}, .cruise_speed = 2.0};
    return as_told(member_of(s, 0.95, Vec3::Zero(), s.goal.position), Vec2::Zero());
  };
  for (double most = 0.022; most < 1.2; most += 0.001) {
    const Member told = promised(most);
    EXPECT_LE(told.speed, 0.98 * most) << most;
    EXPECT_GE(told.speed, 0.95 * most - 0.02) << most;
    EXPECT_LE(told.climb, most) << most;
  }
  for (const auto& [most, speed] :
       {std::pair{0.3, 0.28}, {0.4, 0.38}, {0.5, 0.48}, {0.8, 0.76}, {1.0, 0.96}, {1.2, 1.14}})
    EXPECT_NEAR(promised(most).speed, speed, 1e-12) << "0.95 of it, to the nearest step";
  EXPECT_EQ(promised(0.5).climb, 0.3);
}

// Who learns only at a gate that it has to stop there has come a length too far by the time it does.
TEST(Following, WhoMayHaveToStopAtAGateSlowsDownBeforeIt) {
  Reference way;
  way.add({0.0, {0.0, 0.0, 5.0}});
  way.add({100.0, {40.0, 0.0, 5.0}});
  Situation s{.time = 50.0, .period = 0.1};
  s.own.position = way.at(s.time);
  s.limits = {.max_speed = 0.5, .max_climb_rate = 0.3};
  const auto ahead = [&](double stops) {
    return followed(s, way, 5.0, {.gain = 0.3, .tube = 1.0, .stops = stops}).velocity.x();
  };
  EXPECT_NEAR(ahead(never), 0.4, 1e-9);
  EXPECT_NEAR(ahead(53.0), 0.4, 1e-9);
  EXPECT_NEAR(ahead(51.5), 0.0, 1e-9);
}

}  // namespace
}  // namespace fairway::pledge
