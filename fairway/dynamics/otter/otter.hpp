// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/dynamics/otter/otter_hull.hpp"
#include "fairway/dynamics/propulsion.hpp"

namespace fairway {

/// Otter, an uncrewed surface catamaran (2.0 m x 1.08 m, 55 kg and payload) steered by the speed difference
/// of its two propellers. README.md beside this file has equations and numbers.
class Otter {
 public:
  static constexpr VehicleInfo info{
      .name = "otter",
      .title = "Maritime Robotics Otter USV, propeller speeds",
      .source = "Fossen, MSS toolbox, otter.m (2026); fairway/dynamics/otter/README.md",
      .floats = true};
  using Params = OtterParams;

  /// Throws InputError if the boat has no positive metacentric height under its payload.
  explicit Otter(const Params& params);

  /// n1_radps (port), n2_radps (starboard): speeds of the propellers, positive ahead.
  std::span<const ActuatorInfo> actuators() const { return actuators_; }

  StateRate derivative(const VehicleState& x, const ActuatorValues& u, const Water& water) const noexcept {
    return hull_.derivative(x, thrust(u[0]), thrust(u[1]), water);
  }

  /// Thrust [N, positive ahead] of one propeller turning at `n_radps`: k n |n|, whatever the speed of the
  /// boat.
  static double thrust(double n_radps) noexcept;

  /// The power of ideal actuator disks of the propellers' diameter at the same thrust [W]: a lower bound of
  /// the electrical power.
  double power(const ActuatorValues& u) const noexcept;

  const OtterHull& hull() const { return hull_; }

 private:
  OtterHull hull_;
  double disk_area_;  // [m2]
  std::array<ActuatorInfo, 2> actuators_;
};

/// The same boat with thrust as its actuators: on board, each propeller is turned as fast as the thrust asked
/// of it takes. That can be done exactly, since the thrust is a function of propeller speed alone; and being
/// linear in its actuators, this one can be driven by the Autopilot.
class OtterByThrust {
 public:
  static constexpr VehicleInfo info{.name = "otter_by_thrust",
                                    .title = "Maritime Robotics Otter USV, thrusts",
                                    .source = Otter::info.source,
                                    .floats = true};
  using Params = OtterParams;

  /// Throws InputError if the boat has no positive metacentric height under its payload.
  explicit OtterByThrust(const Params& params);

  /// port_n, starboard_n: thrusts of the propellers, positive ahead.
  std::span<const ActuatorInfo> actuators() const { return actuators_; }

  StateRate derivative(const VehicleState& x, const ActuatorValues& u, const Water& water) const noexcept {
    return hull_.derivative(x, u[0], u[1], water);
  }

  /// As that of Otter [W].
  double power(const ActuatorValues& u) const noexcept;

  const Propulsion& propulsion() const { return propulsion_; }

 private:
  OtterHull hull_;
  double disk_area_;  // [m2]
  std::array<ActuatorInfo, 2> actuators_;
  Propulsion propulsion_;
};

}  // namespace fairway
