// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "fairway/core/onboard_model.hpp"
#include "fairway/planning/planar_map.hpp"

namespace fairway {

/// The transport system of rehman2021 in the plane, each axis for itself: mass 4800 kg, linear damping 140
/// kg/s, quadratic 2403 kg/m, alike ahead and abeam, and no Coriolis forces.
inline OnboardModel transport_model() {
  OnboardModel model;
  model.mass << 4800, 4800, 4800, 1, 1, 16285;
  model.linear_damping << 140, 140, 140, 0, 0, 1018;
  model.quadratic_damping << 2403, 2403, 2403, 0, 0, 27680;
  model.greatest << 778, 778, 0, 0, 0, 865;
  model.least = -model.greatest;
  return model;
}

/// A vessel that is as its model says, moved by RK4.
struct PlanarVessel {
  OnboardModel model;
  Vec2 position = Vec2::Zero();  ///< [m, NE]
  Vec2 v_b = Vec2::Zero();       ///< [m/s, body]
  double yaw{};                  ///< [rad]
  double yaw_rate{};             ///< [rad/s]

  Vec2 velocity() const { return turned(v_b, yaw); }

  void move(const Wrench& tau, double h) {
    const State x = (State{} << position, v_b, yaw, yaw_rate).finished();
    const State k1 = rate(x, tau), k2 = rate(x + 0.5 * h * k1, tau);
    const State k3 = rate(x + 0.5 * h * k2, tau), k4 = rate(x + h * k3, tau);
    const State next = x + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    position = next.head<2>();
    v_b = next.segment<2>(2);
    yaw = next[4];
    yaw_rate = next[5];
  }

 private:
  using State = Eigen::Matrix<double, 6, 1>;

  static Vec2 turned(const Vec2& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
  }

  State rate(const State& x, const Wrench& tau) const {
    State rate;
    rate.head<2>() = turned(x.segment<2>(2), x[4]);
    rate[2] = (tau[0] - model.drag(0, x[2])) / model.mass[0] + x[5] * x[3];
    rate[3] = (tau[1] - model.drag(1, x[3])) / model.mass[1] - x[5] * x[2];
    rate[4] = x[5];
    rate[5] = (tau[5] - model.drag(5, x[5])) / model.mass[5];
    return rate;
  }
};

}  // namespace fairway
