// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// The actuators of one vehicle with their limits and lags: as they are, in a Vehicle, or as they should be
/// by the commands that they were given, for a controller that does not measure them. A value; nothing
/// allocates.
class Actuators {
 public:
  /// At rest().
  explicit Actuators(std::span<const ActuatorInfo> actuators);

  const ActuatorValues& lowest() const { return lowest_; }
  const ActuatorValues& highest() const { return highest_; }

  /// Zero, or as near to it as the limits allow.
  ActuatorValues rest() const { return limited(ActuatorValues::Zero(lowest_.size())); }
  ActuatorValues limited(const ActuatorValues& u) const { return u.cwiseMax(lowest_).cwiseMin(highest_); }

  const ActuatorValues& now() const { return now_; }
  /// Puts them there at once, within their limits. NaN, and what is not said, leaves one where it is.
  void set(const ActuatorValues& u) noexcept;

  /// Follows `command` for `h` [s], as set() reads it, by exact first-order lags: T x' = c - x with the
  /// command c held. Gives the mean over h.
  ActuatorValues follow(const ActuatorValues& command, double h) noexcept;
  /// The last h [s]; negative before the first.
  double step() const { return step_; }

 private:
  double admissible(const ActuatorValues& u, Eigen::Index i) const noexcept;

  ActuatorValues lowest_;
  ActuatorValues highest_;
  ActuatorValues time_constants_;
  ActuatorValues now_;
  double step_{-1.0};
  ActuatorValues remaining_;       // x(h) = c + (x(0) - c) remaining, for that step
  ActuatorValues mean_remaining_;  // and the mean over it likewise
};

}  // namespace fairway
