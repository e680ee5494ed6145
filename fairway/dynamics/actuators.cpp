// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/actuators.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {

Actuators::Actuators(std::span<const ActuatorInfo> actuators) {
  for (const ActuatorInfo& actuator : actuators.first(std::min<std::size_t>(actuators.size(), max_actuators)))
    channels_.push_back({actuator.range.lo, actuator.range.hi, actuator.time_constant_s});
  now_.setZero(static_cast<Eigen::Index>(channels_.size()));
  now_ = rest();
}

double Actuators::admissible(const ActuatorValues& u, Eigen::Index i) const noexcept {
  if (i >= u.size() || std::isnan(u[i])) return now_[i];
  return std::clamp(u[i], lowest(i), highest(i));
}

void Actuators::set(const ActuatorValues& u) noexcept {
  for (Eigen::Index i = 0; i < now_.size(); ++i) now_[i] = admissible(u, i);
}

ActuatorValues Actuators::follow(const ActuatorValues& command, double h) noexcept {
  if (h != step_) {  // an exponential each
    for (Channel& channel : channels_) {
      const double ratio = h / channel.time_constant;
      const bool immediate = !(ratio < 1e3);
      channel.remaining = immediate ? 0.0 : math::exp(-ratio);
      channel.mean_remaining = immediate ? 0.0 : ratio > 0.0 ? -math::expm1(-ratio) / ratio : 1.0;
    }
    step_ = h;
  }

  ActuatorValues mean(now_.size());
  for (Eigen::Index i = 0; i < now_.size(); ++i) {
    const Channel& channel = channels_[static_cast<std::size_t>(i)];
    const double target = admissible(command, i);
    const double error = now_[i] - target;
    mean[i] = target + error * channel.mean_remaining;
    now_[i] = target + error * channel.remaining;
  }
  return mean;
}

}  // namespace fairway
