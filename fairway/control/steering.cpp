// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/steering.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// Heading error, and which way to drive.
struct Aim {
  double alpha;      ///< [rad]
  double direction;  ///< +1 ahead, -1 astern
};

Aim aim_of(const Command& command, double speed, double yaw) {
  if (command.heading) return {wrap_angle(*command.heading - yaw), 1.0};
  if (speed <= 0.0) return {0.0, 1.0};
  const double alpha = wrap_angle(math::atan2(command.velocity.y(), command.velocity.x()) - yaw);
  if (!command.astern || std::abs(alpha) < pi / 2) return {alpha, 1.0};
  return {alpha > 0.0 ? alpha - pi : alpha + pi, -1.0};
}

double turn_rate(const SteeringParams& params, double error) {
  return std::clamp(params.turn_gain_hz * error, -params.max_turn_rate_radps, params.max_turn_rate_radps);
}

/// Whether the velocity is not along the heading that is asked for: then it is made as far as it is along the
/// bow.
bool leads_elsewhere(const Command& command, double speed) {
  constexpr double rounding = 1e-6;  // [rad]
  if (!command.heading || speed <= 0.0) return false;
  const double course = math::atan2(command.velocity.y(), command.velocity.x());
  return std::abs(wrap_angle(course - *command.heading)) > rounding;
}

BodyRequest go_as_you_are(const SteeringParams& params, const Command& command, double yaw) {
  const double error = wrap_angle(command.heading.value_or(params.heading_rad) - yaw);
  const Vec2 level_b = turned(command.velocity.head<2>(), -yaw);
  return {.surge_mps = level_b.x(),
          .sway_mps = level_b.y(),
          .heave_mps = command.velocity.z(),
          .yaw_rate_radps = turn_rate(params, error)};
}

}  // namespace

BodyRequest steer(const SteeringParams& params, const Command& command, double yaw) noexcept {
  if (command.turn_rate) {
    return {.surge_mps = unit_at(yaw).dot(command.velocity.head<2>()),
            .heave_mps = command.velocity.z(),
            .yaw_rate_radps = *command.turn_rate};
  }
  if (params.kind == SteeringKind::holonomic) return go_as_you_are(params, command, yaw);
  const double speed = horizontal_norm(command.velocity);
  const Aim aim = aim_of(command, speed, yaw);
  BodyRequest request{.heave_mps = command.velocity.z()};
  if (leads_elsewhere(command, speed)) {
    request.surge_mps = unit_at(yaw).dot(command.velocity.head<2>());
    request.yaw_rate_radps = turn_rate(params, aim.alpha);
    return request;
  }

  if (params.kind != SteeringKind::turn_then_go) {
    const bool waits = params.kind == SteeringKind::proportional;
    request.surge_mps = aim.direction * speed * (waits ? math::fmax(0.0, math::cos(aim.alpha)) : 1.0);
    request.yaw_rate_radps = turn_rate(params, aim.alpha);
    return request;
  }

  const bool aligned = std::abs(aim.alpha) <= params.ori_error_rad;
  request.surge_mps = aligned ? aim.direction * speed : 0.0;
  request.yaw_rate_radps =
      (aligned ? params.k_rot_min_ratio : params.k_rot_max_ratio) * params.rot_vel_radps * aim.alpha;
  return request;
}

BodyRequest steer_through_water(const SteeringParams& params, const Command& command, double yaw,
                                const Vec3& current_n) noexcept {
  const Vec3 wanted = command.velocity - current_n;
  const double speed = horizontal_norm(wanted);
  const double course = speed > 0.0 ? math::atan2(wanted.y(), wanted.x()) : yaw;
  const double error = wrap_angle(command.heading.value_or(course) - yaw);
  const bool turns_by_itself =
      command.turn_rate || leads_elsewhere(command, horizontal_norm(command.velocity));
  const double ahead = turns_by_itself ? math::fmax(0.0, unit_at(yaw).dot(wanted.head<2>())) : speed;
  return {.surge_mps = math::fmax(math::hypot(ahead, wanted.z()), params.min_speed_mps),
          .heave_mps = wanted.z(),
          .yaw_rate_radps = command.turn_rate.value_or(turn_rate(params, error)),
          .through_water = true};
}

}  // namespace fairway
