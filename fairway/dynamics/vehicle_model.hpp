// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <span>
#include <string>
#include <string_view>

#include "fairway/core/params.hpp"
#include "fairway/core/state.hpp"
#include "fairway/core/water.hpp"
#include "fairway/core/wrench.hpp"

namespace fairway {

/// At most this many actuators on one vehicle, so that their values never allocate: six vehicles of five
/// thrusters each in one rigid body, and two more.
inline constexpr int max_actuators = 32;

/// One value per actuator, in the order of the model's `actuators()`.
using ActuatorValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_actuators, 1>;

/// A thruster, rudder or setpoint that a vehicle is driven by.
struct ActuatorInfo {
  std::string name;  ///< ends in its unit: "surge_port_n"; the column of `fairway trial`
  std::string meaning;
  Range range{};             ///< hard limits
  double time_constant_s{};  ///< of the first-order lag from command to state; 0 = none
};

/// Time derivative of a VehicleState.
struct StateRate {
  Vec3 p_n = Vec3::Zero();                         ///< [m/s, NED]
  Eigen::Vector4d q_nb = Eigen::Vector4d::Zero();  ///< of the coefficients x, y, z, w
  Vec3 v_b = Vec3::Zero();                         ///< [m/s2, body axes]
  Vec3 omega_b = Vec3::Zero();                     ///< [rad/s2, body axes]
};

/// What to print about a vehicle, and where its numbers come from.
struct VehicleInfo {
  std::string_view name;  ///< as written in a scenario: "sparus2"
  std::string_view title;
  std::string_view source;
  bool floats = false;  ///< it lives on the surface, and is simulated there alone
};

/// A vehicle's equations: constants only. x' = f(x, u, water); nothing here knows a time step, so
/// integrators stay interchangeable.
template <class M>
concept VehicleModel =
    requires(const M& model, const VehicleState& x, const ActuatorValues& u, const Water& water) {
      requires Reflected<typename M::Params> && std::copyable<M>;
      { M::info } -> std::convertible_to<VehicleInfo>;
      { M{typename M::Params{}} };
      { model.actuators() } -> std::convertible_to<std::span<const ActuatorInfo>>;
      { model.derivative(x, u, water) } noexcept -> std::same_as<StateRate>;
      { model.power(u) } noexcept -> std::same_as<double>;  // drawn by the actuators [W]
    };

}  // namespace fairway
