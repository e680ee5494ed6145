// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/avoa.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/avoidance/ability.hpp"
#include "fairway/avoidance/avoa/circular_regions.hpp"
#include "fairway/avoidance/avoa/picture.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using avoa::Candidate;
using avoa::PolarVelocity;

/// A speed limit below this is none to go by, and one above is as good as this [m/s].
constexpr double least_reach = 1e-6;
constexpr double largest_reach = 1e3;
/// t_H of what stands, where somebody foresees [s]. By a shorter one a vehicle creeps up to what it should
/// turn aside for, and turns back there.
constexpr double foreseen_window = 30.0;

/// Over ground, from speed and heading off the bow [NED].
Vec3 over_ground(const PolarVelocity& v, double yaw) {
  const auto [sine, cosine] = math::sin_cos(yaw + v.heading);
  return {v.speed * cosine, v.speed * sine, 0.0};
}

/// The preferred velocity as speed and heading off the bow; no speed, no heading.
PolarVelocity off_the_bow(const Vec3& v, double yaw) {
  const double speed = horizontal_norm(v);
  return {speed, speed > 0.0 ? wrap_angle(math::atan2(v.y(), v.x()) - yaw) : 0.0};
}

avoa::KinematicZone kinematic_zone(const Avoa::Params& p, const Situation& s, double max_speed) {
  return {.alpha = p.alpha_ratio,
          .beta = p.beta_m,
          .turn_gain = p.turn_gain_hz,
          .max_turn_rate = limit_or(s.limits.max_turn_rate, p.max_turn_rate_radps),
          .thruster_speed = p.thruster_speed_mps,
          .max_speed = max_speed,
          .min_speed = s.limits.min_speed,
          .only_ahead = only_goes_ahead(s.limits)};
}

avoa::Swarm::Settings swarm_settings(const Avoa::Params& p) {
  return {.particles = p.particle_count,
          .iterations = p.iteration_count,
          .accepted_cost = p.accepted_cost_ratio,
          .inertia = p.inertia_ratio,
          .personal = p.personal_ratio,
          .common = p.common_ratio,
          .shake = {p.shake_mps, p.shake_rad},
          .start = {p.start_mps, p.start_rad}};
}

/// The desired velocity and its cost, infinite if it is not feasible. It may be slower than others. Where
/// somebody foresees what the vehicle makes of it, the vehicle slows to turn for it, and no thruster forbids
/// it.
Candidate desired_candidate(const avoa::VelocitySpace& space, const avoa::VelocityMetric& metric,
                            bool is_foreseen) {
  const PolarVelocity& desired = metric.desired();
  const bool may_be_asked = is_foreseen || !space.kinematics().contains(desired);
  const int cell = may_be_asked ? space.grid().cell_at(desired.cartesian()) : avoa::VelocityGrid::outside;
  const bool feasible =
      cell != avoa::VelocityGrid::outside && space.zones().forbidden()[static_cast<std::size_t>(cell)] == 0;
  return {desired, feasible ? metric(desired, space.danger(cell)) : std::numeric_limits<double>::infinity()};
}

}  // namespace

Command Avoa::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  const double max_speed = std::min(limit_or(s.limits.max_speed, params.max_speed_mps), largest_reach);
  if (max_speed < least_reach) return {.mode = Mode::infeasible, .note = "may not move"};
  const bool is_foreseen = s.envelope != nullptr;
  Vec3 preferred = s.preferred_velocity();
  preferred.z() = 0.0;

  // what is forbidden, and how near to it the rest is
  const PolarVelocity wanted = off_the_bow(preferred, s.own.yaw);
  avoa::KinematicZone kinematics = kinematic_zone(params, s, max_speed);
  if (is_foreseen) kinematics.foreseen_heading = wanted.heading;
  avoa::VelocitySpace& space = memory.space;
  space.begin({params.grid_count, max_speed}, kinematics, params.least_speed_mps);
  avoa::add_everyone(
      s,
      {.margin = params.margin_m,
       .spacing = params.circle_spacing_m,
       .window = params.window_s,
       .window_at_rest = is_foreseen ? std::max(params.window_s, foreseen_window) : params.window_s,
       .contact = params.time_to_contact},
      space.zones());
  space.finish(params.danger_threshold_mps);

  // the best of the rest, the desired velocity first
  const avoa::VelocityMetric metric{wanted,
                                    max_speed,
                                    params.speed_weight_ratio,
                                    params.heading_weight_ratio,
                                    params.danger_weight_ratio,
                                    is_foreseen};
  const Candidate desired = desired_candidate(space, metric, is_foreseen);
  const Candidate best =
      params.search == VelocitySearch::swarm
          ? memory.swarm.search(space, metric, desired, swarm_settings(params), context.rng)
          : avoa::cheapest_cell(space, metric, desired);

  const bool nobody_matters = space.zones().empty();
  const bool none_is_left = !std::isfinite(best.cost);
  const Vec3 chosen = none_is_left                                    ? Vec3{Vec3::Zero()}
                      : nobody_matters && std::isfinite(desired.cost) ? preferred
                                                                      : over_ground(best.velocity, s.own.yaw);
  if (context.sketch) {
    avoa::draw(space, metric, s.own.yaw, memory.picture, *context.sketch);
    for (const avoa::Swarm::Particle& particle : memory.swarm.particles()) {
      context.sketch->velocity(over_ground(particle.position, s.own.yaw), "particle");
    }
    context.sketch->velocity(preferred, "desired");
    context.sketch->velocity(chosen, "chosen");
  }
  if (none_is_left) return {.mode = Mode::infeasible, .note = "every velocity is in a zone"};
  return {.velocity = chosen, .mode = nobody_matters ? Mode::cruise : Mode::avoid};
}

}  // namespace fairway
