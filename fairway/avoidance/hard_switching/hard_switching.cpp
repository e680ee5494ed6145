// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/hard_switching/hard_switching.hpp"

#include <Eigen/Geometry>

#include "fairway/core/angles.hpp"

namespace fairway {

Wrench HardSwitching::go_to_goal(const Situation& s, Memory& memory, double elapsed) const noexcept {
  const Vec3 error = s.goal.position - s.own.position;
  memory.goal_integral += elapsed * error;
  const Vec3 tau_n = params.goal_kp_npm * error + params.goal_ki_npmps * memory.goal_integral -
                     params.goal_kd_kgps * s.own.velocity;
  Wrench tau = Wrench::Zero();
  tau.head<2>() = turned(tau_n.head<2>(), -s.own.yaw);
  return tau;
}

Wrench HardSwitching::turn_away(const Situation& s, Memory& memory, double elapsed) const noexcept {
  const double error = params.latch ? wrap_angle(memory.set_point - s.own.yaw) : pi / 2;
  const double error_rate = params.latch ? -s.own.yaw_rate : 0.0;
  memory.yaw_integral += elapsed * error;
  Wrench tau = Wrench::Zero();
  tau[5] = params.yaw_kp_nmprad * error + params.yaw_ki_nmpradps * memory.yaw_integral +
           params.yaw_kd_kgm2ps * error_rate;
  return tau;
}

Command HardSwitching::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  const PointSensors sensors{params.sensor_count, params.sensor_arm_m, params.sensor_range_m};
  const auto detected = nearest_detected(s, sensors);
  if (detected.has_value() != memory.avoiding)
    memory = {.avoiding = !memory.avoiding, .set_point = wrap_angle(s.own.yaw + pi / 2)};
  const double elapsed = s.time - memory.last_time.value_or(s.time);
  memory.last_time = s.time;

  if (context.sketch) draw(sensors, s.own, detected, "detected", *context.sketch);
  if (!detected) return {.velocity = s.preferred_velocity(), .wrench = go_to_goal(s, memory, elapsed)};
  return {.mode = Mode::avoid, .wrench = turn_away(s, memory, elapsed)};
}

}  // namespace fairway
