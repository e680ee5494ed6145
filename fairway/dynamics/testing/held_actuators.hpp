// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "fairway/core/angles.hpp"
#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// Actuators held at `values` for `duration_s`.
struct Leg {
  double duration_s;
  std::vector<double> values;
};

/// The state of a vehicle after `legs`, by Runge-Kutta steps of 0.01 s, without lag.
inline VehicleState driven(Vehicle vehicle, const std::vector<Leg>& legs, const Water& water = {}) {
  constexpr double step_s = 0.01;
  for (const Leg& leg : legs) {
    vehicle.set_actuator_state(
        Eigen::Map<const Eigen::VectorXd>(leg.values.data(), static_cast<Eigen::Index>(leg.values.size())));
    const long steps = std::lround(leg.duration_s / step_s);
    for (long i = 0; i < steps; ++i) vehicle.drift(water, step_s);
  }
  return vehicle.state();
}

/// u v w p q r x y z roll pitch yaw: Fossen's nu and eta in SI units.
using TwelveStates = std::array<double, 12>;

/// The largest difference of any of the twelve, yaw by the nearest turn.
inline double deviation(const VehicleState& x, const TwelveStates& expected) {
  const Euler e = euler_of(x.q_nb);
  const TwelveStates states{x.v_b.x(), x.v_b.y(), x.v_b.z(), x.omega_b.x(), x.omega_b.y(), x.omega_b.z(),
                            x.p_n.x(), x.p_n.y(), x.p_n.z(), e.roll,        e.pitch,       e.yaw};
  double largest = std::abs(std::remainder(states[11] - expected[11], 2.0 * pi));
  for (std::size_t i = 0; i < 11; ++i) largest = std::fmax(largest, std::abs(states[i] - expected[i]));
  return largest;
}

}  // namespace fairway
