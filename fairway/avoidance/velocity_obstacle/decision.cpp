// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/decision.hpp"

#include <cmath>

#include "fairway/avoidance/velocity_obstacle/choice.hpp"
#include "fairway/avoidance/velocity_obstacle/neighbourhood.hpp"
#include "fairway/core/math.hpp"

namespace fairway::velocity_obstacle {
namespace {

Wish wish_of(const Vec2& preferred, const ReachableSet& reachable, const Params& params) {
  const double speed = preferred.norm();
  return {.velocity = preferred,
          .ahead = speed > 0.0 ? Vec2{preferred / speed} : reachable.bow(),
          .starboard_bias = params.starboard_bias_ratio,
          .collision_weight = params.collision_weight_m};
}

/// Slower than this is standing still [m/s].
constexpr double standing = 1e-6;

/// Half as far again as the fastest velocity that matters, so that the outlines cross the picture.
double sketch_reach(const Situation& s) {
  return 1.5 * math::fmax(s.own.velocity.norm(), s.goal.cruise_speed);
}

/// What bounds its choice. Who is followed by its envelope may ask for any velocity: among those that it has
/// within an interval it would circle beside its goal, or in a current. Where something stands and nobody
/// leads past it, these hold who must turn to one side of that.
Limits limits_of(const Situation& s) {
  Limits limits = s.limits;
  const bool is_held_to_a_side = !s.limits.sway && !s.is_led && !s.obstacles.empty();
  if (s.envelope && !is_held_to_a_side) limits.max_turn_rate = limits.max_acceleration = Limits::none;
  return limits;
}

}  // namespace

Command decide(const Situation& s, const Params& params, Responsibility responsibility,
               const Context& context) noexcept {
  Vec3 preferred = preferred_velocity(s, params.symmetry, context, params.crit_dist_m);
  preferred.z() = 0.0;
  const Neighbourhood neighbourhood(s, params, responsibility);
  if (neighbourhood.obstacles().empty()) return {.velocity = preferred, .mode = Mode::cruise};

  const Limits limits = limits_of(s);
  const auto choice_within = [&](const Limits& within) {
    const ReachableSet reachable(s.own, within, params.planning_interval_s);
    return choose(neighbourhood.obstacles(), reachable, wish_of(preferred.head<2>(), reachable, params));
  };
  const ChosenVelocity choice = choice_within(limits);
  const Vec3 chosen{choice.velocity.x(), choice.velocity.y(), 0.0};

  if (context.sketch) {
    neighbourhood.draw(sketch_reach(s), *context.sketch);
    context.sketch->velocity(preferred, "preferred");
    context.sketch->velocity(chosen, "chosen");
  }
  const bool turns_freely = !(limits.max_turn_rate < Limits::none);
  Command command{.velocity = chosen,
                  .mode = choice.is_feasible ? Mode::avoid : Mode::infeasible,
                  .astern = turns_freely};
  if (neighbourhood.left_out()) command.note = words_of_left_out;
  // who has to stand turns meanwhile to where it would go if it headed there, or it would stand for ever
  if (!turns_freely && choice.velocity.norm() < standing) {
    Limits turning_at_once = limits;
    turning_at_once.max_turn_rate = Limits::none;
    const Vec2 v = choice_within(turning_at_once).velocity;
    if (v.norm() >= standing) command.heading = math::atan2(v.y(), v.x());
  }
  return command;
}

}  // namespace fairway::velocity_obstacle
