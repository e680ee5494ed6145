// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/gate.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "fairway/core/angles.hpp"

namespace fairway {

double gate_of(double ratio) {
  const auto share = [](double x) {
    return std::erf(std::sqrt(0.5 * x)) - std::sqrt(2.0 * x / pi) * std::exp(-0.5 * x);
  };
  double low = 0.0;
  double high = 100.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (share(middle) < ratio ? low : high) = middle;
  }
  return high;
}

double distance2(const Vec3& difference, const Mat3& covariance, double gate) {
  // the largest eigenvalue is at most the trace
  if (difference.squaredNorm() > gate * covariance.trace()) return std::numeric_limits<double>::infinity();
  return difference.dot(covariance.inverse() * difference);
}

}  // namespace fairway
