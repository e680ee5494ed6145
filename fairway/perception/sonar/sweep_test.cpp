// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/sweep.hpp"

#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"
#include "fairway/perception/testing/quiet_sonar.hpp"

namespace fairway {
namespace {

constexpr double nothing = std::numeric_limits<double>::infinity();

/// Where a ray first meets a surface, without any of the sweep's geometry: by the distances that
/// nearest_point() tells, marched along the ray (Hart 1996).
double marched(const Obstacle& obstacle, const Vec3& from, const Vec3& direction, double reach) {
  double range = 0.0;
  for (int i = 0; i < 4000 && range <= reach; ++i) {
    const double distance = nearest_point(obstacle, from + range * direction).distance;
    if (distance < 1e-6) return range;
    range += distance;
  }
  return nothing;
}

/// The least of many elevations.
double marched_beam(const Obstacle& obstacle, const VehicleState& own, double bearing, double half_aperture,
                    double reach) {
  double least = nothing;
  for (int i = -200; i <= 200; ++i) {
    const double e = half_aperture * i / 200.0;
    const Vec3 direction_b{std::cos(e) * std::cos(bearing), std::cos(e) * std::sin(bearing), std::sin(e)};
    least = std::min(least, marched(obstacle, own.p_n, own.q_nb * direction_b, reach));
  }
  return least;
}

VehicleState tilted(Rng& rng) {
  VehicleState own;
  own.p_n = {rng.uniform(-20, 20), rng.uniform(-20, 20), rng.uniform(-5, 5)};
  own.q_nb = quaternion_of(
      {.roll = rng.uniform(-0.5, 0.5), .pitch = rng.uniform(-0.5, 0.5), .yaw = rng.uniform(-pi, pi)});
  return own;
}

SonarParams few_beams() {
  SonarParams params = quiet_sonar();
  params.beams_count = 41;
  params.max_range_m = 60;
  return params;
}

/// How many beams were compared of which both heard something; edges, where 401 elevations are too few to
/// tell, are left out.
int compare(const Obstacle& obstacle, const VehicleState& own) {
  const SonarParams params = few_beams();
  Sweep sweep{params};
  sweep.look_from(own.p_n, own.q_nb);
  sweep.add(obstacle);
  int heard = 0;
  for (std::size_t beam = 0; beam < sweep.ranges().size(); ++beam) {
    const double range = sweep.ranges()[beam];
    const double slow = marched_beam(obstacle, own, sweep.bearing(beam),
                                     0.5 * radians(params.vertical_aperture_deg), params.max_range_m);
    if (slow < nothing) {
      EXPECT_LE(range, slow + 1e-4) << "beam " << beam;
      EXPECT_GE(range, slow - 0.35) << "beam " << beam;
      ++heard;
    }
  }
  return heard;
}

TEST(Sweep, ADiscAheadIsSeenWithinItsTangentsAtTheDistancesOfItsCircle) {
  const double d = 20.0;
  const double r = 3.0;
  Sweep sweep{quiet_sonar()};
  sweep.look_from(Vec3::Zero(), Eigen::Quaterniond::Identity());
  sweep.add_sphere({d, 0, 0}, r);
  int heard = 0;
  for (std::size_t beam = 0; beam < 256; ++beam) {
    const double b = sweep.bearing(beam);
    if (std::abs(b) > std::asin(r / d)) {
      EXPECT_EQ(sweep.ranges()[beam], nothing);
      continue;
    }
    ++heard;
    const double expected = d * std::cos(b) - std::sqrt(r * r - d * d * std::sin(b) * std::sin(b));
    EXPECT_NEAR(sweep.ranges()[beam], expected, 1e-12);
  }
  EXPECT_EQ(heard, 34);  // 2 asin(3 / 20) = 17.25 deg, a beam each 130 / 256 deg
}

TEST(Sweep, ABallAboveThePlaneIsNearestAlongTheEdgeOfTheBeam) {
  // its centre is 30 deg up and the beam reaches 10 deg: 20 deg are left
  const double d = 10.0;
  const double r = 5.0;
  SonarParams params = quiet_sonar();
  params.beams_count = 1;
  Sweep sweep{params};
  sweep.look_from(Vec3::Zero(), Eigen::Quaterniond::Identity());
  sweep.add_sphere({d * std::cos(radians(30)), 0, -d * std::sin(radians(30))}, r);
  const double off = radians(20);
  EXPECT_NEAR(sweep.ranges()[0], d * std::cos(off) - std::sqrt(r * r - d * d * std::sin(off) * std::sin(off)),
              1e-12);
}

TEST(Sweep, WhatLiesAboveTheApertureIsNotHeard) {
  Sweep sweep{quiet_sonar()};
  sweep.look_from(Vec3::Zero(), Eigen::Quaterniond::Identity());
  sweep.add_sphere({10, 0, -4}, 1.5);  // tan 10 deg x 10 m + 1.5 m < 4 m
  for (const double range : sweep.ranges()) EXPECT_EQ(range, nothing);
}

TEST(Sweep, TheNearerHidesTheFarther) {
  Sweep sweep{quiet_sonar()};
  sweep.look_from(Vec3::Zero(), Eigen::Quaterniond::Identity());
  sweep.add_sphere({40, 0, 0}, 2);
  sweep.add_sphere({20, 0, 0}, 2);
  EXPECT_GT(std::ranges::count_if(sweep.ranges(), [](double range) { return range < 21.0; }), 10);
  for (const double range : sweep.ranges()) EXPECT_TRUE(range == nothing || range < 21.0);
}

TEST(Sweep, FromInsideASolidTheRangeIsZero) {
  const std::vector<Vec3> square{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
  Sweep sweep{quiet_sonar()};
  sweep.look_from(Vec3::Zero(), Eigen::Quaterniond::Identity());
  sweep.add_sphere({0, 0, 0}, 2);
  for (const double range : sweep.ranges()) EXPECT_EQ(range, 0.0);
  sweep.look_from(Vec3::Zero(), Eigen::Quaterniond::Identity());
  sweep.add({.kind = Obstacle::Kind::polygon, .vertices = square});
  for (const double range : sweep.ranges()) EXPECT_EQ(range, 0.0);
}

TEST(Sweep, BallsInAnyAttitudeAreWhereRaysMeetThem) {
  Rng rng{1};
  int heard = 0;
  for (int i = 0; i < 25; ++i) {
    const VehicleState own = tilted(rng);
    const Vec3 ahead{rng.uniform(8, 40), rng.uniform(-15, 15), rng.uniform(-8, 8)};
    heard += compare(
        {.kind = Obstacle::Kind::sphere, .position = own.p_n + own.q_nb * ahead, .radius = rng.uniform(1, 6)},
        own);
  }
  EXPECT_GT(heard, 60);
}

TEST(Sweep, PrismsInAnyAttitudeAreWhereRaysMeetThem) {
  Rng rng{2};
  int heard = 0;
  for (int i = 0; i < 12; ++i) {
    const VehicleState own = tilted(rng);
    const Vec3 middle = own.p_n + own.q_nb * Vec3{rng.uniform(12, 40), rng.uniform(-15, 15), 0.0};
    const std::vector<Vec3> vertices{middle + Vec3{-4, -6, 0}, middle + Vec3{5, -3, 0},
                                     middle + Vec3{3, 6, 0}, middle + Vec3{-3, 4, 0}};
    heard += compare({.kind = Obstacle::Kind::polygon, .vertices = vertices}, own);
  }
  EXPECT_GT(heard, 60);
}

TEST(Sweep, ASegmentIsSeenWhereItsLineCrossesTheBeam) {
  VehicleState own;
  own.q_nb = quaternion_of({.roll = 0.3, .pitch = -0.2, .yaw = 2.0});
  const Vec3 from_b{20, -8, 1};
  const Vec3 to_b{14, 9, -2};
  Sweep sweep{few_beams()};
  sweep.look_from(own.p_n, own.q_nb);
  sweep.add({.kind = Obstacle::Kind::segment, .from = own.q_nb * from_b, .to = own.q_nb * to_b});
  int heard = 0;
  for (std::size_t beam = 0; beam < sweep.ranges().size(); ++beam) {
    const double b = sweep.bearing(beam);
    const Vec3 across{-std::sin(b), std::cos(b), 0};
    const double t = -across.dot(from_b) / across.dot(to_b - from_b);
    if (t < 0.0 || t > 1.0) {
      EXPECT_EQ(sweep.ranges()[beam], nothing);
      continue;
    }
    ++heard;
    EXPECT_NEAR(sweep.ranges()[beam], (from_b + t * (to_b - from_b)).norm(), 1e-9);
  }
  EXPECT_GT(heard, 14);
}

TEST(Sweep, ASegmentThatPassesAsternIsSeenAtNeitherEndAhead) {
  Sweep sweep{quiet_sonar()};
  sweep.look_from(Vec3::Zero(), Eigen::Quaterniond::Identity());
  sweep.add({.kind = Obstacle::Kind::segment, .from = {-5, -40, 0}, .to = {-5, 40, 0}});
  for (const double range : sweep.ranges()) EXPECT_EQ(range, nothing);
}

}  // namespace
}  // namespace fairway
