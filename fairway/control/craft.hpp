// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/control/autopilot.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// A vehicle that obeys body requests in still water, for trials of what it does under its autopilot.
struct Craft {
  static constexpr double longest = 120.0;      // of one trial [s]
  static constexpr double settling = 1.0;       // what changes no more within this is steady [s]
  static constexpr double steady_share = 2e-3;  // of the value

  Vehicle vehicle;
  Autopilot autopilot;
  double step;  ///< of its simulation and of its autopilot's decisions [s]

  void obey(const BodyRequest& request) {
    const VehicleState& x = vehicle.state();
    vehicle.step(autopilot.control(request, x.v_b, x.omega_b, step, x.q_nb), Water{}, step);
  }
  /// Velocities of the body through the water [m/s, rad/s, body]; `sinking` and `place` in NED [m/s, m].
  double surge() const { return vehicle.state().v_b.x(); }
  double sway() const { return vehicle.state().v_b.y(); }
  double sinking() const { return vehicle.state().v_n().z(); }
  double turn_rate() const { return vehicle.state().omega_b.z(); }
  Vec2 place() const { return vehicle.state().p_n.head<2>(); }
  double yaw() const { return yaw_of(vehicle.state().q_nb); }

  /// Obeys until `value` of it is steady, which it gives.
  template <class Value>
  double settle(const BodyRequest& request, Value value) {
    const auto window = std::max(1, static_cast<int>(settling / step));
    double before = value(*this);
    for (int k = 1; k * step < longest; ++k) {
      obey(request);
      if (k % window != 0) continue;
      const double now = value(*this);
      if (std::abs(now - before) <= steady_share * std::abs(now) + 1e-6) break;
      before = now;
    }
    return value(*this);
  }

  /// Obeys until `value` of it passes `level`, upwards or downwards. How long that took [s].
  template <class Value>
  double time_to(const BodyRequest& request, Value value, double level) {
    const bool upwards = value(*this) < level;
    double time = 0.0;
    for (; time < longest && (value(*this) < level) == upwards; time += step) obey(request);
    return time;
  }
};

}  // namespace fairway
