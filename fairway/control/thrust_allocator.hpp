// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/core/params.hpp"
#include "fairway/dynamics/propulsion.hpp"

namespace fairway {

/// How forces are shared out among the thrusters.
enum class AllocationMethod {
  bounded,         ///< the nearest wrench that the limits allow
  pseudo_inverse,  ///< u = B^+ tau, then each thruster held to its limits, as rehman2021 has it
};

template <>
struct EnumNames<AllocationMethod> {
  static constexpr std::array names{"bounded", "pseudo_inverse"};
};

/// Thrust for a wrench: B u = tau with B the thrust configuration matrix (Fossen 2021, section 11.2).
/// A value; allocate() is O(axes thrusters) for `pseudo_inverse`, and neither allocates nor throws.
class ThrustAllocator {
 public:
  /// `actuators`: as many as `propulsion.effectiveness` has columns, else InputError.
  ThrustAllocator(const Propulsion& propulsion, std::span<const ActuatorInfo> actuators,
                  AllocationMethod method);

  /// Thrusts within their limits. Axes that the thrusters cannot push, and entries of `tau` that are not
  /// finite, are left at zero.
  ActuatorValues allocate(const Wrench& tau) const noexcept;

 private:
  AllocationMethod method_;
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, max_actuators> B_;
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, max_actuators, 6> inverse_;
  ActuatorValues lowest_;
  ActuatorValues highest_;
};

}  // namespace fairway
