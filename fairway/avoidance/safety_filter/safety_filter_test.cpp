// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/safety_filter/safety_filter.hpp"

#include <gtest/gtest.h>

#include <array>

#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/testing/fleet.hpp"
#include "fairway/avoidance/testing/passage.hpp"

namespace fairway {
namespace {

using encounters::Always;
using encounters::OwnedSituation;
using encounters::Passage;
using encounters::sphere;

Avoider around_direct(SafetyFilter::Params params = {}) {
  return Avoider{SafetyFilter{params}, Avoider{Direct{{}}}};
}

Avoider around(const Command& command, SafetyFilter::Params params = {}) {
  return Avoider{SafetyFilter{params}, Avoider{Always{{}, command}}};
}

/// Own ship of radius 1 m at the surface at rest, 40 m south of its goal.
OwnedSituation at_rest() {
  OwnedSituation e = encounters::shifted(encounters::open_water(), {0.0, 0.0, -50.0});
  e.situation.own.velocity.setZero();
  e.situation.goal.position = {40.0, 0.0, 0.0};
  return e;
}

TEST(SafetyFilter, WhoCannotStopKeepsItsWayAheadInWhateverItIsLedInto) {
  int changed = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    OwnedSituation e = encounters::congested(static_cast<int>(i % 6), Rng{3}.stream("torpedo", i));
    Situation& s = e.situation;
    s.own.velocity = 1.2 * Vec3{std::cos(s.own.yaw), std::sin(s.own.yaw), 0.0};
    s.goal.position.z() = s.own.position.z();
    s.limits = {.max_speed = 1.5, .min_speed = 1.0, .sternway = false, .sway = false};
    if (i % 2 == 0) s.limits.max_acceleration = 0.3;
    const Command asked{.velocity = s.preferred_velocity()};
    const Command answer = around(asked).decide(e);
    if (answer.velocity == asked.velocity) continue;
    const Vec3 bow{std::cos(s.own.yaw), std::sin(s.own.yaw), 0.0};
    EXPECT_GT(answer.velocity.dot(bow), 1.0 - 1e-6) << i;
    ++changed;
  }
  EXPECT_GT(changed, 50);
}

TEST(SafetyFilter, LeavesTheAnswerAsItIsWhereNothingIsNear) {
  const Command asked{.velocity = {0.3, 0.1, -0.2},
                      .mode = Mode::hold,
                      .heading = 0.4,
                      .wrench = Wrench::Constant(3.0),
                      .note = "as it was"};
  OwnedSituation e = at_rest();
  e.obstacles = {sphere(33.1, 0.0, 1.0)};  // 31.1 m from sphere to surface
  EXPECT_EQ(around(asked).decide(e), asked);
}

TEST(SafetyFilter, LeavesTheAnswerAsItIsWhereItKeepsClear) {
  const Command asked{.velocity = {-1.0, 0.1, 0.0}, .heading = 0.4};
  OwnedSituation e = at_rest();
  e.obstacles = {sphere(8.0, 0.0, 1.0)};
  EXPECT_EQ(around(asked).decide(e), asked);
}

TEST(SafetyFilter, AWrenchWithoutAModelIsLeftOutIfAnythingIsNear) {
  const Command asked{.velocity = {-1.0, 0.0, 0.0}, .wrench = Wrench::Constant(3.0)};
  OwnedSituation e = at_rest();
  e.obstacles = {sphere(8.0, 0.0, 1.0)};
  EXPECT_FALSE(around(asked).decide(e).wrench.has_value());
}

TEST(SafetyFilter, CutsTheVelocityBackToWhatTheBarrierAllows) {
  // 6 m between centres, R = 1 + 1 + 0.5: h = 29.75, at rest. Delta . a >= -k1 k2 h / 2, so no faster than
  // T k1 k2 h / (2 * 6) towards it
  OwnedSituation e = at_rest();
  e.obstacles = {sphere(6.0, 0.0, 1.0)};
  const Command command = around_direct({.sidestep_ratio = 0.0}).decide(e);
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_NEAR(command.velocity.x(), 1.5 * 0.3 * 0.3 * 29.75 / 12.0, 1e-12);
  EXPECT_NEAR(command.velocity.y(), 0.0, 1e-12);
}

TEST(SafetyFilter, WhatItChangesIsSteeredByItsVelocityAlone) {
  OwnedSituation e = at_rest();
  e.obstacles = {sphere(6.0, 0.0, 1.0)};
  const Command asked{.velocity = {0.5, 0.0, 0.0}, .heading = 0.4, .turn_rate = 0.3};
  const Command changed = around(asked).decide(e);
  ASSERT_NE(changed.velocity, asked.velocity);
  EXPECT_FALSE(changed.turn_rate) << "by it the step aside would be lost";
  EXPECT_FALSE(changed.heading);
  e.obstacles = {sphere(-20.0, 0.0, 1.0)};
  EXPECT_EQ(around(asked).decide(e).turn_rate, asked.turn_rate);
}

TEST(SafetyFilter, StepsAsideToStarboardOfWhatIsDeadAhead) {
  OwnedSituation e = at_rest();
  e.obstacles = {sphere(6.0, 0.0, 1.0)};
  const Vec3 back = around_direct({.sidestep_ratio = 0.0}).decide(e).velocity;
  const Vec3 aside = around_direct().decide(e).velocity;
  EXPECT_NEAR(aside.x(), back.x(), 1e-12);
  EXPECT_NEAR(aside.y(), 0.2 * (1.0 - back.x()), 1e-12);
}

TEST(SafetyFilter, WithTheLimitOfAccelerationItBrakesSoonerAndNeverHarder) {
  OwnedSituation e = at_rest();
  e.situation.limits.max_acceleration = 0.1;
  e.situation.own.velocity = {0.5, 0.0, 0.0};
  e.obstacles = {sphere(6.0, 0.0, 1.0)};
  int changed = 0;
  for (double bearing = -3.0; bearing < 3.0; bearing += 0.3) {
    const Vec3 asked{std::cos(bearing), std::sin(bearing), 0.0};
    const Command command = around({.velocity = asked}).decide(e);
    if (command.velocity == asked) continue;
    ++changed;
    EXPECT_LE((command.velocity - e.situation.own.velocity).norm(), 0.1 * 1.5 * (1 + 1e-9)) << bearing;
  }
  EXPECT_GT(changed, 5);
}

/// Eight spheres, a triangle and a wall between own ship and its goal; none within 1 m of own sphere.
struct Field {
  OwnedSituation encounter = at_rest();
  std::array<Vec3, 3> triangle;

