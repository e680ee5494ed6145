// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/teb.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "fairway/avoidance/label.hpp"
#include "fairway/avoidance/trackable/keeper.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/planning/planar_map.hpp"
#include "fairway/planning/teb/homotopy.hpp"
#include "fairway/planning/teb/optimise.hpp"
#include "fairway/planning/teb/way.hpp"

namespace fairway {
namespace {

using teb::Band;
using teb::BandObstacle;
using teb::Pose;
using teb::Signature;

/// The band that goes the way to the goal.
struct Planned {
  Band band;
  Signature turns;
};

/// What one decision is about.
struct Task {
  const TebParams& params;
  std::vector<BandObstacle> barriers;
  Pose start;
  Pose end;               ///< where the way ahead leaves the lookahead, or the goal
  std::vector<Vec2> way;  ///< from the start to the end
  double speed{};         ///< along the heading [m/s]
  double yaw_rate{};      ///< [rad/s]
  const Envelope* can{};  ///< by which a wrapper foresees what the vehicle makes of the answer; or null
};

/// Where the mission wants to be; far ahead where it wants a velocity.
Vec2 goal_of(const Situation& s) {
  constexpr double far = 1000.0;
  if (!s.goal.velocity) return seen_from_above(s.goal.position);
  return seen_from_above(s.own.position + far * unit(*s.goal.velocity));
}

/// Whether a way was planned less than a second ago.
bool is_too_soon(const TebParams& params, const Situation& s, const Teb::Memory& memory) {
  constexpr double every = 1.0;  // [s]
  return params.global_plan == TebGlobalPlan::rrt_star && s.time < memory.planned_s + every;
}

/// Another goal wants another way; and a planned one is planned again where it is blocked or of no use.
bool needs_way(const TebParams& params, const Situation& s, const Vec2& goal, const Teb::Memory& memory) {
  if (memory.way.empty() || memory.way.back() != goal) return true;
  if (params.global_plan != TebGlobalPlan::rrt_star || is_too_soon(params, s, memory)) return false;
  return memory.plan_failed || teb::is_blocked(params, memory.way, s);
}

/// Draws the line to the goal, or plans the way there. Where none is found the line stands for it, or the way
/// that there is; where it is too soon to plan, the way that there is leads on to the goal.
void find_way(const TebParams& params, const Situation& s, const Vec2& goal, Teb::Memory& memory, Rng& rng) {
  if (!memory.way.empty() && is_too_soon(params, s, memory)) {
    memory.way.back() = goal;
    memory.plan_failed = true;
    return;
  }
  std::optional<std::vector<Vec2>> planned;
  if (params.global_plan == TebGlobalPlan::rrt_star) {
    planned = teb::plan_way(params, s, goal, rng);
    memory.planned_s = s.time;
  }
  const bool keeps = !memory.way.empty() && memory.way.back() == goal;
  if (!planned && !keeps) planned = {seen_from_above(s.own.position), goal};
  if (planned) memory.way = std::move(*planned);
  memory.plan_failed = false;
}

/// In which a vehicle whose envelope is known takes up what is commanded, and the band is looked at [s].
double taking_up(const Envelope& can) { return 1.0 + can.turn_lag; }

/// Limits are the vehicle's at the speed of the mission, the band reaches as far as it takes to turn aside
/// and stop, and the way to a place is planned unless the parameters say otherwise.
TebParams within(const Envelope& can, const Situation& s, TebParams params) {
  constexpr double least = 0.01;
  constexpr int most_poses = 20;  // what a band costs grows with them, and the manoeuvre needs no more
  const Limits& limits = s.limits;
  const double speed = std::max(least, std::min({can.ahead, limits.max_speed, s.goal.cruise_speed}));
  params.max_vel_x_mps = speed;
  params.max_vel_x_backwards_mps =
      trackable::must_turn(s) ? 0.0 : std::max(least, std::min(speed, can.astern));
  params.max_vel_theta_radps = std::max(least, std::min(can.turn_rate(speed), limits.max_turn_rate));
  params.acc_lim_x_mps2 = std::max(least, std::min(can.acceleration, can.deceleration));
  params.acc_lim_theta_radps2 = std::max(least, can.turn_acceleration);
  params.penalty_epsilon_ratio = 0.0;  // 0.1 rad/s would be a quarter of what a boat may turn
  const double manoeuvre =
      taking_up(can) + 0.5 * pi / params.max_vel_theta_radps + speed / params.acc_lim_x_mps2;
  params.max_global_plan_lookahead_dist_m =
      std::max(params.max_global_plan_lookahead_dist_m, speed * manoeuvre);
  const double coarser = std::max(1.0, manoeuvre / (most_poses * params.dt_ref_s));
  params.dt_ref_s *= coarser;
  params.dt_hysteresis_s *= coarser;
  params.max_samples_count = std::min(params.max_samples_count, 2 * most_poses);
  if (params.global_plan == TebGlobalPlan::automatic && !s.goal.velocity)
    params.global_plan = TebGlobalPlan::rrt_star;
  return params;
}

/// As far as the envelope is known, within it. The speeds that the band may have are those that the vehicle
/// can have: without sternway none astern, and where there is a least speed, none below it.
TebParams able(TebParams params, const Situation& s) {
  if (s.envelope != nullptr) params = within(*s.envelope, s, params);
  const Limits& limits = s.limits;
  if (!limits.sternway) params.max_vel_x_backwards_mps = -std::min(limits.min_speed, params.max_vel_x_mps);
  return params;
}

Task task_of(const TebParams& params, const Situation& s, std::span<const Vec2> way) {
  const Vec2 own = seen_from_above(s.own.position);
  teb::WayAhead ahead = teb::ahead_on(way, own, params.max_global_plan_lookahead_dist_m);
  return {.params = params,
          .barriers = teb::band_obstacles_near(params, s),
          .start = {own, wrap_angle(s.own.yaw)},
          .end = ahead.end,
          .way = std::move(ahead.points),
          .speed = unit_at(s.own.yaw).dot(s.own.velocity.head<2>()),
          .yaw_rate = s.own.yaw_rate,
          .can = s.envelope};
}

/// The bands of the decision before, warm; none if they lead elsewhere.
void advance_all(const Task& task, std::vector<Band>& bands) {
  if (bands.empty()) return;
  if (!still_leads_to(task.params, bands.front(), task.end)) {
    bands.clear();
    return;
  }
  for (Band& band : bands) advance(task.params, band, task.start, task.end);
}

/// Keeps one band of each class, the first that is met.
std::vector<Signature> drop_duplicates(const Task& task, std::vector<Band>& bands) {
  std::vector<Signature> classes;
  std::erase_if(bands, [&](const Band& band) {
    Signature turns = signature_of(task.barriers, band);
    const bool known = teb::is_among(task.params, turns, classes);
    if (!known) classes.push_back(std::move(turns));
    return known;
  });
  return classes;
}

Planned along_the_way(const Task& task) {
  Band band = band_along(task.params, task.way, task.start, task.end);
  Signature turns = signature_of(task.barriers, band);
  return {std::move(band), std::move(turns)};
}

/// Bands of classes that there are none of yet: of the planned way's, then of others. A wrapper that foresees
/// does not follow a band where that winds, and would push the loop on ahead of the vehicle: as long as the
/// band takes longer than the way at the greatest speed, the way begins another one.
void explore(const Task& task, const Planned& planned, std::vector<Band>& bands, Rng& rng) {
  std::vector<Signature> classes = drop_duplicates(task, bands);
  const auto most = static_cast<std::size_t>(task.params.max_number_classes_count);
  if (bands.size() > most) bands.resize(most);

  const bool known = teb::is_among(task.params, planned.turns, classes);
  const bool winds =
      task.can != nullptr && !bands.empty() && bands.front().duration() > planned.band.duration();
  if ((!known || winds) && bands.size() < most) {
    if (!known) classes.push_back(planned.turns);
    bands.push_back(planned.band);
  }
  const auto ways = ways_of_new_classes(task.params, task.barriers, task.start.position, task.end.position,
                                        most - bands.size(), classes, rng);
  for (const std::vector<Vec2>& way : ways)
    bands.push_back(band_along(task.params, way, task.start, task.end));
}

/// Optimises every band and puts the best first.
void choose(const Task& task, const Planned& planned, bool followed_one, std::vector<Band>& bands) {
  const TebParams& params = task.params;
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  bool plan_found = false;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const bool of_plan =
        !plan_found && teb::are_alike(params, planned.turns, signature_of(task.barriers, bands[i]));
    plan_found = plan_found || of_plan;
    const teb::Cost cost = optimise(params, task.barriers, task.speed, task.yaw_rate, bands[i]);
    double sum = cost.motion + params.selection_obst_cost_scale_ratio * cost.barriers;
    if (i == 0 && followed_one) sum *= params.selection_cost_hysteresis_ratio;
    if (of_plan) sum *= params.selection_prefer_initial_plan_ratio;
    if (sum < least) {
      least = sum;
      best = i;
    }
  }
  std::swap(bands.front(), bands[best]);
}

void plan(const Task& task, std::vector<Band>& bands, Rng& rng) {
  advance_all(task, bands);
  const bool followed_one = !bands.empty();
  const Planned planned = along_the_way(task);
  if (task.params.enable_homotopy_class_planning) {
    explore(task, planned, bands, rng);
  } else if (bands.empty()) {
    bands.push_back(planned.band);
  }
  choose(task, planned, followed_one, bands);
}

/// Whether the first poses touch nothing as it is now.
bool is_feasible(const Task& task, const Band& band) {
  if (!is_sound(band)) return false;
  const auto looked_at =
      std::min(band.size(), static_cast<std::size_t>(task.params.feasibility_check_no_poses_count));
  for (std::size_t i = 0; i < looked_at; ++i) {
    for (const BandObstacle& barrier : task.barriers) {
      if (barrier.from(band.position(i)).distance < 0.0) return false;
    }
  }
  return true;
}

/// From the first pose to the second, held to the limits.
Command first_command(const Task& task, const Band& band) {
  const TebParams& params = task.params;
  const double heading = task.start.heading;
  const Vec2 way = band.position(1) - band.position(0);
  const Vec2 ahead = unit_at(heading);
  const double speed = std::clamp(std::copysign(way.norm(), way.dot(ahead)) / band.time(0),
                                  -params.max_vel_x_backwards_mps, params.max_vel_x_mps);
  const double turn = wrap_angle(band.pose(1).heading - heading) / band.time(0);
  Command command{.velocity = {speed * ahead.x(), speed * ahead.y(), 0.0},
                  .mode = task.barriers.empty() ? Mode::cruise : Mode::avoid};
  command.turn_rate = std::clamp(turn, -params.max_vel_theta_radps, params.max_vel_theta_radps);
  return command;
}

/// Towards where the band is when the vehicle has taken the command up, as fast as the band goes there.
/// Straight on along the way where nothing is near: the vehicle turns later than the band, and would go round
/// a goal to which that winds. Likewise where the band turns about, which it would do now to port and now to
/// starboard.
Command command_ahead(const Task& task, const Band& band) {
  double time = 0.0, length = 0.0;
  std::size_t i = 0;
  do {
    time += band.time(i);
    length += (band.position(i + 1) - band.position(i)).norm();
    ++i;
  } while (i + 1 < band.size() && time < taking_up(*task.can));
  const Vec2 along = band.position(i) - band.position(0);
  const bool turns_about =
      task.params.max_vel_x_backwards_mps <= 0.0 && along.dot(unit_at(task.start.heading)) < 0.0;
  const Vec2 way = task.barriers.empty() || turns_about ? Vec2{task.way[1] - band.position(0)} : along;
  const double speed =
      turns_about ? task.params.max_vel_x_mps : std::min(length / time, task.params.max_vel_x_mps);
  const Vec2 velocity = way.norm() > 0.0 ? Vec2{speed * way.normalized()} : Vec2{Vec2::Zero()};
  return {.velocity = {velocity.x(), velocity.y(), 0.0},
          .mode = task.barriers.empty() ? Mode::cruise : Mode::avoid};
}

void draw(const Situation& s, std::span<const Band> bands, Sketch& sketch) {
  for (std::size_t i = 0; i < bands.size(); ++i) {
    std::vector<Vec3> points;
    for (const teb::Knot& knot : bands[i].knots) points.emplace_back(knot[0], knot[1], s.own.position.z());
    if (i == 0) {
      sketch.path(points, "band");
    } else {
      sketch.path(points, Label{"band of another class", static_cast<std::uint32_t>(i)});
    }
  }
  sketch.velocity(s.preferred_velocity(), "preferred");
}

void draw_way(const Situation& s, std::span<const Vec2> way, Sketch& sketch) {
  std::vector<Vec3> points;
  for (const Vec2& point : way) points.emplace_back(point.x(), point.y(), s.own.position.z());
  sketch.path(points, "global plan");
}

}  // namespace

