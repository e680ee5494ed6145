// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/vehicle.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/dynamics/lag.hpp"

namespace fairway {

void Vehicle::equip() {
  const std::span<const ActuatorInfo> infos = self_->actuators();
  const auto size = static_cast<Eigen::Index>(std::min<std::size_t>(infos.size(), max_actuators));
  lowest_.resize(size);
  highest_.resize(size);
  time_constants_.resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const ActuatorInfo& info = infos[static_cast<std::size_t>(i)];
    lowest_[i] = info.range.lo;
    highest_[i] = info.range.hi;
    time_constants_[i] = info.time_constant_s;
  }
  remaining_ = mean_remaining_ = ActuatorValues::Zero(size);
  actuators_ = ActuatorValues::Zero(size).cwiseMax(lowest_).cwiseMin(highest_);
}

double Vehicle::admissible(const ActuatorValues& values, Eigen::Index i) const noexcept {
  if (i >= values.size() || std::isnan(values[i])) return actuators_[i];
  return std::clamp(values[i], lowest_[i], highest_[i]);
}

void Vehicle::set_actuator_state(const ActuatorValues& values) noexcept {
  for (Eigen::Index i = 0; i < actuators_.size(); ++i) actuators_[i] = admissible(values, i);
}

void Vehicle::step(const ActuatorValues& command, const Water& water, double h) noexcept {
  if (h != lag_step_) {
    first_order_lag(time_constants_, h, remaining_, mean_remaining_);
    lag_step_ = h;
  }

  ActuatorValues mean = actuators_;
  for (Eigen::Index i = 0; i < actuators_.size(); ++i) {
    const double target = admissible(command, i);
    const double error = actuators_[i] - target;
    mean[i] = target + error * mean_remaining_[i];
    actuators_[i] = target + error * remaining_[i];
  }
  self_->advance(state_, mean, water, h);
}

}  // namespace fairway
