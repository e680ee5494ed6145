// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/rrt_star/pursuit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/testing/boat.hpp"

namespace fairway {
namespace {

using encounters::buoy;
using encounters::of_a_boat;
using encounters::OwnedSituation;
using encounters::under_way;

/// 1 m/s, nine tenths of 0.5 rad/s and 0.5 m/s2: it looks 0.5 + (pi / 2) / 0.45 + 2 = 6.0 m ahead and turns
/// on 2.2 m.
struct Boat {
  Envelope can = of_a_boat();
  OwnedSituation e = under_way(can);

  Situation at(double north, double east, double time = 0.0) {
    e.situation.own.position = {north, east, 50.0};
    e.situation.time = time;
    return e;
  }

  Plan plan_along(std::vector<Vec2> path, std::vector<Obstacle> charted = {}) {
    e.obstacles = charted;
    Plan plan{.task = plan_task({}, at(0, 0))};
    plan.path = std::move(path);
    return plan;
  }
};

double course_of(const Vec3& v) { return std::atan2(v.y(), v.x()); }

TEST(Pursuit, HeadsForThePathAsFarAheadAsItTakesToTurnAsideAndStop) {
  Boat boat;
  const Plan plan = boat.plan_along({{0, 0}, {100, 0}});
  Pursuit pursuit{.along = 9.0};
  const Vec3 v = pursuit.follow(boat.at(10, 2), plan);
  EXPECT_NEAR(pursuit.along, 10.0, 1e-12);
  EXPECT_NEAR(course_of(v), std::atan2(-2.0, 0.5 + pi / 0.9 + 2.0), 1e-12);
  EXPECT_NEAR(v.norm(), 1.0, 1e-12);
}

TEST(Pursuit, ItsPlaceWaitsForTheVehicleAndNeverGoesBack) {
  Boat boat;
  const Plan plan = boat.plan_along({{0, 0}, {100, 0}});
  Pursuit pursuit;
  for (double time = 0.0; time < 20.0; time += 1.0) (void)pursuit.follow(boat.at(3, 0, time), plan);
  EXPECT_NEAR(pursuit.along, 3.0, 1e-12);
  (void)pursuit.follow(boat.at(1, 0, 20.0), plan);
  EXPECT_NEAR(pursuit.along, 3.0, 1e-12);
}

TEST(Pursuit, DoesNotCutACornerThatAnObstacleMakes) {
  // round the north end of a wall, whose other side is near
  Boat boat;
  const Plan plan =
      boat.plan_along({{0, 0}, {10, 0}, {10, 4}, {0, 4}}, {encounters::wall({-5, 2, 50}, {8.5, 2, 50})});
  Pursuit pursuit{.along = 6.0};
  const Vec3 v = pursuit.follow(boat.at(7, 0), plan);
  EXPECT_NEAR(pursuit.along, 7.0, 1e-12);
  EXPECT_LT(course_of(v), 0.5);
  EXPECT_TRUE(plan.task.map.is_free({7, 0}, Vec2{7, 0} + 3.0 * v.head<2>().normalized()));
}

TEST(Pursuit, IsSlowerWhereThePathTurnsMoreThanARadianWithinATurningRadius) {
  Boat boat;
  const Plan gentle = boat.plan_along({{0, 0}, {20, 0}, {30, 9}});
  const Plan sharp = boat.plan_along({{0, 0}, {20, 0}, {20, 30}});
  const auto speed_at = [&](const Plan& plan, double north) {
    Pursuit pursuit{.along = north};
    return pursuit.follow(boat.at(north, 0), plan).norm();
  };
  EXPECT_NEAR(speed_at(gentle, 19.9), 1.0, 1e-12);
  EXPECT_NEAR(speed_at(sharp, 10.0), 1.0, 1e-12);
  // a right angle at 1 / (pi / 2) m/s, with 0.1 m to slow down on
  EXPECT_NEAR(speed_at(sharp, 19.9), std::sqrt(4.0 / (pi * pi) + 2.0 * 0.5 * 0.1), 1e-9);
}

TEST(Pursuit, IsStuckWhereItGainsNothingOrSeesNothingOfThePath) {
  Boat boat;
  const Plan plan = boat.plan_along({{0, 0}, {100, 0}}, {buoy(10.0, 4.0, 1.0)});
  const double patience = 0.5 + pi / 0.45 + 2.0;
  Pursuit pursuit;
  (void)pursuit.follow(boat.at(3, 0), plan);
  (void)pursuit.follow(boat.at(3, 0, patience - 0.1), plan);
  EXPECT_FALSE(pursuit.is_stuck(boat.at(3, 0, patience - 0.1), plan));
  EXPECT_TRUE(pursuit.is_stuck(boat.at(3, 0, patience + 0.1), plan));
  pursuit.along = 9.0;
  (void)pursuit.follow(boat.at(12, 7, patience + 0.2), plan);
  EXPECT_FALSE(pursuit.is_stuck(boat.at(12, 7, patience + 0.2), plan));
  const Situation beside = boat.at(10, 5.5, patience + 0.3);  // nearer to the buoy than its sphere lets
  (void)pursuit.follow(beside, plan);
  EXPECT_FALSE(pursuit.sees);
  EXPECT_TRUE(pursuit.is_stuck(beside, plan));
}

TEST(Pursuit, IsBlockedByWhatLiesAheadOnThePathAlone) {
  Boat boat;
  const Plan plan = boat.plan_along({{0, 0}, {100, 0}});
  Pursuit pursuit;
  (void)pursuit.follow(boat.at(5, 0), plan);
  EXPECT_NEAR(pursuit.along, 5.0, 1e-12);
  const auto blocked_by = [&](const Obstacle& o) { return pursuit.is_blocked(plan, PlanarMap{{{o}}, 1.0}); };
  EXPECT_TRUE(blocked_by(buoy(50, 1)));
  EXPECT_FALSE(blocked_by(buoy(50, 3)));
  EXPECT_FALSE(blocked_by(buoy(2, 0)));
}

}  // namespace
}  // namespace fairway
