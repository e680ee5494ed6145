// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/expected_actuators.hpp"

#include "fairway/dynamics/lag.hpp"

namespace fairway {

ExpectedActuators::ExpectedActuators(std::span<const ActuatorInfo> actuators) {
  const auto size = static_cast<Eigen::Index>(actuators.size());
  lowest_.resize(size);
  highest_.resize(size);
  time_constants_.resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const ActuatorInfo& actuator = actuators[static_cast<std::size_t>(i)];
    lowest_[i] = actuator.range.lo;
    highest_[i] = actuator.range.hi;
    time_constants_[i] = actuator.time_constant_s;
  }
  now_ = mean_ = rest();
  remaining_ = mean_remaining_ = ActuatorValues::Zero(size);
}

void ExpectedActuators::follow(const ActuatorValues& command, double h) noexcept {
  if (h != step_) {
    first_order_lag(time_constants_, h, remaining_, mean_remaining_);
    step_ = h;
  }
  mean_ = command + (now_ - command).cwiseProduct(mean_remaining_);
  now_ = command + (now_ - command).cwiseProduct(remaining_);
}

}  // namespace fairway
