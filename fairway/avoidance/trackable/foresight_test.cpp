// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/foresight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/testing/boat.hpp"

namespace fairway::trackable {
namespace {

using encounters::buoy;
using encounters::of_a_boat;
using encounters::of_a_torpedo;
using encounters::OwnedSituation;
using encounters::track;
using encounters::under_way;

/// An island of `corners`, of a radius of 2 m.
std::vector<Vec3> island(double north, double east, int corners) {
  std::vector<Vec3> vertices;
  for (int i = 0; i < corners; ++i) {
    const Vec2 at = Vec2{north, east} + 2.0 * unit_at(2.0 * pi * i / corners);
    vertices.push_back({at.x(), at.y(), 50.0});
  }
  return vertices;
}

OwnedSituation northbound(const Envelope& envelope) {
  OwnedSituation e = under_way(envelope);
  e.situation.own.position = {0.0, 0.0, 50.0};
  e.situation.goal = {.position = {60.0, 0.0, 50.0}, .cruise_speed = 1.0};
  return e;
}

Command answer(const char* method, const Situation& s) { return builtin_avoiders().make(method).decide(s); }

TEST(Foresight, NoNumberOfCornersHidesWhatMoves) {
  const Envelope boat = of_a_boat();
  for (const char* method : {"trackable", "safety_filter"}) {
    for (const int corners : {8, 64, 500}) {
      OwnedSituation e = northbound(boat);
      e.add_polygon(island(-6.0, 0.0, corners));
      EXPECT_EQ(answer(method, e).mode, Mode::cruise) << method << corners;
      e.tracks = {track(1, {7.0, 0.0, 50.0}, {-1.0, 0.0, 0.0})};
      EXPECT_NE(answer(method, e).mode, Mode::cruise) << method << corners;
      e.tracks[0].position.x() = 14.0;
      const Command command = answer(method, e);
      EXPECT_EQ(command.mode, Mode::avoid) << method << corners;
      EXPECT_EQ(command.note, corners == 8 ? "" : words_of_left_out) << method << corners;
    }
  }
}

TEST(Foresight, OfTooManyStonesTheNearestCount) {
  // 100 pebbles abeam, as listed before the buoy ahead
  const Envelope boat = of_a_boat();
  OwnedSituation e = northbound(boat);
  for (int i = 0; i < 100; ++i) e.obstacles.push_back(buoy(-3.0 + 0.01 * i, 9.0, 0.1));
  EXPECT_EQ(answer("trackable", e).mode, Mode::cruise);
  EXPECT_EQ(answer("trackable", e).note, words_of_left_out);
  e.obstacles.push_back(buoy(5.0, 0.0));
  EXPECT_EQ(answer("trackable", e).mode, Mode::avoid);
}

TEST(Foresight, NoNumberOfVesselsHidesAWall) {
  // 70 vessels at anchor to port, and a wall across the way that is nearer than the last of them
  const Envelope boat = of_a_boat();
  OwnedSituation e = northbound(boat);
  for (int i = 0; i < 70; ++i)
    e.tracks.push_back(track(static_cast<std::uint32_t>(i + 1), {0.01 * i, -8.0, 50.0}, Vec3::Zero(), 0.5));
  EXPECT_EQ(answer("trackable", e.sorted()).mode, Mode::cruise);
  e.obstacles = {encounters::wall({5.0, -4.0, 50.0}, {5.0, 20.0, 50.0})};
  EXPECT_EQ(answer("trackable", e).mode, Mode::avoid);
}

TEST(Foresight, TheOrderOfWhatFitsDoesNotMatterToTheBit) {
  const Envelope boat = of_a_boat();
  for (std::uint64_t i = 0; i < 100; ++i) {
    Rng rng = Rng{5}.stream("order", i);
    OwnedSituation e = northbound(boat);
    for (int k = 0; k < 30; ++k)
      e.obstacles.push_back(buoy(rng.uniform(-3.0, 15.0), rng.uniform(-9.0, 9.0), rng.uniform(0.1, 1.0)));
    const Command expected = answer("trackable", e);
    std::ranges::reverse(e.obstacles);
    EXPECT_EQ(answer("trackable", e), expected) << i;
  }
}

/// Who takes 233 s to go round: steps of 4.9 s.
Envelope of_a_slow_turner() {
  Envelope envelope = of_a_torpedo();
  envelope.turn_rates.fill(0.03);
  return envelope;
}

TEST(Foresight, WhatIsMetWithinTheFirstStepIsSeen) {
  const Envelope torpedo = of_a_slow_turner();
  for (const char* method : {"trackable", "safety_filter"}) {
    for (double range = 4.0; range < 30.0; range += 0.5) {
      OwnedSituation e = northbound(torpedo);
      e.tracks = {track(1, {range, 0.0, 50.0}, {-4.0, 0.0, 0.0})};
      EXPECT_NE(answer(method, e).mode, Mode::cruise) << method << range;
    }
  }
}

TEST(Foresight, AWallThatIsCrossedWithinAStepIsSeen) {
  const Envelope torpedo = of_a_slow_turner();
  for (double range = 1.2; range < 10.0; range += 0.1) {
    OwnedSituation e = northbound(torpedo);
    e.obstacles = {encounters::wall({range, -1.0, 50.0}, {range, 2.0, 50.0})};
    const TurnLaw law{torpedo, Limits::none};
    const Situation s = e;
    const Foresight foresight{law, s, Vec2::UnitX(), {.hold = 0.8, .window = 234.0, .margin = 0.3}};
    EXPECT_FALSE(foresight.is_clear({.speed = 1.0}, 1.0)) << range;
  }
}

TEST(Foresight, NoPlanThatIsClearMeetsAnything) {
  // steps of 4.9 s among what is quick, each looked at in 200 parts
  const Envelope torpedo = of_a_slow_turner();
  const TurnLaw law{torpedo, Limits::none};
  int clear = 0, not_clear = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Rng rng = Rng{9}.stream("quick", i);
    OwnedSituation e = northbound(torpedo);
    const std::uint64_t count = 1 + rng.index(3);
    for (std::uint64_t k = 0; k < count; ++k) {
      const Vec2 at = rng.uniform(2.2, 25.0) * unit_at(rng.uniform(-pi, pi));
      const Vec2 v = rng.uniform(0.0, 5.0) * unit_at(rng.uniform(-pi, pi));
      e.tracks.push_back(track(static_cast<std::uint32_t>(k + 1), {at.x(), at.y(), 50.0}, {v.x(), v.y(), 0}));
    }
    const Situation s = e.sorted();
    const Foresight foresight{law, s, Vec2::UnitX(), {.hold = 0.8, .window = 234.0, .margin = 0.3}};
    for (int k = 0; k < 20; ++k) {
      const Plan plan{.direction = unit_at(rng.uniform(-pi, pi)), .speed = rng.uniform(1.0, 1.5)};
      ++(foresight.is_clear(plan, plan.speed) ? clear : not_clear);
      if (!foresight.is_clear(plan, plan.speed)) continue;
      const Foresight::Path path = foresight.path(plan);
      Vec2 before = Vec2::Zero();
      for (std::size_t step = 0; step < path.count; ++step) {
        for (int part = 1; part <= 200; ++part) {
          const double share = part / 200.0;
          const Vec2 own = before + share * (path.points[step] - before);
          const double time = (static_cast<double>(step) + share) * foresight.step();
          for (const Track& t : s.tracks)
            ASSERT_GE((t.position.head<2>() + time * t.velocity.head<2>() - own).norm(), 2.0)
                << i << ' ' << k;
        }
        before = path.points[step];
      }
    }
  }
  EXPECT_GT(clear, 300);
  EXPECT_GT(not_clear, 300);
}

TEST(Foresight, WhoMustTurnAndDoesNotKnowHowSaysSo) {
  for (const char* method : {"trackable", "safety_filter"}) {
    OwnedSituation e = encounters::open_water();
    EXPECT_EQ(answer(method, e).note, "");
    e.situation.limits.sway = false;
    EXPECT_NE(answer(method, e).note.find("envelope"), std::string_view::npos) << method;
    const Envelope boat = of_a_boat();
    e.situation.envelope = &boat;
    EXPECT_EQ(answer(method, e).note, "") << method;
  }
}

}  // namespace
}  // namespace fairway::trackable
