// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/circle_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

/// Echoes of the near side of a circle, at bearings of `from` to `to` of its half-angle, with noise.
std::vector<Echo> arc(const Vec2& centre, double radius, double from, double to, const EchoNoise& noise,
                      Rng rng) {
  const double d = centre.norm();
  const double half = std::asin(radius / d);
  std::vector<Echo> echoes;
  for (int i = 0; i < 40; ++i) {
    const double b = half * (from + (to - from) * i / 39.0);
    const double range = d * std::cos(b) - std::sqrt(radius * radius - d * d * std::sin(b) * std::sin(b));
    echoes.push_back({range + std::sqrt(noise.range) * rng.normal(),
                      std::atan2(centre.y(), centre.x()) + b + std::sqrt(noise.bearing) * rng.normal()});
  }
  return echoes;
}

Circle fit(const Circle& prior, const std::vector<Echo>& echoes, const EchoNoise& noise) {
  std::vector<Vec2> sights;
  for (const Echo& echo : echoes) sights.push_back(unit_at(echo.bearing));
  return fitted(prior, echoes, sights, noise);
}

TEST(CircleFit, WithoutNoiseHalfACircleTellsTheWhole) {
  const Circle prior{{9, 1}, 1.0, 9.0 * Mat3::Identity()};
  const Circle circle = fit(prior, arc({10, 0}, 2.0, -0.95, 0.1, {0, 0}, Rng{1}), {0, 0});
  EXPECT_LT((circle.centre - Vec2(10, 0)).norm(), 1e-3);
  EXPECT_NEAR(circle.radius, 2.0, 1e-3);
}

TEST(CircleFit, ErrorsAreAsLargeAsTold) {
  const EchoNoise noise{0.03 * 0.03, 0.003 * 0.003};
  const int runs = 500;
  double nees = 0.0;
  for (int run = 0; run < runs; ++run) {
    Rng rng = Rng{2}.stream("run", static_cast<std::uint64_t>(run));
    const Vec3 truth{10, 0, 2};
    const Vec3 thought = truth + 0.5 * Vec3{rng.normal(), rng.normal(), rng.normal()};
    const Mat3 doubt = 0.25 * Mat3::Identity();
    const Circle circle =
        fit({thought.head<2>(), thought.z(), doubt}, arc({10, 0}, 2.0, -0.8, 0.0, noise, rng), noise);
    const Vec3 error = Vec3{circle.centre.x(), circle.centre.y(), circle.radius} - truth;
    nees += error.dot(circle.covariance.inverse() * error) / runs;
  }
  EXPECT_GT(nees, 2.5);  // 3 for a linear problem
  EXPECT_LT(nees, 3.9);
}

TEST(CircleFit, OneEchoSaysNothingAboutTheRadius) {
  const Circle prior{{10, 0}, 2.0, 9.0 * Mat3::Identity()};
  const std::vector<Echo> one{{8.0, 0.0}};
  const Circle circle = fit(prior, one, {1e-4, 1e-4});
  EXPECT_NEAR(circle.covariance(2, 2), 4.5, 0.1);  // half of it: radius and distance share the one equation
  EXPECT_NEAR(circle.covariance(1, 1), 9.0, 0.1);
}

TEST(CircleFit, EchoesAtItsVeryCentreAreFine) {
  const Circle prior{{0, 0}, 0.0, Mat3::Identity()};
  const std::vector<Echo> none{{0.0, 0.0}, {0.0, 1.0}};
  EXPECT_TRUE(fit(prior, none, {0, 0}).centre.allFinite());
}

}  // namespace
}  // namespace fairway
