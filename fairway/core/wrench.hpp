// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace fairway {

/// Forces and moments about the body origin: X, Y, Z, K, M, N [N, N m, body].
using Wrench = Eigen::Matrix<double, 6, 1>;

}  // namespace fairway
