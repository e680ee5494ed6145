// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/blend/blend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>

#include "fairway/avoidance/trackable/keeper.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/planning/blend/space_time.hpp"

namespace fairway {
namespace {

using Params = Blend::Params;
using Memory = Blend::Memory;
using Stage = Blend::Stage;

constexpr double sample_s = 1.0;  ///< between points at which a trajectory is looked at

/// The situation to whom everything met so far is charted.
std::vector<Obstacle> chart_of(const Situation& s, const Finds& finds) {
  std::vector<Obstacle> chart = finds.charted();
  std::ranges::copy_if(s.obstacles, std::back_inserter(chart), &Obstacle::charted);
  return chart;
}

std::shared_ptr<const Plan> planned(const Params& params, const Situation& s, const Finds& finds,
                                    Context& context) {
  const std::vector<Obstacle> chart = chart_of(s, finds);
  Situation known = s;
  known.obstacles = chart;
  const auto seed = static_cast<std::uint32_t>(context.rng.next() >> 32U);

  // where the filter would not let it pass it need not plan to, unless it must
  PlanParams roomy = params;
  if (params.filter && !trackable::must_turn(s))
    roomy.clearance_m = math::fmax(params.clearance_m, params.margin_m);
  Plan plan = make_plan(roomy, plan_task(roomy, known), seed);
  if (plan.status != PlanStatus::ready && roomy.clearance_m > params.clearance_m)
    plan = make_plan(params, plan_task(params, known), seed);
  return std::make_shared<const Plan>(std::move(plan));
}

Vec2 place_at(const Memory& memory, double time) { return memory.plan->trajectory.sample(time).position; }

/// Whether a track, kept at its velocity, comes nearer than the radii to who follows the trajectory from
/// `from`.
bool meets_track(const Params& params, const Situation& s, const Memory& memory, double from) {
  const double duration = memory.plan->trajectory.duration();
  for (int i = 0; i * sample_s <= params.lookahead_s; ++i) {
    const double ahead = i * sample_s;
    const Vec2 own = place_at(memory, math::fmin(duration, from + ahead));
    for (const Track& track : s.tracks) {
      const Vec3 there = track.position + ahead * track.velocity;
      const double room = s.own.radius + track.radius + params.margin_m;
      if ((there.head<2>() - own).norm() < room) return true;
    }
  }
  return false;
}

/// Whether what was met lies on the trajectory within `horizon` [s] of `from`.
bool meets_find(const Memory& memory, double from, double horizon) {
  if (!memory.met) return false;
  const double end = math::fmin(memory.plan->trajectory.duration(), from + horizon);
  for (int i = 0; from + i * sample_s <= end; ++i) {
    if (!memory.met->is_free(place_at(memory, from + i * sample_s))) return true;
  }
  return false;
}

bool can_go_straight(const Memory& memory, const Vec2& from, const Vec2& to) {
  return memory.plan->task.map.is_free(from, to) && (!memory.met || memory.met->is_free(from, to));
}

/// The nearest point of the trajectory ahead that can be gone to straight and has a free way on; behind what
/// blocks it, if something does.
std::optional<double> way_back(const Params& params, const Situation& s, const Memory& memory) {
  const Vec2 own = seen_from_above(s.own.position);
  std::optional<double> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; memory.progress_s + i * sample_s <= memory.plan->trajectory.duration(); ++i) {
    const double time = memory.progress_s + i * sample_s;
    const Vec2 point = place_at(memory, time);
    const double distance = (point - own).norm();
    if (distance >= nearest || !can_go_straight(memory, own, point)) continue;
    if (meets_find(memory, time, params.lookahead_s)) continue;
    nearest = distance;
    best = time;
  }
  return best;
}

/// When the trajectory is free again for as long as the lookahead; nothing if it never is.
std::optional<double> free_again(const Params& params, const Memory& memory) {
  for (int i = 0; memory.progress_s + i * sample_s <= memory.plan->trajectory.duration(); ++i) {
    const double time = memory.progress_s + i * sample_s;
    if (!meets_find(memory, time, params.lookahead_s)) return time;
  }
  return {};
}

/// Where going round is meant to lead: beyond the next point of the trajectory behind what blocks it.
Vec2 behind_block(const Params& params, const Memory& memory) {
  const std::optional<double> free = free_again(params, memory);
  if (!free) return memory.plan->task.goal;
  return place_at(memory, math::fmin(memory.plan->trajectory.duration(), *free + params.lookahead_s));
}

/// How long it takes from here by the plan that there is: round the block on half a circle, and on.
double expected_time(const Params& params, const Situation& s, const Memory& memory) {
  const double duration = memory.plan->trajectory.duration();
  const double rejoin = free_again(params, memory).value_or(duration);
  const double round = 0.5 * pi * (place_at(memory, rejoin) - seen_from_above(s.own.position)).norm();
  return round / memory.plan->task.limits.max_speed_mps + duration - rejoin;
}

void adopt(std::shared_ptr<const Plan> plan, const Situation& s, Memory& memory) {
  memory.plan = std::move(plan);
  memory.depth = s.own.position.z();
  memory.stage = Stage::following;
  memory.progress_s = 0.0;
  memory.pursuit = Pursuit::begun(s);
  memory.wall = {};
}

/// Whether there is no plan to the goal. One by waypoints leads to the last of these, wherever the goal is.
bool lacks_plan(const Params& params, const Situation& s, const Memory& memory) {
  return !memory.plan ||
         (params.waypoints.empty() && memory.plan->task.goal != seen_from_above(s.goal.position));
}

/// Of a vehicle that must turn: takes note of what was not charted, and now and then of the chart.
void take_note(const Params& params, const Situation& s, Memory& memory) {
  const bool is_new = memory.finds.add(s.obstacles, s.own.position);
  if (memory.met && !is_new && s.time < memory.noted_s + between_plans_s) return;
  memory.noted_s = s.time;
  memory.met =
      std::make_shared<const PlanarMap>(chart_of(s, memory.finds), s.own.radius + params.clearance_m);
}

/// Of a vehicle that must turn: whether its plan is of no use.
bool is_idle(const Situation& s, const Memory& memory) {
  const Plan& plan = *memory.plan;
  if (plan.status != PlanStatus::ready)
    return (plan.task.start - seen_from_above(s.own.position)).norm() > s.own.radius;
  return memory.pursuit.is_stuck(s, plan) || memory.pursuit.is_blocked(plan, *memory.met);
}

/// Of a vehicle that must turn: plans where there is no plan to the goal or one of no use, now and then.
void renew(const Params& params, const Situation& s, Memory& memory, Context& context) {
  if (memory.plan && s.time < memory.planned_s + between_plans_s) return;
  const bool lacks = lacks_plan(params, s, memory);
  if (!lacks && !(params.replan && is_idle(s, memory))) return;
  memory.planned_s = s.time;
  std::shared_ptr<const Plan> other = planned(params, s, memory.finds, context);
  if (lacks || other->status == PlanStatus::ready) adopt(std::move(other), s, memory);
}

/// Takes note of what was not charted; plans anew if it lies in the way and that is quicker.
void learn(const Params& params, const Situation& s, Memory& memory, Context& context) {
  if (!memory.finds.add(s.obstacles, s.own.position)) return;
  const std::vector<Obstacle> met = memory.finds.charted();
  memory.met = std::make_shared<const PlanarMap>(met, s.own.radius + params.margin_m);
  if (!params.replan || memory.plan->status != PlanStatus::ready) return;

  if (!meets_find(memory, memory.progress_s, memory.plan->trajectory.duration())) return;
  std::shared_ptr<const Plan> other = planned(params, s, memory.finds, context);
  if (other->status != PlanStatus::ready) return;
  const double expected = expected_time(params, s, memory);
  if (other->trajectory.duration() * (1.0 + params.replan_gain_ratio) < expected)
    adopt(std::move(other), s, memory);
}

/// A straight way from where it is, at its depth.
void draw_way(const Situation& s, const Vec2& to, std::string_view meaning, Context& context) {
  if (context.sketch == nullptr) return;
  context.sketch->path(std::array{s.own.position, Vec3{to.x(), to.y(), s.own.position.z()}}, meaning);
}

Command go_round(const Params& params, const Situation& s, const Vec2& target, Memory& memory,
                 Context& context) {
  draw_way(s, target, "going round to here", context);
  WallFollowing wall;
  wall.params.form = WallFollowingForm::corrected;
  wall.params.standoff_m = params.standoff_m;
  Situation towards = s;
  towards.goal.position.head<2>() = target;
  Command command = wall.decide(towards, memory.wall, context);
  command.mode = std::max(command.mode, Mode::avoid);
  return command;
}

/// The velocity along the trajectory and back to it; its clock waits for who is off it.
Command follow(const Params& params, const Situation& s, double elapsed, Memory& memory) {
  const Trajectory& trajectory = memory.plan->trajectory;
  const double error = (place_at(memory, memory.progress_s) - seen_from_above(s.own.position)).norm();
  const double rate = std::clamp(2.0 - error / params.leash_m, 0.0, 1.0);
  memory.progress_s = math::fmin(trajectory.duration(), memory.progress_s + rate * elapsed);

  const TrajectorySample now = trajectory.sample(memory.progress_s);
  const Vec2 back = params.position_bandwidth_radps * (now.position - seen_from_above(s.own.position));
  const Vec2 velocity = rate * now.velocity + back;
  const double speed = math::fmin(s.limits.max_speed, math::fmax(s.goal.cruise_speed, now.velocity.norm()));
  return {.velocity = clamp_norm({velocity.x(), velocity.y(), 0.0}, speed)};
}

/// Whether a mover is near and comes nearer than leaves room to pass, if both go on as they do or own ship
/// stands.
bool mover_comes(const Params& params, const Situation& s) {
  constexpr double near = 4.0;   // between the spheres [m]
  constexpr double room = 1.0;   // beyond the margin, at the closest approach [m]
  constexpr double slow = 0.01;  // closing in by less is none [m/s]
  return std::ranges::any_of(s.tracks, [&](const Track& track) {
    const Vec2 apart = seen_from_above(track.position - s.own.position);
    const double touch = s.own.radius + track.radius;
    if (apart.norm() > touch + near) return false;
    return std::ranges::any_of(std::array{s.own.velocity, Vec3{Vec3::Zero()}}, [&](const Vec3& own) {
      const Vec2 drift = seen_from_above(track.velocity - own);
      const double closing = -apart.dot(drift);
      if (closing <= slow * apart.norm()) return false;
      const Vec2 nearest = apart + closing / drift.squaredNorm() * drift;
      return nearest.norm() < touch + params.margin_m + room;
    });
  });
}

/// The velocity of a way through space and time around the movers, looked for once a second; with less margin
/// where there is none with all of it. Nothing if there is none at all, or if it is to wait and nobody comes.
std::optional<Vec3> dodge(const Params& params, const Situation& s, Memory& memory) {
  constexpr double every = 1.0;  // [s]
  if (s.time < memory.dodge_until_s) return memory.dodge;
  memory.dodge_until_s = s.time + every;
  memory.dodge.reset();

  // on from where it has come to, or it would stand where it was to go when this began
  memory.progress_s = way_back(params, s, memory).value_or(memory.progress_s);
  const Vec2 towards = behind_block(params, memory);
  std::vector<const PlanarMap*> maps{&memory.plan->task.map};
  if (memory.met) maps.push_back(memory.met.get());
  const double speed = math::fmin(s.goal.cruise_speed, s.limits.max_speed);
  const Vec2 own = seen_from_above(s.own.position);
  for (const double share : {1.0, 0.5, 0.1}) {
    const auto leg = way_through({.from = own,
                                  .towards = towards,
                                  .speed = speed,
                                  .radius = s.own.radius,
                                  .margin = share * params.margin_m,
                                  .maps = maps,
                                  .tracks = s.tracks});
    if (!leg) continue;
    const Vec2 velocity = (leg->to - own) / leg->duration;
    if (velocity.isZero() && !mover_comes(params, s)) break;  // nobody to wait for
    memory.dodge = Vec3{velocity.x(), velocity.y(), 0.0};
    break;
  }
  return memory.dodge;
}

/// Back to the trajectory if it is free from some point ahead that can be gone to straight.
void come_back(const Params& params, const Situation& s, Memory& memory) {
  const std::optional<double> back = way_back(params, s, memory);
  if (!back || meets_track(params, s, memory, *back)) return;
  memory.progress_s = *back;
  memory.stage = Stage::following;
  memory.wall = {};
}

/// What a vehicle that must turn does with a plan that is ready.
Command pursue(const Params& params, const Situation& s, Memory& memory, Context& context) {
  const Vec3 along = memory.pursuit.follow(s, *memory.plan);
  const bool blocked = memory.pursuit.is_blocked(*memory.plan, *memory.met);
  memory.stage = blocked ? Stage::going_round : Stage::following;
  if (blocked) return go_round(params, s, seen_from_above(s.goal.position), memory, context);
  memory.wall = {};
  return {.velocity = along};
}

/// What to do before the filter.
Command choose(const Params& params, const Situation& s, double elapsed, Memory& memory, Context& context) {
  if (memory.plan->status != PlanStatus::ready) {
    Command command = go_round(params, s, seen_from_above(s.goal.position), memory, context);
    command.note = note_of(memory.plan->status);
    return command;
  }
  if (memory.plan->task.strays) return pursue(params, s, memory, context);

  const bool mover = meets_track(params, s, memory, memory.progress_s);
  const Vec2 next = place_at(memory, memory.progress_s);
  const Vec2 own = seen_from_above(s.own.position);
  const bool astray = (next - own).norm() > params.leash_m && !can_go_straight(memory, own, next);
  if (mover || astray || meets_find(memory, memory.progress_s, params.lookahead_s))
    memory.stage = Stage::going_round;
  if (mover || mover_comes(params, s)) {
    if (const std::optional<Vec3> velocity = dodge(params, s, memory)) {
      memory.stage = Stage::going_round;
      memory.wall = {};
      if (context.sketch != nullptr) context.sketch->velocity(*velocity, "way between the movers");
      return {.velocity = *velocity, .mode = Mode::avoid};
    }
  }
  if (memory.stage == Stage::going_round) come_back(params, s, memory);
  if (memory.stage == Stage::following) return follow(params, s, elapsed, memory);
  return go_round(params, s, behind_block(params, memory), memory, context);
}

}  // namespace

Command Blend::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  try {
    const bool turns = trackable::must_turn(s);
    if (turns) {
      take_note(params, s, memory);
      renew(params, s, memory, context);
    } else {
      if (lacks_plan(params, s, memory)) adopt(planned(params, s, memory.finds, context), s, memory);
      learn(params, s, memory, context);
    }
    const double elapsed = memory.last_time ? s.time - *memory.last_time : 0.0;
    memory.last_time = s.time;

    Command wanted = choose(params, s, elapsed, memory, context);
    if (context.sketch != nullptr) {
      const bool follows = memory.stage == Stage::following;
      draw(*memory.plan, memory.depth, follows, *context.sketch);
    }
    if (!params.filter || turns) return wanted;
    SafetyFilter filter;
    filter.params.margin_m = params.margin_m;
    return filter.filtered(s, wanted, context.sketch);
  } catch (const std::exception&) {
    return {.mode = Mode::infeasible, .note = "planning was not possible"};
  }
}

}  // namespace fairway
