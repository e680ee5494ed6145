// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/rrt_star/rrt_star.hpp"

#include <exception>
#include <utility>

namespace fairway {
namespace {

/// True if a plan that failed might do better now.
bool is_other(const PlanTask& before, const PlanTask& now, double near) {
  return before.goal != now.goal || before.map != now.map || (before.start - now.start).norm() > near ||
         before.limits.max_speed_mps != now.limits.max_speed_mps ||
         before.limits.max_acceleration_mps2 != now.limits.max_acceleration_mps2;
}

/// Whether what is charted now lies on what is left of the path; looked at now and then, since it allocates.
bool is_blocked(const Situation& s, RrtStar::Memory& memory) {
  if (s.time < memory.looked_s + between_plans_s) return false;
  memory.looked_s = s.time;
  const Plan& plan = *memory.plan;
  return memory.pursuit.is_blocked(plan, charted_map(s, plan.task.map.inflation()));
}

bool needs_plan(const PlanParams& params, const Situation& s, RrtStar::Memory& memory) {
  if (!memory.plan) return true;
  const Plan& plan = *memory.plan;
  const bool turns = plan.task.strays.has_value();
  if (turns && s.time < memory.planned_s + between_plans_s) return false;
  if (plan.status != PlanStatus::ready) return is_other(plan.task, plan_task(params, s), s.own.radius);
  if (!params.waypoints.empty()) return false;
  if (plan.task.goal != seen_from_above(s.goal.position)) return true;
  return turns && (memory.pursuit.is_stuck(s, plan) || is_blocked(s, memory));
}

/// The plan for the situation; one that could not even be tried is a failed one.
Plan plan_for(const PlanParams& params, const Situation& s, std::uint32_t seed) {
  PlanTask task = plan_task(params, s);
  try {
    return make_plan(params, task, seed);
  } catch (const std::exception&) {
    return {.task = std::move(task), .status = PlanStatus::failed};
  }
}

/// Whether there is a plan to the same goal already, where `other` has none.
bool has_better(const RrtStar::Memory& memory, const Plan& other) {
  return memory.plan && memory.plan->status == PlanStatus::ready && other.status != PlanStatus::ready &&
         memory.plan->task.goal == other.task.goal;
}

void adopt(Plan plan, const Situation& s, RrtStar::Memory& memory) {
  memory = {.plan = std::make_shared<const Plan>(std::move(plan)),
            .begin_s = s.time,
            .depth = s.own.position.z(),
            .pursuit = Pursuit::begun(s),
            .planned_s = s.time,
            .looked_s = s.time};
}

}  // namespace

Command RrtStar::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  try {
    if (needs_plan(params, s, memory)) {
      const auto seed = static_cast<std::uint32_t>(context.rng.next() >> 32U);
      memory.planned_s = s.time;
      Plan plan = plan_for(params, s, seed);
      if (!has_better(memory, plan)) adopt(std::move(plan), s, memory);
    }
    const Plan& plan = *memory.plan;
    if (context.sketch != nullptr) draw(plan, memory.depth, true, *context.sketch);
    if (plan.status != PlanStatus::ready) return {.mode = Mode::infeasible, .note = note_of(plan.status)};

    Command command = plan.task.strays ? Command{.velocity = memory.pursuit.follow(s, plan)}
                                       : TrajectoryTracker{params}.follow(
                                             plan.trajectory, s.time - memory.begin_s, s, memory.tracking);
    const bool is_clear = plan.task.map.is_free(seen_from_above(s.own.position), plan.task.goal);
    command.mode = is_clear ? Mode::cruise : Mode::avoid;
    return command;
  } catch (const std::exception&) {
    return {.mode = Mode::infeasible, .note = note_of(PlanStatus::failed)};
  }
}

}  // namespace fairway
