// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/decision_facts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// A velocity this near a limit is at it, and one this slow has no course [m/s].
constexpr double velocity_tolerance = 1e-9;

double course_of(const Vec3& velocity) { return math::atan2(velocity.y(), velocity.x()); }

Precedence precedence_of(const Ownship& own, const Track& track) {
  if (own.priority == track.priority) return Precedence::equal;
  return own.priority < track.priority ? Precedence::own : Precedence::theirs;
}

NeighbourFacts neighbour_facts(const Situation& s, const Track& track, const Vec3& preferred,
                               const Vec3& commanded) {
  const Vec3 offset = track.position - s.own.position;
  const Vec3 velocity = track.velocity - s.own.velocity;
  return {.track = track,
          .range = offset.norm(),
          .bearing = bearing_from_bow(offset, s.own.yaw),
          .below = offset.z(),
          .closing = -velocity.dot(unit(offset)),
          .radii = s.own.radius + track.radius,
          .at_present = closest_approach(offset, velocity),
          .preferred = closest_approach(offset, track.velocity - preferred),
          .commanded = closest_approach(offset, track.velocity - commanded),
          .precedence = precedence_of(s.own, track)};
}

ObstacleFacts obstacle_facts(const Situation& s, const Obstacle& obstacle) {
  const SurfacePoint surface = nearest_point(obstacle, s.own.position);
  return {.kind = obstacle.kind,
          .nearest = surface.point,
          .distance = surface.distance,
          .bearing = bearing_from_bow(surface.point - s.own.position, s.own.yaw)};
}

Deviation deviation_of(const Vec3& preferred, const Vec3& commanded) {
  Deviation deviation{.size = (commanded - preferred).norm(),
                      .speed = commanded.norm() - preferred.norm(),
                      .climb = preferred.z() - commanded.z(),
                      .turn = {}};
  const bool have_courses =
      std::min(horizontal_norm(preferred), horizontal_norm(commanded)) > velocity_tolerance;
  if (have_courses) deviation.turn = wrap_angle(course_of(commanded) - course_of(preferred));
  return deviation;
}

/// At a turn rate: by a course alone it would turn round.
bool is_astern(const Situation& s, const Command& command) {
  return !s.limits.sway && command.turn_rate &&
         unit_at(s.own.yaw).dot(command.velocity.head<2>()) < -velocity_tolerance;
}

/// The limits at which `Avoider` holds the command; of those that are zero, only where more was wanted.
std::vector<std::string> binding_limits(const Situation& s, const Vec3& preferred, const Vec3& v) {
  const Limits& limits = s.limits;
  const auto binds = [](double value, double wanted, double limit) {
    const bool is_at = std::isfinite(limit) && std::abs(value - limit) <= velocity_tolerance;
    const bool says_something = std::abs(limit) > velocity_tolerance || std::abs(wanted) > velocity_tolerance;
    return is_at && says_something;
  };
  std::vector<std::string> binding;
  if (binds(v.norm(), preferred.norm(), limits.max_speed)) {
    binding.push_back(fmt::format("the speed limit of {:.3f} m/s", limits.max_speed));
  }
  if (binds(std::abs(v.z()), preferred.z(), limits.max_climb_rate)) {
    binding.push_back(fmt::format("the climb rate limit of {:.3f} m/s", limits.max_climb_rate));
  }
  const double depth = s.own.position.z();
  if (binds(v.z(), std::min(0.0, preferred.z()), std::min(0.0, (limits.min_depth - depth) / s.period))) {
    binding.push_back(fmt::format("the ceiling at a depth of {:.2f} m", limits.min_depth));
  }
  if (binds(v.z(), std::max(0.0, preferred.z()), std::max(0.0, (limits.max_depth - depth) / s.period))) {
    binding.push_back(fmt::format("the floor at a depth of {:.2f} m", limits.max_depth));
  }
  return binding;
}

}  // namespace

ClosestApproach closest_approach(const Vec3& position, const Vec3& velocity) noexcept {
  const double speed2 = velocity.squaredNorm();
  const double time = speed2 > 0.0 ? std::max(0.0, -position.dot(velocity) / speed2) : 0.0;
  return {time, Vec3{position + time * velocity}.norm()};
}

double bearing_from_bow(const Vec3& offset, double yaw) noexcept {
  return wrap_angle(math::atan2(offset.y(), offset.x()) - yaw);
}

DecisionFacts facts_of(const Situation& situation, const Command& command) {
  const Vec3 to_goal = situation.goal.position - situation.own.position;
  DecisionFacts facts{.preferred = situation.preferred_velocity(),
                      .deviation = {},
                      .goal_distance = to_goal.norm(),
                      .goal_bearing = bearing_from_bow(to_goal, situation.own.yaw),
                      .neighbours = {},
                      .obstacles = {},
                      .binding = {},
                      .shortfall = shortfall(situation.limits, command, situation.own.yaw)};
  facts.binding = binding_limits(situation, facts.preferred, command.velocity);
  facts.deviation = deviation_of(facts.preferred, command.velocity);
  facts.deviation.astern = is_astern(situation, command);
  for (const Track& track : situation.tracks) {
    facts.neighbours.push_back(neighbour_facts(situation, track, facts.preferred, command.velocity));
  }
  for (const Obstacle& obstacle : situation.obstacles) {
    facts.obstacles.push_back(obstacle_facts(situation, obstacle));
  }
  std::ranges::stable_sort(facts.obstacles, {}, &ObstacleFacts::distance);
  return facts;
}

}  // namespace fairway
