// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/circular_regions.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/avoa/testing/direct_evaluation.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway::avoa {
namespace {

using encounters::OwnedSituation;

constexpr Regions regions{
    .margin = 0.25, .spacing = 0.5, .window = 8.0, .window_at_rest = 8.0, .contact = TimeToContact::bound};

/// Own ship of 0.75 m at (10, -4), bow to `yaw`.
OwnedSituation afloat(double yaw = 0.0) {
  OwnedSituation e = encounters::open_water();
  e.situation.own.position = {10.0, -4.0, 0.0};
  e.situation.own.radius = 0.75;
  e.situation.own.yaw = yaw;
  return e;
}

ProtectiveZones zones_of(const OwnedSituation& e, const Regions& how = regions) {
  ProtectiveZones zones;
  zones.clear({101, 1.5});
  const Situation s = e;
  add_everyone(s, how, zones);
  return zones;
}

/// A place [m, NED], seen from own position in own axes.
Vec2 seen_from_own(const OwnedSituation& e, const Vec3& p) {
  const Eigen::AngleAxisd back(-e.situation.own.yaw, Vec3::UnitZ());
  return (back * (p - e.situation.own.position)).head<2>();
}

TEST(CircularRegions, ATrackAndASphereAreOneDiscEachInOwnAxes) {
  OwnedSituation e = afloat(0.8);
  e.tracks = {encounters::track(1, {13.0, 2.0, 0.0}, {-0.3, -0.5, 0.0}, 0.6)};
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {6.0, -6.0, 3.0}, .radius = 0.3}};

  const Eigen::AngleAxisd back(-0.8, Vec3::UnitZ());
  const MovingDisc vessel{.position = seen_from_own(e, {13.0, 2.0, 0.0}),
                          .radius = 1.6,
                          .velocity = (back * Vec3{-0.3, -0.5, 0.0}).head<2>()};
  const MovingDisc buoy{.position = seen_from_own(e, {6.0, -6.0, 0.0}), .radius = 1.3};
  ProtectiveZones expected;
  expected.clear({101, 1.5});
  expected.add(vessel, 8.0, TimeToContact::bound);
  expected.add(buoy, 8.0, TimeToContact::bound);
  EXPECT_EQ(zones_of(e).forbidden(), expected.forbidden());
}

/// How long until own disc, grown by the margin, touches a wall, going at `v`; nothing if it never does
/// within the window. Exactly: the ray against the two sides and the two ends of the band round the wall.
std::optional<double> meets_wall(const Vec2& a, const Vec2& b, double radius, const Vec2& v) {
  std::optional<double> first;
  const auto take = [&](std::optional<double> time) {
    if (time && *time >= 0.0 && (!first || *time < *first)) first = time;
  };
  take(ray_meets_circle(v, a, radius));
  take(ray_meets_circle(v, b, radius));
  const Vec2 along = (b - a).normalized();
  const Vec2 across{-along.y(), along.x()};
  for (const double side : {-radius, radius}) {
    if (across.dot(v) == 0.0) continue;
    const double time = (across.dot(a) + side) / across.dot(v);
    const double reached = along.dot(time * v - a);
    if (reached >= 0.0 && reached <= (b - a).norm()) take(time);
  }
  return first;
}

struct Wall {
  Vec3 from, to;
};

