// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// The actuators of one vehicle with their limits and lags: as they are, in a Vehicle, or as they should be
/// by the commands that they were given, for a controller that does not measure them. A value; nothing
/// allocates.
class Actuators {
 public:
  /// At rest().
  explicit Actuators(std::span<const ActuatorInfo> actuators);

  double lowest(Eigen::Index i) const { return channels_[static_cast<std::size_t>(i)].lowest; }
  double highest(Eigen::Index i) const { return channels_[static_cast<std::size_t>(i)].highest; }

  /// Zero, or as near to it as the limits allow.
  ActuatorValues rest() const { return limited(ActuatorValues::Zero(now_.size())); }
  ActuatorValues limited(const ActuatorValues& u) const {
    ActuatorValues within(u.size());
    for (Eigen::Index i = 0; i < u.size(); ++i) within[i] = std::min(std::max(u[i], lowest(i)), highest(i));
    return within;
  }

  const Eigen::VectorXd& now() const { return now_; }
  /// Puts them there at once, within their limits. NaN, and what is not said, leaves one where it is.
  void set(const ActuatorValues& u) noexcept;

  /// Follows `command` for `h` [s], as set() reads it, by exact first-order lags: T x' = c - x with the
  /// command c held. Gives the mean over h.
  ActuatorValues follow(const ActuatorValues& command, double h) noexcept;
  /// The last h [s]; negative before the first.
  double step() const { return step_; }

 private:
  struct Channel {
    double lowest;
    double highest;
    double time_constant;
    double remaining{};       // x(h) = c + (x(0) - c) remaining, for the last step
    double mean_remaining{};  // and the mean over it likewise
  };

  double admissible(const ActuatorValues& u, Eigen::Index i) const noexcept;

  // a vehicle has a few of the many that it may have
  std::vector<Channel> channels_;
  Eigen::VectorXd now_;
  double step_{-1.0};
};

}  // namespace fairway
