// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/dynamics/runge_kutta.hpp"
#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// `x` moved along `rate` for `h` [s]; the quaternion is left as it falls.
[[gnu::always_inline]] inline VehicleState moved(const VehicleState& x, const StateRate& rate, double h) {
  VehicleState y;
  y.p_n = x.p_n + h * rate.p_n;
  y.q_nb = {x.q_nb.w() + h * rate.q_nb[3], x.q_nb.x() + h * rate.q_nb[0], x.q_nb.y() + h * rate.q_nb[1],
            x.q_nb.z() + h * rate.q_nb[2]};
  y.v_b = x.v_b + h * rate.v_b;
  y.omega_b = x.omega_b + h * rate.omega_b;
  return y;
}

/// The mean of four rates over a step, those of its middle twice.
[[gnu::always_inline]] inline StateRate mean_of(const StateRate& k1, const StateRate& k2, const StateRate& k3,
                                                const StateRate& k4) {
  StateRate mean;
  mean.p_n = (k1.p_n + 2 * k2.p_n + 2 * k3.p_n + k4.p_n) / 6;
  for (int i = 0; i < 4; ++i) mean.q_nb[i] = (k1.q_nb[i] + 2 * k2.q_nb[i] + 2 * k3.q_nb[i] + k4.q_nb[i]) / 6;
  mean.v_b = (k1.v_b + 2 * k2.v_b + 2 * k3.v_b + k4.v_b) / 6;
  mean.omega_b = (k1.omega_b + 2 * k2.omega_b + 2 * k3.omega_b + k4.omega_b) / 6;
  return mean;
}

/// One step of a model (runge_kutta.hpp), actuators and water held. The quaternion is normalised after the
/// step.
template <VehicleModel M>
[[gnu::flatten]] VehicleState rk4(const M& model, const VehicleState& x, const ActuatorValues& u,
                                  const Water& water, double h) noexcept {
  const auto rate_of = [&](const VehicleState& at) __attribute__((always_inline)) {
    return model.derivative(at, u, water);
  };
  VehicleState y = runge_kutta(x, h, rate_of);
  y.q_nb.normalize();
  return y;
}

}  // namespace fairway
