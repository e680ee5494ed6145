// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/circle_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fairway {
namespace {

constexpr int gauss_newton_steps = 8;
constexpr double least_radius = 0.05;  // [m]
constexpr double imperfection = 1e-4;  // [m2], 1 cm: no echo is from a better circle

/// What is seen of a circle is its near side: its centre is farther than any of it.
void keep_behind(double range, Vec3& x) {
  const double distance = x.head<2>().norm();
  if (distance > 0.0 && distance < range) x.head<2>() *= range / distance;
}

}  // namespace

Circle fitted(const Circle& prior, std::span<const Echo> echoes, std::span<const Vec2> sights,
              const EchoNoise& noise) {
  const Mat3 prior_information = prior.covariance.inverse();
  const Vec3 start{prior.centre.x(), prior.centre.y(), prior.radius};
  const double farthest = std::ranges::max(echoes, {}, &Echo::range).range;
  Vec3 x = start;
  keep_behind(farthest, x);
  Mat3 information = prior_information;
  for (int step = 0; step < gauss_newton_steps; ++step) {
    information = prior_information;
    Vec3 pull = prior_information * (start - x);
    for (std::size_t i = 0; i < echoes.size(); ++i) {
      const Echo& echo = echoes[i];
      const Vec2& sight = sights[i];
      const Vec2 out = echo.range * sight - x.head<2>();
      const double distance = out.norm();
      if (distance < least_radius) continue;
      const Vec2 normal = out / distance;

      // noise of range along the line of sight, of bearing athwart it
      const double along = normal.dot(sight) * normal.dot(sight);
      const double variance =
          along * noise.range + (1.0 - along) * echo.range * echo.range * noise.bearing + imperfection;
      const Vec3 slope{normal.x(), normal.y(), 1.0};
      information += slope * slope.transpose() / variance;
      pull += slope * (distance - x.z()) / variance;
    }
    x += information.inverse() * pull;
    x.z() = std::max(x.z(), least_radius);
    keep_behind(farthest, x);
  }
  return {.centre = x.head<2>(), .radius = x.z(), .covariance = information.inverse()};
}

}  // namespace fairway
