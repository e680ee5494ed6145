// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/actuators.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

Actuators::Actuators(std::span<const ActuatorInfo> actuators) {
  const auto size = static_cast<Eigen::Index>(std::min<std::size_t>(actuators.size(), max_actuators));
  lowest_.resize(size);
  highest_.resize(size);
  time_constants_.resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const ActuatorInfo& actuator = actuators[static_cast<std::size_t>(i)];
    lowest_[i] = actuator.range.lo;
    highest_[i] = actuator.range.hi;
    time_constants_[i] = actuator.time_constant_s;
  }
  now_ = rest();
  remaining_ = mean_remaining_ = ActuatorValues::Zero(size);
}

double Actuators::admissible(const ActuatorValues& u, Eigen::Index i) const noexcept {
  if (i >= u.size() || std::isnan(u[i])) return now_[i];
  return std::clamp(u[i], lowest_[i], highest_[i]);
}

void Actuators::set(const ActuatorValues& u) noexcept {
  for (Eigen::Index i = 0; i < now_.size(); ++i) now_[i] = admissible(u, i);
}

ActuatorValues Actuators::follow(const ActuatorValues& command, double h) noexcept {
  if (h != step_) {  // an exponential each
    for (Eigen::Index i = 0; i < now_.size(); ++i) {
      const double ratio = h / time_constants_[i];
      const bool immediate = !(ratio < 1e3);
      remaining_[i] = immediate ? 0.0 : std::exp(-ratio);
      mean_remaining_[i] = immediate ? 0.0 : ratio > 0.0 ? -std::expm1(-ratio) / ratio : 1.0;
    }
    step_ = h;
  }

  ActuatorValues mean = now_;
  for (Eigen::Index i = 0; i < now_.size(); ++i) {
    const double target = admissible(command, i);
    const double error = now_[i] - target;
    mean[i] = target + error * mean_remaining_[i];
    now_[i] = target + error * remaining_[i];
  }
  return mean;
}

}  // namespace fairway