Command Teb::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  try {
    const Vec2 goal = goal_of(s);
    const bool is_there = (goal - seen_from_above(s.own.position)).norm() <= params.xy_goal_tolerance_m;
    const bool waits = !s.goal.velocity && s.goal.cruise_speed <= 0.0;
    const TebParams now = able(params, s);
    if (needs_way(now, s, goal, memory)) find_way(now, s, goal, memory, context.rng);
    if (is_there || waits) {
      memory.bands.clear();
      return {};
    }
    const Task task = task_of(now, s, memory.way);
    plan(task, memory.bands, context.rng);
    if (context.sketch != nullptr) {
      if (now.global_plan == TebGlobalPlan::rrt_star) draw_way(s, memory.way, *context.sketch);
      draw(s, memory.bands, *context.sketch);
    }
    const Band& band = memory.bands.front();
    if (is_feasible(task, band)) {
      Command command = task.can != nullptr ? command_ahead(task, band) : first_command(task, band);
      if (context.sketch != nullptr) context.sketch->velocity(command.velocity, "chosen");
      return command;
    }
  } catch (const std::exception&) {  // out of memory
  }
  memory.bands.clear();
  memory.plan_failed = true;
  ++memory.infeasible_count;
  return {.mode = Mode::infeasible, .note = "the first poses of the band cannot be followed"};
}

}  // namespace fairway
