// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// Where actuators are by the commands that they were given, their limits and lags, for a controller that
/// does not measure them. A value; nothing but the constructor allocates.
class ExpectedActuators {
 public:
  explicit ExpectedActuators(std::span<const ActuatorInfo> actuators);

  const ActuatorValues& lowest() const { return lowest_; }
  const ActuatorValues& highest() const { return highest_; }

  /// At rest, or as near to it as the limits allow.
  ActuatorValues rest() const { return limited(ActuatorValues::Zero(lowest_.size())); }
  ActuatorValues limited(const ActuatorValues& u) const { return u.cwiseMax(lowest_).cwiseMin(highest_); }

  /// Takes for granted that `command`, which is within the limits, is carried out for the next `h` [s].
  void follow(const ActuatorValues& command, double h) noexcept;

  /// Over the step of the last command.
  const ActuatorValues& mean() const { return mean_; }
  /// Length of that step [s]; negative before the first.
  double step() const { return step_; }

 private:
  ActuatorValues lowest_;
  ActuatorValues highest_;
  ActuatorValues time_constants_;
  ActuatorValues now_;
  ActuatorValues mean_;
  double step_{-1.0};
  ActuatorValues remaining_;  // for that step
  ActuatorValues mean_remaining_;
};

}  // namespace fairway
