// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/kinematic/kinematic.hpp"

#include "fairway/core/params.hpp"

namespace fairway {

Kinematic::Kinematic(const Params& p)
    : numbers_{1.0 / checked_params(p).time_constant_s, p.max_acceleration_mps2,
               p.max_turn_acceleration_radps2},
      sways_{p.max_sway_mps > 0.0},
      actuators_{ActuatorInfo{"surge_mps",
                              "setpoint of the speed ahead through the water",
                              {-p.max_reverse_mps, p.max_speed_mps},
                              0.0},
                 ActuatorInfo{"heave_mps",
                              "setpoint of the speed down through the water",
                              {-p.max_heave_mps, p.max_heave_mps},
                              0.0},
                 ActuatorInfo{"yaw_rate_radps",
                              "setpoint of the turn rate, positive to starboard",
                              {-p.max_turn_rate_radps, p.max_turn_rate_radps},
                              0.0},
                 ActuatorInfo{"sway_mps",
                              "setpoint of the speed to starboard through the water",
                              {-p.max_sway_mps, p.max_sway_mps},
                              0.0}} {}

void Kinematic::SideBySide::add(VehicleState& x, const ActuatorValues& u, const Water& water) noexcept {
  if (!is_level(x, water)) {
    x = model_.advanced(x, u, water, bodies_.h);
    return;
  }
  const std::size_t width = kernel_.lanes;
  const auto& [p, q, v, omega] = x;
  const Vec3 wanted = model_.setpoint(u);
  bodies_.motion.write(width, count_, p.x(), p.y(), p.z(), v.x(), v.y(), v.z(), q.w(), q.z(), omega.z());
  bodies_.setpoint.write(width, count_, wanted.x(), wanted.y(), wanted.z(), u[2]);
  states_[count_++] = &x;
  if (count_ == width) finish();
}

void Kinematic::SideBySide::finish() noexcept {
  if (count_ == 0) return;
  const std::size_t width = kernel_.lanes;
  bodies_.motion.repeat_first(width, count_);
  bodies_.setpoint.repeat_first(width, count_);
  kernel_.step_level(model_.numbers_, bodies_);
  for (std::size_t lane = 0; lane < count_; ++lane)
    *states_[lane] = level_state([&](std::size_t i) { return bodies_.motion.of(width, lane, i); });
  count_ = 0;
}

}  // namespace fairway
