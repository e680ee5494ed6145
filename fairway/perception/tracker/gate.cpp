// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/gate.hpp"

#include <Eigen/LU>
#include <limits>

namespace fairway {

double distance2(const Vec3& difference, const Mat3& covariance, double gate) {
  // the largest eigenvalue is at most the trace
  if (difference.squaredNorm() > gate * covariance.trace()) return std::numeric_limits<double>::infinity();
  return difference.dot(covariance.inverse() * difference);
}

}  // namespace fairway
