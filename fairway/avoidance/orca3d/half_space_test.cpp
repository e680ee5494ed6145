// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca3d/half_space.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "fairway/core/rng.hpp"

namespace fairway::orca {
namespace {

Vec3 direction(Rng& rng) { return unit(Vec3{rng.normal(), rng.normal(), rng.normal()}); }

const Vec3 north = Vec3::UnitX();

/// The velocity obstacle is the union over s >= 1 / tau of the balls round s p with radius s R, so the
/// way out of it is max over s of s R - |v - s p|, a concave function of s. Searched in long double.
struct Searched {
  double distance;
  Vec3 normal;
};

Searched searched(const RelativeNeighbour& encounter, double tau) {
  using Vec = Eigen::Matrix<long double, 3, 1>;
  const Vec p{encounter.p.x(), encounter.p.y(), encounter.p.z()};
  const Vec v{encounter.v.x(), encounter.v.y(), encounter.v.z()};
  const long double radius = encounter.radius;
  const auto depth = [&](long double s) { return s * radius - (v - s * p).norm(); };
  long double lo = 1.0L / tau;
  long double hi = lo + 1e3L * (1.0L + v.norm() / p.norm());
  for (int i = 0; i < 400; ++i) {
    const long double a = lo + (hi - lo) / 3;
    const long double b = hi - (hi - lo) / 3;
    (depth(a) < depth(b) ? lo : hi) = depth(a) < depth(b) ? a : b;
  }
  return {static_cast<double>(depth(lo)), ((v - lo * p).normalized()).cast<double>()};
}

TEST(OrcaHalfSpace, AgreesWithASearchForTheLeastChange) {
  double distance = 0.0, normal = 0.0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Rng rng = Rng{1}.stream("encounter", i);
    const double radius = rng.uniform(0.1, 3.0);
    const double range = radius * (1.0 + std::pow(10.0, rng.uniform(-6.0, 1.5)));
    const double tau = rng.uniform(0.5, 10.0);
    const RelativeNeighbour e{range * direction(rng), rng.uniform(0.0, 3.0) * range / tau * direction(rng),
                              radius, north};
    const Change change = least_change(e, tau, 0.1);
    const Searched expected = searched(e, tau);
    const double scale = e.v.norm() + range / tau;
    EXPECT_NEAR(change.normal.norm(), 1.0, 1e-14);
    distance = std::fmax(distance, std::fabs(change.distance - expected.distance) / scale);
    normal = std::fmax(normal, (change.normal - expected.normal).norm());
  }
  EXPECT_LT(distance, 1e-12);  // measured 4e-14, where the two all but touch
  EXPECT_LT(normal, 1e-6);     // where the search stops
}

TEST(OrcaHalfSpace, LeadsOutBesideTheConeByItsHalfAngle) {
  // R / d = 3 / 5: sin 0.6, cos 0.8. v = (2, 0.1, 0) is beyond the cut-off; the normal is cos to
  // starboard, sin backwards, and the distance 0.6 * 2 - 0.8 * 0.1 = 1.12
  const Change change = least_change({{5.0, 0.0, 0.0}, {2.0, 0.1, 0.0}, 3.0, north}, 5.0, 0.1);
  EXPECT_LT((change.normal - Vec3(-0.6, 0.8, 0.0)).norm(), 1e-15);
  EXPECT_NEAR(change.distance, 1.12, 1e-15);
}

TEST(OrcaHalfSpace, SlowApproachIsCutOffByTheSphereAtTheHorizon) {
  // p / tau = 1.6, R / tau = 0.4: v = 1.3 on the axis is 0.3 within the ball round 1.6, so 0.1 is left
  const Change change = least_change({{8.0, 0.0, 0.0}, {1.3, 0.0, 0.0}, 2.0, north}, 5.0, 0.1);
  EXPECT_LT((change.normal - Vec3(-1.0, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_NEAR(change.distance, 0.1, 1e-15);
}

TEST(OrcaHalfSpace, WhoOverlapsMustBeApartWithinOnePeriod) {
  // 1 m apart, R = 2: out of the ball round p / 0.5 = 2 of radius 4, from v = 0: 2 m/s backwards
  const Change change = least_change({{1.0, 0.0, 0.0}, Vec3::Zero(), 2.0, north}, 5.0, 0.5);
  EXPECT_LT((change.normal - Vec3(-1.0, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_NEAR(change.distance, 2.0, 1e-15);
}

TEST(OrcaHalfSpace, IsContinuousWhereConeAndSphereMeet) {
  // the sphere gives way to the cone where w is at right angles to the cone's side
  for (std::uint64_t i = 0; i < 500; ++i) {
    Rng rng = Rng{2}.stream("edge", i);
    const Vec3 e = direction(rng);
    const Vec3 across = unit(Vec3{direction(rng).cross(e)});
    const double d = 5.0, radius = rng.uniform(0.5, 4.5), tau = 5.0;
    const double sin = radius / d, cos = std::sqrt(1.0 - sin * sin);
    const Vec3 w = rng.uniform(0.05, 0.3) * (cos * across - sin * e);
    const Vec3 nudge = 1e-9 * e;
    const Change inside = least_change({d * e, w + d / tau * e - nudge, radius, north}, tau, 0.1);
    const Change outside = least_change({d * e, w + d / tau * e + nudge, radius, north}, tau, 0.1);
    EXPECT_LT((inside.normal - outside.normal).norm(), 1e-7);
    EXPECT_NEAR(inside.distance, outside.distance, 1e-8);
  }
}

TEST(OrcaHalfSpace, OnTheAxisBothTurnToStarboard) {
  const RelativeNeighbour ours{{5.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 3.0, north};
  const RelativeNeighbour theirs{{-5.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}, 3.0, -north};
  EXPECT_LT((least_change(ours, 5.0, 0.1).normal - Vec3(-0.6, 0.8, 0.0)).norm(), 1e-15);
  EXPECT_LT((least_change(theirs, 5.0, 0.1).normal - Vec3(0.6, -0.8, 0.0)).norm(), 1e-15);
}

TEST(OrcaHalfSpace, WhatIsAskedOfTheTwoIsAlwaysOpposite) {
  const auto expect_opposite = [](const Vec3& p, const Vec3& v) {
    const Change ours = least_change({p, v, 2.0, north}, 5.0, 0.1);
    const Change theirs = least_change({-p, -v, 2.0, -north}, 5.0, 0.1);
    EXPECT_EQ((ours.normal + theirs.normal).norm(), 0.0);
    EXPECT_EQ(ours.distance, theirs.distance);
    EXPECT_NEAR(ours.normal.norm(), 1.0, 1e-14);
  };
  Rng rng{3};
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = rng.uniform(0.0, 6.0) * direction(rng);
    expect_opposite(p, rng.uniform(0.0, 3.0) * direction(rng));
    expect_opposite(p, Vec3::Zero());
    expect_opposite(p, 2.0 * p);
    expect_opposite(p, -p);
    expect_opposite(p, p / 0.1);  // the centre of the sphere of one period
    expect_opposite(p, p / 5.0);  // the centre of the sphere at the horizon
  }
  expect_opposite(Vec3::Zero(), Vec3::Zero());
  expect_opposite(Vec3::Zero(), {0.1, 0.0, 0.2});
  expect_opposite({0.0, 0.0, 5.0}, {0.0, 0.0, 3.0});
}

}  // namespace
}  // namespace fairway::orca
