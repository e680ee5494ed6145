// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/hull.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway::uuv {
namespace {

constexpr double turn_rate = 1.0;  // [rad/s], of the unicycle

/// The kinematic vehicle that does so.
Choice model_of(Hull hull, const Agility& agility) {
  const double not_ahead = hull == Hull::point ? agility.speed_mps : 0.0;
  return {.name = "kinematic",
          .params = {{"max_speed_mps", agility.speed_mps},
                     {"max_reverse_mps", not_ahead},
                     {"max_sway_mps", not_ahead},
                     {"max_heave_mps", 0.0},
                     {"max_turn_rate_radps", turn_rate},
                     {"max_acceleration_mps2", agility.acceleration_mps2},
                     {"max_turn_acceleration_radps2", agility.turn_acceleration_radps2},
                     {"time_constant_s", agility.time_constant_s}},
          .path = "model"};
}

/// What methods are told of it.
Limits limits_of(Hull hull, const Agility& agility) {
  return {.max_speed = agility.speed_mps,
          .max_climb_rate = 0.0,
          .max_acceleration = agility.acceleration_mps2,
          .max_turn_rate = hull == Hull::point ? Limits::none : turn_rate};
}

/// How a hull that starts on heading `yaw` [rad] carries out a velocity.
Choice steering_of(Hull hull, double yaw) {
  if (hull == Hull::point) return {.name = "holonomic", .params = {{"heading_rad", yaw}}, .path = "steering"};
  return {.name = "speed_and_course",
          .params = {{"turn_gain_hz", 2.0}, {"max_turn_rate_radps", turn_rate}},
          .path = "steering"};
}

}  // namespace

std::string_view name_of(Hull hull) { return hull == Hull::point ? "point" : "unicycle"; }

VehicleSpec uuv_of(std::size_t index, const Vec3& start, const Vec3& goal, double speed, Hull hull,
                   const Agility& agility) {
  const Vec3 way = goal - start;
  VehicleSpec uuv{.id = static_cast<std::uint32_t>(index), .name = fmt::format("uuv{}", index + 1)};
  uuv.model = model_of(hull, agility);
  uuv.position = start;
  uuv.yaw = math::atan2(way.y(), way.x());
  uuv.steering = steering_of(hull, uuv.yaw);
  uuv.priority = static_cast<std::int32_t>(index);
  uuv.limits = limits_of(hull, agility);
  uuv.mission = {{.kind = LegKind::transit, .position = goal, .speed_mps = speed, .arrival_m = 1.0}};
  return uuv;
}

}  // namespace fairway::uuv
