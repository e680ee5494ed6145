// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/chi.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// The squared Mahalanobis distance in so many dimensions (1 to 10) that a share `ratio`, in (0, 1), of all
/// stays within.
inline double gate_of(double ratio, int dimensions) {
  const double k = chi_quantile(ratio, dimensions);
  return k * k;
}

/// Square of the Mahalanobis distance of a difference whose error has the positive definite `covariance`, or
/// infinity where it is surely beyond `gate`, which is cheaper to see.
double distance2(const Vec3& difference, const Mat3& covariance, double gate);

}  // namespace fairway
