// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/vec.hpp"

namespace fairway {

/// The squared Mahalanobis distance in three dimensions that a share `ratio` of all stays within: the
/// quantile of chi-square with three degrees of freedom. `ratio` in (0, 1).
double gate_of(double ratio);

/// Square of the Mahalanobis distance of a difference whose error has the positive definite `covariance`, or
/// infinity where it is surely beyond `gate`, which is cheaper to see.
double distance2(const Vec3& difference, const Mat3& covariance, double gate);

}  // namespace fairway
