// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>

#include "fairway/planning/planar_map.hpp"

namespace fairway {

/// A polynomial curve in the plane over 0 .. 1, of degree 7 or less, by its control points. The curve lies in
/// their convex hull: a bound that needs no sampling.
class Bezier {
 public:
  using Points = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, 8>;

  /// From coefficients of s^0, s^1, ...: the control point k is sum_i c_i binom(k, i) / binom(degree, i).
  static Bezier from_powers(const Points& coefficients) noexcept {
    Bezier curve{coefficients};
    const Eigen::Index count = coefficients.cols();
    for (Eigen::Index k = 0; k < count; ++k) {
      double weight = 1.0;  // binom(k, i) / binom(degree, i)
      curve.points_.col(k) = coefficients.col(0);
      for (Eigen::Index i = 1; i <= k; ++i) {
        weight *= static_cast<double>(k - i + 1) / static_cast<double>(count - i);
        curve.points_.col(k) += weight * coefficients.col(i);
      }
    }
    return curve;
  }

  Vec2 first() const noexcept { return points_.col(0); }
  Vec2 last() const noexcept { return points_.col(points_.cols() - 1); }

  /// The curve is nowhere farther from the origin.
  double norm_bound() const noexcept { return std::sqrt(points_.colwise().squaredNorm().maxCoeff()); }

  /// The curve is nowhere farther from `centre`.
  double reach(const Vec2& centre) const noexcept {
    return std::sqrt((points_.colwise() - centre).colwise().squaredNorm().maxCoeff());
  }

  /// The halves over 0 .. 1/2 and 1/2 .. 1 (de Casteljau).
  std::pair<Bezier, Bezier> halves() const noexcept {
    Bezier left{points_}, right{points_};
    const Eigen::Index count = points_.cols();
    for (Eigen::Index level = 1; level < count; ++level) {
      for (Eigen::Index k = 0; k < count - level; ++k) {
        right.points_.col(k) = 0.5 * (right.points_.col(k) + right.points_.col(k + 1)).eval();
      }
      left.points_.col(level) = right.points_.col(0);
    }
    return {left, right};
  }

 private:
  explicit Bezier(const Points& points) : points_{points} {}

  Points points_;
};

}  // namespace fairway
