// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/teb.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/trackable/trackable.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/planning/teb/testing/courses.hpp"
#include "fairway/planning/teb/way.hpp"

namespace fairway {
namespace {

using courses::Course;
using courses::disc;
using courses::Voyage;

Voyage voyage(Course course, double speed = 0.4, bool dynamic = false) {
  Voyage v{.course = std::move(course), .teb = {}};
  v.teb.params.max_vel_x_mps = speed;
  if (speed > 1.0) v.teb.params.max_vel_theta_radps = 0.3751;  // of the vessel of campos2019
  v.teb.params.include_dynamic_obstacles = dynamic;
  return v;
}

/// Where the band passes abeam of (n, e): its mean offset to starboard.
double side_of(const Voyage& v, double n, double e) {
  double sum = 0.0, count = 0.0;
  for (const teb::Knot& knot : v.memory.bands.front().knots) {
    if (std::abs(knot[0] - n) > 0.5) continue;
    sum += knot[1] - e;
    count += 1.0;
  }
  return sum / count;
}

// Measured with the original's core in closed loop on these courses, with a vessel that does what it is told.
TEST(Teb, TakesAsLongAsTheOriginalAtThePackagesSpeed) {
  EXPECT_NEAR(voyage(courses::cluttered()).arrival(120).value_or(0), 65.8, 6.6);
  EXPECT_NEAR(voyage(courses::orthogonal()).arrival(120).value_or(0), 61.6, 6.2);
  EXPECT_NEAR(voyage(courses::diagonal()).arrival(120).value_or(0), 66.6, 6.7);
  EXPECT_NEAR(voyage(courses::diagonal(), 0.4, true).arrival(120).value_or(0), 62.2, 6.2);
}

TEST(Teb, TakesAsLongAsTheOriginalAtTheVesselsSpeed) {
  for (const bool dynamic : {false, true}) {
    EXPECT_NEAR(voyage(courses::cluttered(), 1.5, dynamic).arrival(120).value_or(0), 24.8, 2.5);
    EXPECT_NEAR(voyage(courses::orthogonal(), 1.5, dynamic).arrival(120).value_or(0), 23.1, 2.3);
    EXPECT_NEAR(voyage(courses::diagonal(), 1.5, dynamic).arrival(120).value_or(0), 17.9, 1.8);
  }
}

TEST(Teb, KeepsClearOfBuoys) {
  Voyage v = voyage(courses::cluttered(), 1.5);
  ASSERT_TRUE(v.arrival(120));
  EXPECT_GT(v.clearance, 0.5);
}

TEST(Teb, IsLockedInAWallShapedLikeAU) {
  for (const double speed : {0.4, 1.5}) {
    Voyage v = voyage(courses::u_wall(), speed);
    EXPECT_FALSE(v.arrival(40));
    EXPECT_LT(v.position.x(), 6.0);
  }
}

TEST(Teb, TheSameSituationMemoryAndSeedGiveTheSameBits) {
  for (const bool dynamic : {false, true}) {
    Voyage v = voyage(courses::diagonal(), 1.5, dynamic);
    for (int i = 0; i < 40; ++i) v.step();
    Voyage twin = v;
    for (int i = 0; i < 20; ++i) {
      EXPECT_EQ(v.decide(), twin.decide());
      EXPECT_EQ(v.memory.bands, twin.memory.bands);
    }
  }
}

TEST(Teb, TheSideDoesNotHangOnTheLastDigits) {
  Rng rng{11};
  for (int trial = 0; trial < 100; ++trial) {
    Voyage v = voyage({{disc(1.6, 0.2, 0.1)}, {}});
    for (Obstacle& buoy : v.course.buoys) buoy.position.y() += rng.uniform(-1e-9, 1e-9);
    v.position = {rng.uniform(-1e-9, 1e-9), rng.uniform(-1e-9, 1e-9)};
    for (int i = 0; i < 2; ++i) (void)v.decide();
    EXPECT_LT(side_of(v, 1.6, 0.2), 0.0) << trial;
  }
}

TEST(Teb, InOpenWaterTheFrameDoesNotMatter) {
  for (const double angle : {0.7, 2.0, -1.3}) {
    Voyage v = voyage({}), turned = v;
    const Eigen::AngleAxisd by{angle, Vec3::UnitZ()};
    Situation scene = turned.situation();
    scene.own.yaw = angle;
    scene.goal.position = by * scene.goal.position;
    Context context{turned.rng};
    const Command answer = turned.teb.decide(scene, turned.memory, context);
    const Command expected = v.decide();
    EXPECT_LT((answer.velocity - by * expected.velocity).norm(), 1e-5);
    EXPECT_NEAR(*answer.turn_rate, *expected.turn_rate, 1e-5);
  }
}

TEST(Teb, GoesNoFasterThanItsOwnLimitsWhateverTheMissionWants) {
  Voyage v = voyage({});
  for (int i = 0; i < 30; ++i) {
    v.step();
    EXPECT_LE(std::abs(v.speed), 0.4);
    EXPECT_LE(std::abs(v.yaw_rate), 0.3);
  }
  EXPECT_GT(v.speed, 0.35);
  EXPECT_EQ(v.decide().mode, Mode::cruise);
}

TEST(Teb, StandsStillWhereTheMissionWantsNoSpeed) {
  Voyage v = voyage(courses::cluttered());
  Situation s = v.situation();
  Context context{v.rng};
  s.goal.cruise_speed = 0.0;
  EXPECT_EQ(v.teb.decide(s, v.memory, context), Command{});
  s.goal.velocity = Vec3{0.4, 0, 0};  // which then says what is wanted
  EXPECT_GT(v.teb.decide(s, v.memory, context).velocity.norm(), 0.0);
}

// The original has a global planner above it; without one a band cannot bend round what is larger than its
// lookahead.
TEST(Teb, PassesALargeSphereDeadAheadByAPlanAlone) {
  for (const bool dynamic : {false, true}) {
    Voyage v = voyage({{disc(12, 0, 3.0)}, {}}, 0.4, dynamic);
    EXPECT_FALSE(v.arrival(200));
    EXPECT_LT(v.position.x(), 9.0);
    Voyage planned = voyage({{disc(12, 0, 3.0)}, {}}, 0.4, dynamic);
    planned.teb.params.global_plan = TebGlobalPlan::rrt_star;
    EXPECT_LT(planned.arrival(100).value_or(1e9), 80.0);
    EXPECT_GT(planned.clearance, 0.3);
  }
}

TEST(Teb, APlanLeadsOutOfTheU) {
  Voyage v = voyage(courses::u_wall());
  v.teb.params.global_plan = TebGlobalPlan::rrt_star;
  EXPECT_TRUE(v.arrival(200));
  EXPECT_GT(v.clearance, 0.0);
}

TEST(Teb, WhereTheEnvelopeIsKnownItPlansItsWayOutOfTheUUnlessToldNotTo) {
  const Envelope boat = encounters::of_a_boat();
  encounters::OwnedSituation e = encounters::under_way(boat);
  e.situation.period = 0.2;
  e.situation.goal = {.position = {30, 0, 50}, .cruise_speed = 1.0, .arrival = 1.0};
  e.obstacles = {encounters::wall({10, -5, 50}, {15, -5, 50}), encounters::wall({10, 5, 50}, {15, 5, 50}),
                 encounters::wall({15, -5, 50}, {15, 5, 50})};
  const auto left_to_go = [&](TebGlobalPlan way) {
    Teb teb;
    teb.params.global_plan = way;
    const auto sailed = encounters::sail(e, Avoider{Trackable{{}}, Avoider{teb, Rng{1}}}, 45.0);
    EXPECT_GT(sailed.clearance, 0.0);
    return (sailed.end - Vec2{30, 0}).norm();
  };
  EXPECT_LT(left_to_go(TebGlobalPlan::automatic), 2.0);
  EXPECT_GT(left_to_go(TebGlobalPlan::straight), 10.0);
}

TEST(Teb, WhereTheEnvelopeIsKnownNothingWindsAndNothingGoesAstern) {
  const Envelope boat = encounters::of_a_boat();
  encounters::OwnedSituation e = encounters::under_way(boat);
  e.situation.period = 0.2;
  e.situation.goal = {.position = {30, 0, 50}, .cruise_speed = 1.0, .arrival = 1.0};
  const Teb teb;
  Teb::Memory memory;
  Rng rng{1};
  Context context{rng};
  (void)teb.decide(e, memory, context);
  teb::Band& band = memory.bands.front();
  const teb::Band straight = band;
  std::vector<teb::Knot> loop;  // to starboard, once round
  for (int i = 1; i < 12; ++i) {
    const double turned = 2.0 * pi * i / 12;
    loop.push_back({1.0 + std::sin(turned), 1.0 - std::cos(turned), wrap_angle(turned), 0.5});
  }
  band.knots.insert(band.knots.begin() + 1, loop.begin(), loop.end());
  (void)teb.decide(e, memory, context);
  EXPECT_LT(memory.bands.front().duration(), 1.1 * straight.duration());

  e.situation.goal.position.x() = -30;
  for (int i = 0; i < 5; ++i) (void)teb.decide(e, memory, context);
  const teb::Band& round = memory.bands.front();
  for (std::size_t i = 0; i + 1 < round.size(); ++i)
    EXPECT_GT((round.position(i + 1) - round.position(i)).dot(unit_at(round.pose(i).heading)), -0.05) << i;

  // where nothing is near it asks for the way, not for the arc of a band that turns at once
  e.situation.goal.position = {0, 20, 50};
  const Command abeam = teb.decide(e, memory, context);
  EXPECT_GT(abeam.velocity.y(), 0.999 * abeam.velocity.norm());
  e.obstacles = {encounters::buoy(3, 3)};
  const Command past_a_buoy = teb.decide(e, memory, context);
  EXPECT_LT(past_a_buoy.velocity.y(), 0.999 * past_a_buoy.velocity.norm());
}

TEST(Teb, WhereTheEnvelopeIsKnownAndABandTurnsAboutTheWayIsAskedFor) {
  const Envelope boat = encounters::of_a_boat();
  encounters::OwnedSituation e = encounters::under_way(boat);
  e.situation.own.velocity.setZero();
  e.situation.goal = {.position = {-30, 2, 50}, .cruise_speed = 1.0, .arrival = 1.0};  // astern
  e.obstacles = {encounters::buoy(3, 3)};
  const Teb teb;
  Teb::Memory memory;
  Rng rng{1};
  Context context{rng};
  for (int i = 0; i < 5; ++i) {
    const Vec2 asked = teb.decide(e, memory, context).velocity.head<2>();
    const teb::Band& band = memory.bands.front();
    EXPECT_LT((band.position(2) - band.position(0)).norm(), 0.5);  // slowly, while it turns
    EXPECT_NEAR((asked - Vec2{-30, 2}.normalized()).norm(), 0.0, 1e-9);
  }
}

TEST(Teb, PlansAnewWhatIsBlockedAndAtMostOnceASecond) {
  Voyage v = voyage({});
  v.teb.params.global_plan = TebGlobalPlan::rrt_star;
  v.step();
  const std::vector<Vec2> straight = v.memory.way;
  EXPECT_EQ(straight.size(), 2U);
  v.course.buoys = {disc(12, 0, 3.0)};  // comes into sight
  v.step();
  EXPECT_EQ(v.memory.way, straight);
  for (int i = 0; i < 5; ++i) v.step();
  EXPECT_GT(v.memory.way.size(), 2U);
  const std::vector<Vec2> planned = v.memory.way;
  for (int i = 0; i < 20; ++i) v.step();
  EXPECT_EQ(v.memory.way, planned);
}

TEST(Teb, AGoalThatMovesIsPlannedForAtMostOnceASecond) {
  Voyage v = voyage({{disc(12, 0, 3.0)}, {}});
  v.teb.params.global_plan = TebGlobalPlan::rrt_star;
  Context context{v.rng};
  int plans = 0;
  for (int i = 0; i <= 20; ++i) {
    Situation s = v.situation();
    s.time = 0.21 * i;
    s.goal.position.y() = 0.01 * i;
    const double before = v.memory.planned_s;
    (void)v.teb.decide(s, v.memory, context);
    EXPECT_EQ(v.memory.way.back(), s.goal.position.head<2>());
    plans += v.memory.planned_s != before ? 1 : 0;
  }
  EXPECT_EQ(plans, 4);  // at 1.05, 2.1, 3.15 and 4.2 s, after that at 0
}

TEST(Teb, AlongASectionItPlansNoWay) {
  const Envelope boat = encounters::of_a_boat();
  encounters::OwnedSituation e = encounters::under_way(boat);
  e.situation.time = 5.0;
  e.situation.goal = {.position = {30, 0, 50}, .cruise_speed = 1.0, .velocity = Vec3{1, 0, 0}};
  e.obstacles = {encounters::buoy(12, 0, 3.0)};
  const Teb teb;
  Teb::Memory memory;
  Rng rng{1};
  Context context{rng};
  (void)teb.decide(e, memory, context);
  EXPECT_EQ(memory.way.size(), 2U);
  e.situation.goal.velocity.reset();
  (void)teb.decide(e, memory, context);
  EXPECT_GT(memory.way.size(), 2U);
}

TEST(Teb, WithoutAnyWayToPlanItKeepsTheLine) {
  Voyage v = voyage({{disc(25, 0, 3.0)}, {}});  // the goal is inside
  v.teb.params.global_plan = TebGlobalPlan::rrt_star;
  EXPECT_TRUE(is_finite(v.decide()));
  EXPECT_EQ(v.memory.way, (std::vector<Vec2>{{0, 0}, {25, 0}}));
}

TEST(TebWay, EndsWhereTheLookaheadLeavesItWithTheCornersBetween) {
  const std::vector<Vec2> way{{0, 0}, {4, 0}, {4, 4}, {10, 4}};
  const teb::WayAhead ahead = teb::ahead_on(way, {2, 1}, 3.0);
  EXPECT_EQ(ahead.points, (std::vector<Vec2>{{2, 1}, {4, 0}, {4, 1}}));
  EXPECT_DOUBLE_EQ(ahead.end.heading, 0.5 * pi);
  EXPECT_EQ(teb::ahead_on(way, {9, 5}, 3.0).points, (std::vector<Vec2>{{9, 5}, {10, 4}}));
}

TEST(Teb, VelocityIsAlongTheHeading) {
  Voyage v = voyage({{disc(2.5, 0.5)}, {}});
  v.yaw = 0.8;
  const Command command = v.decide();
  EXPECT_NEAR(command.velocity.x() * std::sin(0.8), command.velocity.y() * std::cos(0.8), 1e-12);
  EXPECT_TRUE(command.turn_rate);
  EXPECT_LT(*command.turn_rate, 0.0);
  EXPECT_EQ(command.mode, Mode::avoid);
}

TEST(Teb, BacksOffFromWhatIsTooNearAhead) {
  Voyage v = voyage({{disc(1.15, 0.02)}, {}});  // 0.1 m between the surfaces
  EXPECT_LT(v.decide().velocity.x(), 0.0);
}

TEST(Teb, StandsStillAtTheGoal) {
  Voyage v = voyage(courses::cluttered());
  v.position = {24.9, 0.0};
  EXPECT_EQ(v.decide(), Command{});
}

TEST(Teb, StandsStillInsideAnObstacleAndCountsIt) {
  for (const double offset : {0.0, 0.2, 0.9}) {
    Voyage v = voyage({{disc(offset, 0.0)}, {}});
    for (int i = 0; i < 3; ++i) {
      const Command command = v.decide();
      EXPECT_EQ(command.mode, Mode::infeasible);
      EXPECT_EQ(command.velocity, Vec3(0, 0, 0));
      EXPECT_FALSE(command.note.empty());
    }
    EXPECT_EQ(v.memory.infeasible_count, 3);
    EXPECT_TRUE(v.memory.bands.empty());
  }
}

TEST(Teb, AnswersEveryOddScene) {
  const std::vector<Vec3> around{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
  const std::vector<Vec3> corner{{2, -1, 0}, {4, 0, 0}, {2, 1, 0}};
  const std::vector<std::vector<Obstacle>> scenes{
      {disc(25, 0, 2.0)},  // over the goal
      {disc(3, 0, 1.0)},   // over the end of the band
      {{.kind = Obstacle::Kind::polygon, .vertices = around}},
      {{.kind = Obstacle::Kind::polygon, .vertices = corner}},
      {{.kind = Obstacle::Kind::segment, .from = {2, -50, 0}, .to = {2, 50, 0}}},
      {{.kind = Obstacle::Kind::segment, .from = {2, 0, 0}, .to = {2, 0, 0}}},
      std::vector<Obstacle>(60, disc(2, 0)),
  };
  for (const bool dynamic : {false, true}) {
    for (const bool robust : {false, true}) {
      for (const auto& scene : scenes) {
        for (const double yaw : {0.0, 2.0}) {
          Voyage v = voyage({scene, courses::vessel({0, 0.5, 0}, {0.1, 0, 0})}, 1.5, dynamic);
          v.teb.params.robust = robust;
          v.yaw = yaw;
          for (int i = 0; i < 5; ++i) {
            EXPECT_TRUE(is_finite(v.decide()));
            v.step();
          }
        }
      }
    }
  }
}

TEST(Teb, GoalsBehindOrAtTheStartAreAnswered) {
  Voyage v = voyage({});
  Situation s = v.situation();
  Context context{v.rng};
  s.goal.position = s.own.position;
  EXPECT_EQ(v.teb.decide(s, v.memory, context), Command{});
  s.goal.position = {-25, 0, 0};
  const Command command = v.teb.decide(s, v.memory, context);
  EXPECT_TRUE(is_finite(command));
  EXPECT_NE(command.mode, Mode::infeasible);
  s.goal.velocity = Vec3{0, 0.4, 0};
  EXPECT_GT(*v.teb.decide(s, v.memory, context).turn_rate, 0.0);
}

TEST(Teb, KeepsBandsOfSeveralClassesAndDrawsThem) {
  Voyage v = voyage({{disc(1.6, 0.05, 0.05)}, {}});
  Drawing drawing;
  Context context{v.rng, &drawing};
  (void)v.teb.decide(v.situation(), v.memory, context);
  EXPECT_EQ(v.memory.bands.size(), 2U);
  const auto strokes = drawing.strokes();
  ASSERT_EQ(strokes.size(), 4U);
  EXPECT_EQ(strokes[0].meaning, "band");
  EXPECT_EQ(strokes[1].meaning, "band of another class 1");
  for (const std::size_t i : {0U, 1U}) EXPECT_EQ(strokes[i].points.size(), v.memory.bands[i].size());
  EXPECT_EQ(strokes[2].meaning, "preferred");
  EXPECT_EQ(strokes[3].meaning, "chosen");

  v.teb.params.enable_homotopy_class_planning = false;
  v.memory = {};
  (void)v.decide();
  EXPECT_EQ(v.memory.bands.size(), 1U);
}

TEST(Teb, GoesBackToTheLineFromWhereItWasGivenTheGoal) {
  Voyage v = voyage({}, 1.5);
  (void)v.decide();
  v.position = {10.0, 3.0};
  (void)v.decide();
  const teb::Band& band = v.memory.bands.front();
  EXPECT_NEAR((band.position(band.size() - 1) - Vec2{13, 0}).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace fairway
