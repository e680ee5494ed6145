// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/rrt_star/trajectory_tracker.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

constexpr int surge = 0, sway = 1, yaw = 5;

/// An Earth-fixed vector of the plane in the axes of a body at heading `psi`.
Vec2 in_body_axes(const Vec2& v, double psi) { return turned(v, -psi); }

/// How far the vehicle is from where it should be, and how fast that changes: north, east, heading.
struct TrackingError {
  Vec3 value;
  Vec3 rate;
};

TrackingError error_of(const TrackingParams& params, const TrajectorySample& wanted, const Ownship& own) {
  const Vec2 e = wanted.position - seen_from_above(own.position);
  const Vec2 rate = wanted.velocity - seen_from_above(own.velocity);
  return {{e.x(), e.y(), wrap_angle(params.heading_rad - own.yaw)}, {rate.x(), rate.y(), -own.yaw_rate}};
}

/// Force north and east, and moment.
Vec3 feedback(const TrackingParams& params, const TrackingError& error, const Situation& s, Vec3& integral) {
  const Vec3 kp{params.kp_x_npm, params.kp_y_npm, params.kp_psi_nmprad};
  const Vec3 kd{params.kd_x_npmps, params.kd_y_npmps, params.kd_psi_nmpradps};
  const Vec3 proportional = kp.cwiseProduct(error.value);

  const Vec3 most{s.model->greatest[surge], s.model->greatest[sway], s.model->greatest[yaw]};
  integral += params.integral_hz * s.period * proportional;
  integral = integral.cwiseMin(most).cwiseMax(-most);
  return proportional + kd.cwiseProduct(error.rate) + integral;
}

/// Forces in surge and sway that the trajectory takes by the model, without turning.
Vec2 forces_ahead(const OnboardModel& model, const TrajectorySample& wanted, double psi) {
  const Vec2 v = in_body_axes(wanted.velocity, psi);
  const Vec2 a = in_body_axes(wanted.acceleration, psi);
  return {model.mass[surge] * a.x() + model.drag(surge, v.x()),
          model.mass[sway] * a.y() + model.drag(sway, v.y())};
}

}  // namespace

Command TrajectoryTracker::follow(const Trajectory& trajectory, double time, const Situation& s,
                                  Memory& memory) const noexcept {
  const TrajectorySample wanted = trajectory.sample(time);
  const TrackingError error = error_of(params, wanted, s.own);

  const Vec2 velocity = wanted.velocity + params.position_bandwidth_radps * error.value.head<2>();
  Command command{.velocity = {velocity.x(), velocity.y(), 0.0}};
  if (s.model == nullptr) return command;

  const Vec3 pushed = feedback(params, error, s, memory.integral);
  Vec2 forces = in_body_axes(pushed.head<2>(), s.own.yaw);
  if (params.feed_forward) forces += forces_ahead(*s.model, wanted, s.own.yaw);

  Wrench wrench = s.model->restoring;
  wrench[surge] += forces.x();
  wrench[sway] += forces.y();
  wrench[yaw] += pushed.z();
  command.wrench = wrench;
  command.heading = params.heading_rad;
  return command;
}

}  // namespace fairway
