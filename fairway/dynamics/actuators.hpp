// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// The actuators of one vehicle with their limits and lags: as they are, in a Vehicle, or as they should be
/// by the commands that they were given, for a controller that does not measure them. A value: a copy shares
/// what stays as it is, so of a fleet of alike that is in memory once. Nothing allocates but the first step
/// of another length that a copy takes while it shares.
class Actuators {
 public:
  /// At rest().
  explicit Actuators(std::span<const ActuatorInfo> actuators);

  double lowest(Eigen::Index i) const { return channel(i).lowest; }
  double highest(Eigen::Index i) const { return channel(i).highest; }

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
  /// Steps are `h` [s] from now on: what they share, copies then have in common.
  void prepare(double h) noexcept;
  /// The last h [s], or that which was prepared; negative before the first.
  double step() const { return shared_->step; }

 private:
  struct Channel {
    double lowest;
    double highest;
    double time_constant;
    double remaining{};       // x(h) = c + (x(0) - c) remaining, for the last step
    double mean_remaining{};  // and the mean over it likewise
  };

  /// What does not change from step to step.
  struct Shared {
    std::vector<Channel> channels;
    double step{-1.0};
  };

  const Channel& channel(Eigen::Index i) const { return shared_->channels[static_cast<std::size_t>(i)]; }
  double admissible(const ActuatorValues& u, Eigen::Index i) const noexcept;

  std::shared_ptr<Shared> shared_;  // written by who has it alone
  Eigen::VectorXd now_;             // a vehicle has a few of the many that it may have
};

}  // namespace fairway
