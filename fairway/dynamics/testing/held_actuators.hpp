// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "fairway/core/angles.hpp"
#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// One value for each actuator, in their order.
inline ActuatorValues values(std::initializer_list<double> of) {
  return Eigen::Map<const Eigen::VectorXd>(of.begin(), static_cast<Eigen::Index>(of.size()));
}

/// Actuators held at `u` for `duration_s`.
struct Leg {
  double duration_s;
  ActuatorValues u;

  Leg(double duration, std::initializer_list<double> held) : duration_s{duration}, u{values(held)} {}
};

/// The state of a vehicle after `legs`, by Runge-Kutta steps of 0.01 s, without lag.
inline VehicleState driven(Vehicle vehicle, const std::vector<Leg>& legs, const Water& water = {}) {
  constexpr double step_s = 0.01;
  for (const Leg& leg : legs) {
    vehicle.set_actuator_state(leg.u);
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

/// What has port and starboard exchanged.
inline TwelveStates mirrored(const VehicleState& x) {
  const Euler e = euler_of(x.q_nb);
  return {x.v_b.x(), -x.v_b.y(), x.v_b.z(), -x.omega_b.x(), x.omega_b.y(), -x.omega_b.z(),
          x.p_n.x(), -x.p_n.y(), x.p_n.z(), -e.roll,        e.pitch,       -e.yaw};
}

/// nu' in all six axes.
inline Wrench acceleration(const StateRate& rate) {
  Wrench nu_dot;
  nu_dot << rate.v_b, rate.omega_b;
  return nu_dot;
}

/// Expects nu^T M nu' < 0 with the actuators at zero, for many motions at the place and attitude of `x`,
/// where nothing static does work.
inline void expect_water_to_take_energy(const Vehicle& vehicle, const Eigen::Matrix<double, 6, 6>& mass,
                                        VehicleState x) {
  const ActuatorValues zero = ActuatorValues::Zero(static_cast<Eigen::Index>(vehicle.actuators().size()));
  for (int i = 0; i < 200; ++i) {
    x.v_b = {2.0 * std::sin(1.0 + i), std::sin(2.3 * i), 0.5 * std::sin(3.1 * i)};
    x.omega_b = {std::sin(4.7 * i), std::sin(5.3 * i), std::sin(6.1 * i)};
    Wrench nu;
    nu << x.v_b, x.omega_b;
    EXPECT_LT(nu.dot(mass * acceleration(vehicle.rate(x, zero, {}))), 0.0);
  }
}

}  // namespace fairway