  explicit Field(Rng rng) {
    std::vector<Obstacle>& obstacles = encounter.obstacles;
    const auto add = [&](const Obstacle& o) {
      if (nearest_point(o, Vec3::Zero()).distance > 2.0) obstacles.push_back(o);
    };
    while (obstacles.size() < 8)
      add(sphere(rng.uniform(0.0, 40.0), rng.uniform(-12.0, 12.0), rng.uniform(0.2, 3.0)));
    const Vec3 corner{rng.uniform(6.0, 30.0), rng.uniform(-10.0, 10.0), 0.0};
    triangle = {corner, corner + Vec3{5.0, -1.0, 0.0}, corner + Vec3{2.0, 5.0, 0.0}};
    add({.kind = Obstacle::Kind::polygon, .vertices = triangle});
    add({.kind = Obstacle::Kind::segment, .from = corner, .to = corner - Vec3{3.0, 4.0, 0.0}});
  }
  Field(const Field&) = delete;
};

TEST(SafetyFilter, AThousandFieldsAreCrossedWithoutATouch) {
  constexpr std::array lags{0.0, 0.5, 1.5};  // up to response_s
  double clearance = 1e9;
  int infeasible = 0, arrived = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Field field{Rng{1}.stream("field", i)};
    const Passage p = passage(field.encounter, around_direct(), {.duration = 60.0, .lag = lags[i % 3]});
    clearance = std::fmin(clearance, p.clearance);
    infeasible += p.infeasible;
    arrived += p.arrival ? 1 : 0;
  }
  EXPECT_GT(clearance, 0.5 - 1e-6);  // measured 0.50000004: the margin
  EXPECT_EQ(infeasible, 0);
  EXPECT_GT(arrived, 300);  // measured 340 within 60 s: it is no planner
}

TEST(SafetyFilter, WhatItsNavigationStatesIsKeptBesideTheMargin) {
  int changed = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Field field{Rng{3}.stream("field", i)};
    const auto answer = [&](double margin) {
      const SafetyFilter filter{.params = {.margin_m = margin}};
      return Avoider{filter, Avoider{Direct{{}}}}.decide(field.encounter);
    };
    const Command plain = answer(0.5), wider = answer(0.75);
    field.encounter.situation.own.position_sigma = 0.125;
    EXPECT_EQ(answer(0.5), wider) << i;
    changed += plain == wider ? 0 : 1;
  }
  EXPECT_GT(changed, 10) << "otherwise nothing was put to the test";
}

