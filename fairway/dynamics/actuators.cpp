// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/actuators.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {

Actuators::Actuators(std::span<const ActuatorInfo> actuators) : shared_{std::make_shared<Shared>()} {
  for (const ActuatorInfo& actuator : actuators.first(std::min<std::size_t>(actuators.size(), max_actuators)))
    shared_->channels.push_back({actuator.range.lo, actuator.range.hi, actuator.time_constant_s});
  now_.setZero(static_cast<Eigen::Index>(shared_->channels.size()));
  now_ = rest();
}

double Actuators::admissible(const ActuatorValues& u, Eigen::Index i) const noexcept {
  if (i >= u.size() || std::isnan(u[i])) return now_[i];
  return std::clamp(u[i], lowest(i), highest(i));
}

void Actuators::set(const ActuatorValues& u) noexcept {
  for (Eigen::Index i = 0; i < now_.size(); ++i) now_[i] = admissible(u, i);
}

void Actuators::prepare(double h) noexcept {
  if (h == shared_->step) return;
  if (shared_.use_count() > 1) shared_ = std::make_shared<Shared>(*shared_);
  shared_->step = h;
  for (Channel& channel : shared_->channels) {  // an exponential each
    const double ratio = h / channel.time_constant;
    const bool immediate = !(ratio < 1e3);
    channel.remaining = immediate ? 0.0 : math::exp(-ratio);
    channel.mean_remaining = immediate ? 0.0 : ratio > 0.0 ? -math::expm1(-ratio) / ratio : 1.0;
  }
}

ActuatorValues Actuators::follow(const ActuatorValues& command, double h) noexcept {
  prepare(h);
  ActuatorValues mean(now_.size());
  for (Eigen::Index i = 0; i < now_.size(); ++i) {
    const double target = admissible(command, i);
    const double error = now_[i] - target;
    mean[i] = target + error * channel(i).mean_remaining;
    now_[i] = target + error * channel(i).remaining;
  }
  return mean;
}

}  // namespace fairway