TEST(CircularRegions, OfAWallForbidWhatMeetsItAndLittleElse) {
  const Regions exact{
      .margin = 0.25, .spacing = 0.5, .window = 8.0, .window_at_rest = 8.0, .contact = TimeToContact::exact};
  Rng rng{5};
  int met = 0, too_many = 0;
  for (int scene = 0; scene < 100; ++scene) {
    OwnedSituation e = afloat(rng.uniform(-3.0, 3.0));
    const auto around = [&] {
      return Vec3{e.situation.own.position + Vec3{rng.uniform(-15, 15), rng.uniform(-15, 15), 0.0}};
    };
    const Wall wall{around(), around()};
    e.obstacles = {{.kind = Obstacle::Kind::segment, .from = wall.from, .to = wall.to}};
    if (nearest_point(e.obstacles[0], e.situation.own.position).distance < 1.1) continue;

    const ProtectiveZones zones = zones_of(e, exact);
    for (int cell = 0; cell < zones.grid().cell_count(); ++cell) {
      const Vec2 v = zones.grid().velocity(cell);
      const auto within = [&](double radius) {
        const auto time = meets_wall(seen_from_own(e, wall.from), seen_from_own(e, wall.to), radius, v);
        return time && *time <= 8.0;
      };
      const bool forbidden = zones.forbidden()[static_cast<std::size_t>(cell)] != 0;
      if (within(1.0 - 1e-9)) {
        EXPECT_TRUE(forbidden) << scene << " " << v.transpose();
      }
      // half of 0.5 m aside, a circle that reaches 1 m there has a radius of 1.031 m
      if (!within(std::hypot(1.0, 0.25) + 1e-9)) {
        EXPECT_FALSE(forbidden) << scene << " " << v.transpose();
      }
      met += within(1.0) ? 1 : 0;
      too_many += forbidden && !within(1.0) ? 1 : 0;
    }
  }
  EXPECT_GT(met, 50000);
  EXPECT_LT(too_many, met / 20);
}

TEST(CircularRegions, OfAPolygonAreThoseOfItsEdges) {
  const std::vector<Vec3> triangle{{14, -3, 0}, {18, -6, 0}, {17, 1, 0}};
  OwnedSituation solid = afloat(0.3);
  solid.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = triangle}};
  OwnedSituation walls = afloat(0.3);
  for (std::size_t i = 0; i < 3; ++i) {
    walls.obstacles.push_back(
        {.kind = Obstacle::Kind::segment, .from = triangle[(i + 2) % 3], .to = triangle[i]});
  }
  EXPECT_FALSE(zones_of(solid).empty());
  EXPECT_EQ(zones_of(solid).forbidden(), zones_of(walls).forbidden());
}

TEST(CircularRegions, InsideAPolygonOnlyTheWayOutIsAllowed) {
  // the nearest side is 2 m east of own position
  const std::vector<Vec3> square{{0, -22, 0}, {20, -22, 0}, {20, -2, 0}, {0, -2, 0}};
  OwnedSituation e = afloat();
  e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = square}};
  const ProtectiveZones zones = zones_of(e);
  for (int cell = 0; cell < zones.grid().cell_count(); ++cell) {
    EXPECT_EQ(zones.forbidden()[static_cast<std::size_t>(cell)] != 0, zones.grid().velocity(cell).y() < 0.0);
  }
}

TEST(CircularRegions, AnswerWallsOfAnyLengthAndNone) {
  constexpr double far = 1e7;
  for (const auto& [from, to] : {Wall{{-far, 8, 0}, {far, 8, 0}}, Wall{{10, 8, 0}, {10, 8, 0}},
                                 Wall{{10, -4, 0}, {10, -4, 0}}, Wall{{-1e160, 0, 0}, {1e160, 0, 0}}}) {
    OwnedSituation e = afloat();
    e.obstacles = {{.kind = Obstacle::Kind::segment, .from = from, .to = to}};
    (void)zones_of(e);
  }
  // 11 m to starboard of a coast that never ends: what reaches it in 8 s is forbidden, away from it nothing
  // is
  OwnedSituation e = afloat();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {-far, 7, 0}, .to = {far, 7, 0}}};
  const ProtectiveZones zones = zones_of(e);
  for (int cell = 0; cell < zones.grid().cell_count(); ++cell) {
    const Vec2 v = zones.grid().velocity(cell);
    const bool forbidden = zones.forbidden()[static_cast<std::size_t>(cell)] != 0;
    if (v.y() * 8.0 > 10.0) {
      EXPECT_TRUE(forbidden) << v.transpose();
    }
    if (v.y() <= 0.0) {
      EXPECT_FALSE(forbidden) << v.transpose();
    }
  }
}

}  // namespace
}  // namespace fairway::avoa