TEST(SafetyFilter, WhatComesHeadOnAndDoesNotReactIsPassed) {
  OwnedSituation e = at_rest();
  e.tracks = {encounters::track(1, {35.0, 0.0, 0.0}, {-0.5, 0.0, 0.0}, 2.0)};
  e.tracks[0].reacts = false;
  for (const double lag : {0.0, 1.0, 1.5}) {
    const Passage p = passage(e, around_direct(), {.duration = 150.0, .lag = lag});
    EXPECT_GT(p.clearance, 0.5) << lag;  // measured 1.15 to 1.40
    EXPECT_TRUE(p.arrival) << lag;
  }
}

TEST(SafetyFilter, OfWhatReactsHalfIsLeftToIt) {
  OwnedSituation e = at_rest();
  e.situation.own.velocity = {1.0, 0.0, 0.0};
  e.tracks = {encounters::track(1, {8.0, 0.0, 0.0}, {-1.0, 0.0, 0.0})};
  const SafetyFilter::Params straight{.sidestep_ratio = 0.0};
  const double shared = 1.0 - around_direct(straight).decide(e).velocity.x();
  e.tracks[0].reacts = false;
  e.situation.limits.max_speed = 100.0;
  const double alone = 1.0 - around_direct(straight).decide(e).velocity.x();
  EXPECT_GT(shared, 0.1);
  EXPECT_NEAR(shared, 0.5455, 1e-3);
  EXPECT_NEAR(alone, 0.9172, 1e-3);
}

TEST(SafetyFilter, TwoWhoBothUseItPassEachOther) {
  encounters::Fleet fleet{.cruise_speed = 1.0, .max_speed = 1.5, .lag = 1.5};
  fleet.add({0, 0, 0}, {40, 0, 0});
  fleet.add({40, 0, 0}, {0, 0, 0});
  fleet.sail(150.0, [](std::size_t) { return around_direct(); });
  EXPECT_GT(fleet.separation - 2.0, 0.5);  // measured 2.28
  EXPECT_EQ(fleet.arrived(), 2);
}

TEST(SafetyFilter, TooLateItBrakesToStopAtTheMarginAndSaysSo) {
  // 3 m/s towards a surface 6 m beyond the margin: 3^2 / (2 * 6) = 0.75 m/s2, 1.125 m/s less in 1.5 s
  OwnedSituation e = at_rest();
  e.situation.limits.max_speed = 3.0;
  e.situation.goal.cruise_speed = 3.0;
  e.situation.own.velocity = {3.0, 0.0, 0.0};
  e.obstacles = {sphere(1008.5, 0.0, 1001.0)};
  const Command command = around_direct({.sidestep_ratio = 0.0}).decide(e);
  EXPECT_FALSE(command.note.empty());
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_LE(command.velocity.x(), 3.0 - 1.125 + 1e-9);
  const Passage p = passage(e, around_direct(), {.duration = 100.0, .lag = 1.5});
  EXPECT_GT(p.clearance, 0.5 - 1e-6);  // measured 0.50006
}

TEST(SafetyFilter, NoNumberOfPebblesHidesAVessel) {
  OwnedSituation e = encounters::head_on(6.0);
  e.tracks[0].reacts = false;
  for (int i = 0; i < 260; ++i) e.obstacles.push_back(sphere(-20.0, 0.01 * i, 0.1, 50.0));
  const Command command = around_direct().decide(e);
  EXPECT_NE(command.mode, Mode::cruise);
  EXPECT_LT(command.velocity.x(), 0.5);
}

TEST(SafetyFilter, StraightAheadItGoesToStarboardInTheMirroredSceneToo) {
  OwnedSituation e = at_rest();
  e.obstacles = {sphere(6.0, 0.0, 2.0)};
  e.situation.own.velocity = {1.0, 0.0, 0.0};
  const double aside = around_direct().decide(e).velocity.y();
  EXPECT_GT(aside, 0.0);
  EXPECT_EQ(around_direct().decide(encounters::mirrored(e)).velocity.y(), aside);
  EXPECT_TRUE(SafetyFilter::info.handed);
}

}  // namespace
}  // namespace fairway
