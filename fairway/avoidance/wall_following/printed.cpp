// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/wall_following/printed.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "fairway/avoidance/hard_switching/point_sensors.hpp"
#include "fairway/core/angles.hpp"

namespace fairway::wall {
namespace {

using Params = WallFollowing::Params;

/// The velocity that the planning phase wants, and how it changes while the behaviour stays the same.
struct Wish {
  Vec2 velocity;  ///< [m/s, NED]
  Vec2 rate;      ///< [m/s2, NED]
};

struct Gains {
  double p;
  double i;
  double d;
};

/// The gains of surge, sway and yaw (Tables 2 and 6).
std::array<Gains, 3> gains_of(const Params& p, bool following) {
  if (following) {
    return {Gains{p.wall_surge_kp_kgps, p.wall_surge_ki_npm, p.wall_surge_kd_kg},
            Gains{p.wall_sway_kp_kgps, p.wall_sway_ki_npm, p.wall_sway_kd_kg},
            Gains{p.wall_yaw_kp_nmprad, p.wall_yaw_ki_nmpradps, p.wall_yaw_kd_kgm2ps}};
  }
  return {Gains{p.goal_surge_kp_kgps, p.goal_surge_ki_npm, p.goal_surge_kd_kg},
          Gains{p.goal_sway_kp_kgps, p.goal_sway_ki_npm, p.goal_sway_kd_kg},
          Gains{p.goal_yaw_kp_nmprad, p.goal_yaw_ki_nmpradps, p.goal_yaw_kd_kgm2ps}};
}

/// Equation 12.
Wish to_goal(const Params& p, const Situation& s) {
  const Vec2 error = (s.goal.position - s.own.position).head<2>();
  return {p.goal_gain_hz * error, -p.goal_gain_hz * s.own.velocity.head<2>()};
}

/// Equation 16, its direction held for the rate.
Wish along(const Params& p, const Situation& s, const Detection& obstacle, const Vec2& v_gtg) {
  const Vec2 away = (s.own.position - obstacle.centre).head<2>();
  const Vec2 away_rate = (s.own.velocity - obstacle.velocity).head<2>();
  const double gain = turn_along(away, v_gtg) * p.alpha_ratio * p.wall_gain_hz;
  return {gain * clockwise(away), gain * clockwise(away_rate)};
}

/// The tracking phase: PID on each body axis.
Wrench tracked(const Params& p, const Situation& s, const Wish& wish, WallFollowing::Loop& loop) {
  const Vec2 nu = turned(s.own.velocity.head<2>(), -s.own.yaw);
  const Vec2 nu_d = turned(wish.velocity, -s.own.yaw);
  const Vec2 nu_d_rate = turned(wish.rate, -s.own.yaw) + s.own.yaw_rate * Vec2{nu_d.y(), -nu_d.x()};
  const double elapsed = s.time - loop.last_time.value_or(s.time);
  const Vec2 nu_rate = elapsed > 0.0 ? Vec2{(nu - loop.last_nu) / elapsed} : Vec2{Vec2::Zero()};
  loop.last_time = s.time;
  loop.last_nu = nu;

  const Vec3 error{nu_d.x() - nu.x(), nu_d.y() - nu.y(), wrap_angle(p.heading_rad - s.own.yaw)};
  const Vec3 error_rate{nu_d_rate.x() - nu_rate.x(), nu_d_rate.y() - nu_rate.y(), -s.own.yaw_rate};
  loop.integral += elapsed * error;

  Wrench tau = Wrench::Zero();
  const std::array<Gains, 3> gains = gains_of(p, loop.following);
  constexpr std::array<int, 3> axes{0, 1, 5};
  for (int i = 0; i < 3; ++i) {
    const Gains& k = gains[static_cast<std::size_t>(i)];
    tau[axes[static_cast<std::size_t>(i)]] = k.p * error[i] + k.i * loop.integral[i] + k.d * error_rate[i];
  }
  return tau;
}

/// At cruise speed in the direction of `v`; as deep as the mission wants.
Vec3 leading_to(const Situation& s, const Vec2& v) {
  const Vec3 preferred = s.preferred_velocity();
  const double speed = std::min(s.goal.cruise_speed, s.limits.max_speed);
  const Vec3 way = speed * unit(Vec3{v.x(), v.y(), 0.0});
  return {way.x(), way.y(), preferred.z()};
}

}  // namespace

double turn_along(const Vec2& away, const Vec2& to_goal) noexcept {
  return clockwise(away).dot(to_goal) >= 0.0 ? 1.0 : -1.0;
}

Command decide_printed(const WallFollowing::Params& params, const Situation& s, WallFollowing::Loop& loop,
                       Context& context) noexcept {
  const PointSensors sensors{params.sensor_count, params.sensor_arm_m, params.sensor_range_m};
  const auto detected = nearest_detected(s, sensors);
  const Wish goal = to_goal(params, s);
  const bool following = detected && !is_clear((s.own.position - detected->centre).head<2>(), goal.velocity);
  if (following != loop.following) {
    loop.following = following;
    loop.integral.setZero();
  }

  if (context.sketch) draw(sensors, s.own, detected, following ? "followed" : "detected", *context.sketch);
  if (!following) return {.velocity = s.preferred_velocity(), .wrench = tracked(params, s, goal, loop)};
  const Wish wish = along(params, s, *detected, goal.velocity);
  const Vec3 velocity = leading_to(s, wish.velocity);
  if (context.sketch) context.sketch->velocity(velocity, "along the wall");
  return {.velocity = velocity, .mode = Mode::avoid, .wrench = tracked(params, s, wish, loop)};
}

}  // namespace fairway::wall
