// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// Exact first-order lags T x' = c - x with the command c held for `h` [s]: x(h) = c + (x(0) - c) remaining,
/// and its mean over h is c + (x(0) - c) mean_remaining. T = 0 follows at once. Call once per step length: it
/// takes an exponential each.
inline void first_order_lag(const ActuatorValues& time_constants, double h, ActuatorValues& remaining,
                            ActuatorValues& mean_remaining) noexcept {
  for (Eigen::Index i = 0; i < time_constants.size(); ++i) {
    const double ratio = h / time_constants[i];
    const bool immediate = !(ratio < 1e3);
    remaining[i] = immediate ? 0.0 : std::exp(-ratio);
    mean_remaining[i] = immediate ? 0.0 : ratio > 0.0 ? -std::expm1(-ratio) / ratio : 1.0;
  }
}

}  // namespace fairway
