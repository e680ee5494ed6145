// SPDX-License-Identifier: Apache-2.0
// What the method does of itself, beside the agreement that it takes part in.
#include "fairway/avoidance/pledge/pledge.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace fairway {
namespace {

using pledge::Reference;

/// What member 1 says: it is lost at (20, 0, 5) and drifts so.
Speech said_at(double time, const Vec3& drift = Vec3::Zero()) {
  pledge::Agreement other{1, {.count = 2, .tubes = {.radius = 1.0, .told = 0.1}}};
  other.hold({.anchor = {20.0, 0.0, 5.0}, .destination = {-20.0, 0.0, 5.0}, .radius = 1.5, .speed = 0.4});
  other.lose({20.0, 0.0, 5.0}, drift);
  return other.say(time, 3.2);
}
Heard from_who_is_lost() { return {.from = VehicleId{1}, .sent = 0.0, .speech = said_at(0.0)}; }

/// Member 0 at rest at (0, 0, 5), which has heard that once and hears nothing more.
struct Alone {
  std::array<Heard, 1> heard{from_who_is_lost()};
  Link link{.heard = heard, .turn_period = 3.2, .next_turn = 1e9};
  Pledge method{.params = {.team_count = 2}};
  Pledge::Memory memory;
  Rng rng{1};
  Context context{rng};
  std::vector<Obstacle> obstacles;
  Vec3 position{0.0, 0.0, 5.0}, velocity{0.0, 0.0, 0.0}, goal{40.0, 0.0, 5.0};
  double radius{1.5};

