// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/decision.hpp"

#include <cmath>

#include "fairway/avoidance/velocity_obstacle/choice.hpp"
#include "fairway/avoidance/velocity_obstacle/neighbourhood.hpp"

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
  return 1.5 * std::fmax(s.own.velocity.norm(), s.goal.cruise_speed);
}

}  // namespace

Command decide(const Situation& s, const Params& params, Responsibility responsibility,
               Sketch* sketch) noexcept {
  Vec3 preferred = s.preferred_velocity();
  preferred.z() = 0.0;
  const Neighbourhood neighbourhood(s, params, responsibility);
  if (neighbourhood.obstacles().empty()) return {.velocity = preferred, .mode = Mode::cruise};

  const ReachableSet reachable(s.own, s.limits, params.planning_interval_s);
  const Choice choice =
      choose(neighbourhood.obstacles(), reachable, wish_of(preferred.head<2>(), reachable, params));
  const Vec3 chosen{choice.velocity.x(), choice.velocity.y(), 0.0};

  if (sketch) {
    neighbourhood.draw(s.own.position, sketch_reach(s), *sketch);
    sketch->velocity(preferred, "preferred");
    sketch->velocity(chosen, "chosen");
  }
  const bool may_go_astern = !(s.limits.max_turn_rate < Limits::none);
  Command command{.velocity = chosen,
                  .mode = choice.is_feasible ? Mode::avoid : Mode::infeasible,
                  .astern = may_go_astern};
  // who stands and may only go ahead turns to where it wants to go, or it would stand for ever
  if (!may_go_astern && choice.velocity.norm() < standing && preferred.norm() >= standing) {
    command.heading = std::atan2(preferred.y(), preferred.x());
  }
  return command;
}

}  // namespace fairway::velocity_obstacle
