// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/gate.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace fairway {

double gate_of(double ratio, int dimensions) {
  // from one or two dimensions upwards by two
  const auto share = [&](double x) {
    const bool odd = dimensions % 2 == 1;
    double sum = odd ? std::erf(std::sqrt(0.5 * x)) : 1.0 - std::exp(-0.5 * x);
    for (int k = odd ? 3 : 4; k <= dimensions; k += 2)
      sum -= std::pow(0.5 * x, 0.5 * k - 1.0) * std::exp(-0.5 * x) / std::tgamma(0.5 * k);
    return sum;
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