  Command decide(double time) {
    Situation s{.time = time, .period = 0.1};
    s.own = {.id = VehicleId{0}, .position = position, .velocity = velocity, .radius = radius};
    s.goal = {.position = goal, .cruise_speed = 0.5, .arrival = 1.0};
    s.limits = {.max_speed = 0.5, .max_climb_rate = 0.3};
    s.link = &link;
    s.attendance = Attendance::under_way;
    s.obstacles = obstacles;
    return method.decide(s, memory, context);
  }
  bool fears(double time) const {
    return memory.agreement.meets_lost(Reference{Vec3{0.0, 0.0, 5.0}}, time, time + 1.0);
  }
};

// The clock of a word goes round in 409.6 s: taken again, it would seem to have been said a moment ago.
TEST(Pledge, AWordThatWasHeardOnceDoesNotBecomeNewsWhenItsClockHasGoneRound) {
  Alone member;
  for (int tenth = 0; tenth <= 5000; ++tenth) {
    const double time = 0.1 * tenth;
    member.decide(time);
    if (tenth == 1000) {
      EXPECT_FALSE(member.fears(time)) << "it cannot have drifted so far yet";
    }
    if (tenth >= 2000) {
      ASSERT_TRUE(member.fears(time)) << time;
    }
  }
}

TEST(Pledge, WhoGoesOutOfTheWayDoesSoUntilNobodyWillComeNearForHalfAMinute) {
  Alone member;
  member.heard[0].speech = said_at(0.0, {-0.3, 0.0, 0.0});
  double time = 0.0;
  while (!member.memory.gives_way && time < 60.0) member.decide(time += 0.1);
  EXPECT_GT(time, 20.0);
  EXPECT_LT(time, 40.0);
  member.position.x() -= 1.5;  // somebody comes near there in more than 12 s
  Alone calm = member;
  calm.memory.gives_way = false;
  calm.link.heard = calm.heard;
  member.decide(time + 0.1);
  calm.decide(time + 0.1);
  EXPECT_TRUE(member.memory.gives_way);
  EXPECT_FALSE(calm.memory.gives_way);
}

// Whose thrusters are dead passes through rest on its way from its own speed to that of the current.
TEST(Pledge, WhoWasLostIsHeldAgainOnceItHasRestedForLongAndIsLostForGoodWhenItThenDriftsOff) {
  Alone member;
  member.decide(0.0);
  member.memory.losses = 1;
  member.memory.agreement.lose(member.position, Vec3::Zero());
  const auto status_at = [&](double time) {
    member.decide(time);
    return member.memory.agreement.status();
  };
  EXPECT_EQ(status_at(11.9), pledge::Status::lost);
  EXPECT_EQ(status_at(12.1), pledge::Status::held);
  member.position.x() = 1.2;
  EXPECT_EQ(status_at(20.0), pledge::Status::lost);
  for (const double time : {21.0, 40.0, 100.0}) EXPECT_EQ(status_at(time), pledge::Status::lost);
}

TEST(Pledge, WavesAreNoReasonToBeLostForEverAndACurrentIs) {
  const auto status_after = [](double seconds, double to_and_fro, double current) {
    Alone member;
    member.decide(0.0);
    member.memory.losses = 1;
    member.memory.agreement.lose(member.position, Vec3::Zero());
    for (double time = 0.0; time < seconds; time += 0.1) {
      member.velocity = {current + to_and_fro * std::cos(0.5 * pi * time), 0.0, 0.0};
      member.decide(time);
    }
    return member.memory.agreement.status();
  };
  EXPECT_EQ(status_after(30.0, 0.15, 0.0), pledge::Status::held);
  EXPECT_EQ(status_after(200.0, 0.15, 0.1), pledge::Status::lost);
}

TEST(Pledge, AWordThatItCannotTakeIsSpokenOf) {
  Alone member;
  member.heard[0].speech.bytes[3] ^= 1;
  EXPECT_NE(member.decide(1.0).note.find("cannot read a word"), std::string::npos);
  Alone early;
  early.heard[0].sent = 30.0;
  early.heard[0].speech = said_at(30.0);
  EXPECT_NE(early.decide(0.0).note.find("yet to be said"), std::string::npos);
  EXPECT_EQ(early.decide(29.5).note.find("yet to be said"), std::string::npos);
}

TEST(Pledge, WhoCannotBeToldSaysWhy) {
  const auto why = [](const Vec3& place, double radius, const Vec3& goal) {
    Alone member;
    member.position = place;
    member.radius = radius;
    member.goal = goal;
    const Command command = member.decide(0.0);
    EXPECT_EQ(command.mode, Mode::infeasible);
    return std::string(command.note);
  };
  EXPECT_EQ(why({500, 0, 5}, 1.5, {0, 0, 5}), "it is too far from the datum for its words");
  EXPECT_EQ(why({0, 0, 5}, 1.5, {500, 0, 5}), "its goal is too far from the datum for its words");
  EXPECT_EQ(why({0, 0, 5}, 20.0, {40, 0, 5}), "its sphere is too large for its words");
}

TEST(Pledge, WhoCannotTakePartGoesBackToWhereItWas) {
  Alone member;
  member.radius = 20.0;
  EXPECT_LT(member.decide(0.0).velocity.norm(), 1e-9);
  member.position = {-2.0, 0.0, 5.0};
  const Command back = member.decide(10.0);
  EXPECT_GT(back.velocity.x(), 0.1);
  EXPECT_EQ(back.mode, Mode::infeasible);
  EXPECT_TRUE(back.turn_rate.has_value());
}

TEST(Pledge, WhoLiesOrIsToGoTooNearToWhatStandsSaysSo) {
  const auto note = [](const Vec3& rock) {
    Alone member;
    member.obstacles = {{.kind = Obstacle::Kind::sphere, .position = rock, .radius = 2.0}};
    return std::string(member.decide(0.0).note);
  };
  EXPECT_EQ(note({0.0, 4.4, 5.0}), "lies nearer to an obstacle than its sphere and its tube");
  EXPECT_EQ(note({41.0, 0.0, 5.0}),
            "has no way: its destination is nearer to an obstacle than its sphere and its tube");
  EXPECT_EQ(note({20.0, 0.0, 5.0}).find("obstacle"), std::string::npos);
}

}  // namespace
}  // namespace fairway
