// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/pilot.hpp"

#include <algorithm>

namespace fairway {

Ownship Pilot::own_ship(const VehicleState& x, double position_sigma, bool has_arrived) const noexcept {
  return {.id = ship_.id,
          .position = x.p_n,
          .velocity = x.v_n(),
          .yaw = yaw_of(x.q_nb),
          .yaw_rate = x.omega_b.z(),
          .radius = ship_.radius,
          .priority = has_arrived ? last_priority : ship_.priority,
          .position_sigma = position_sigma};
}

Situation Pilot::situation(double time, const Ownship& own, const Leg& leg, std::span<const Track> tracks,
                           std::span<const Obstacle> obstacles) const noexcept {
  Goal goal{.position = leg.position, .cruise_speed = leg.speed_mps, .arrival = leg.arrival_m};
  if (leg.kind == LegKind::section) goal.velocity = follow_section(leg, own).velocity;
  return {.time = time,
          .period = period_,
          .own = own,
          .goal = goal,
          .limits = ship_.limits,
          .model = ship_.model ? &*ship_.model : nullptr,
          .envelope = ship_.envelope ? &*ship_.envelope : nullptr,
          .tracks = tracks,
          .obstacles = obstacles};
}

bool Pilot::is_due(double now, double interval) const noexcept {
  return now + 0.5 * std::clamp(interval, 0.0, period_) >= next_decision_;
}

void Pilot::obey(const Command& command, const Ownship& own, const Vec3& current_n) noexcept {
  command_ = command;
  const bool hold = command.mode == Mode::hold && !command.turn_rate;
  if (hold && !holding_) hold_ = {own.position, own.yaw};
  if (hold) hold_.yaw = holding_yaw(hold_, own, current_n);
  holding_ = hold;
}

BodyRequest Pilot::request(const Ownship& own, const Vec3& current_n, bool avoids) const noexcept {
  const SteeringParams& steering = ship_.steering;
  if (steering.kind == SteeringKind::crab) {
    const Command command =
        holding_ ? circle(hold_, steering.circle_radius_m, steering.min_speed_mps, own) : command_;
    return steer_through_water(steering, command, own.yaw, current_n);
  }
  if (holding_) return keep_position(hold_, own);
  if (avoids) return steer(steering, command_, own.yaw);
  SteeringParams plainly = steering;
  plainly.kind = SteeringKind::proportional;
  return steer(plainly, command_, own.yaw);
}

BodyRequest Pilot::blind_request() const noexcept {
  const SteeringParams& steering = ship_.steering;
  if (steering.kind != SteeringKind::crab) return {};
  return {.surge_mps = steering.min_speed_mps,
          .yaw_rate_radps = steering.min_speed_mps / steering.circle_radius_m,
          .through_water = true};
}

}  // namespace fairway
