// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/keeper.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "fairway/avoidance/nearest_few.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::trackable {

struct Choice {
  Plan plan;
  Prospect prospect;
  bool is_asked;
};

namespace {

constexpr double hardly = 1e-3;                   // [m/s]
constexpr double standing_share = 0.1;            // of the preferred speed: slower stands
constexpr double most_unexplained = 0.1;          // [m/s]
constexpr double turn_step = pi / 12;             // between plans
constexpr double more_room = 0.05;                // is worth another plan to who cannot stop [m]
constexpr double foresight_error_of_extra = 0.5;  // so much of it the extra margin holds: shown by runs [m]
constexpr double astern_share = 0.5;              // of the cruise speed
constexpr double slack_s = 1.0;                   // of the window, beyond the manoeuvres that it is to hold

/// To turn a quarter and to stop; of who cannot stop, to go once round.
double window_of(const TurnLaw& law, const Situation& s, double hold) {
  const Envelope& can = law.envelope();
  const double speed = std::min(can.ahead, std::max(s.goal.cruise_speed, can.least));
  const double rate = std::max(law.greatest_turn_rate(speed), 1e-3);
  if (can.least > 0.0) return hold + can.turn_lag + 2.0 * pi / rate;
  return hold + slack_s + can.turn_lag + 0.5 * pi / rate + can.surge_lag +
         speed / std::max(can.deceleration, 1e-3);
}

/// On the spot [s].
double quarter_turn_time(const TurnLaw& law) {
  return law.envelope().turn_lag + 0.5 * pi / std::max(law.greatest_turn_rate(0.0), 1e-3);
}

/// What sets the vehicle aside, relative to `frame`: the current as it is estimated, and what of that is left
/// across its heading when its own sway is taken away.
Vec2 observed_drift(const Situation& s, const Vec2& ahead, const Vec2& frame, double settling,
                    Course& course) {
  const Envelope& can = *s.envelope;
  const Vec2 starboard = starboard_of(ahead);
  const Vec2 current = s.current.head<2>() - frame;
  const Vec2 velocity = s.own.velocity.head<2>() - frame;
  const double across = starboard.dot(velocity - current);
  const double speed = ahead.dot(velocity);
  if (!course.unexplained) {
    course.sway = can.steady_sway(speed, s.own.yaw_rate);
    course.unexplained = (across - course.sway) * starboard;
  }
  course.sway = can.slip(s.period).after(course.sway, speed, s.own.yaw_rate);
  const double error = across - course.sway - starboard.dot(*course.unexplained);
  *course.unexplained += (1.0 - math::exp(-s.period / settling)) * error * starboard;
  return current + *course.unexplained;
}

/// Of who can stop, whether the water moves, or more is unexplained than its own slip in turns may be.
bool is_set_aside(const Situation& s, const Vec2& unexplained) {
  if (s.envelope->least > 0.0) return false;
  return s.current.head<2>().norm() > least_drift || unexplained.norm() > most_unexplained;
}

/// Whether it wants to go straight to its goal, and not to where a leg or a way round leads.
bool makes_for_goal(const Situation& s, const Vec2& to_goal, const Vec2& wanted) {
  constexpr double same = 0.9;  // cosine
  return !s.goal.velocity && wanted.dot(to_goal) >= same * to_goal.norm();
}

/// Whether who cannot stop would go round and round its goal: that lies in the circle on which it would turn
/// for it, at the least speed, to which it slows there.
bool would_circle(const TurnLaw& law, const Situation& s, const Vec2& ahead, const Vec2& to_goal) {
  const Envelope& can = law.envelope();
  const double radius = can.least / std::max(law.greatest_turn_rate(can.least), 1e-3);
  const double before_it_turns = can.least * (can.turn_lag + can.turn_tail);
  const Vec2 centre =
      before_it_turns * ahead + std::copysign(radius, cross(ahead, to_goal)) * starboard_of(ahead);
  return (to_goal - centre).norm() < radius - s.goal.arrival;
}

/// The greatest speed at which who can stop turns for its goal as fast as that goes by: faster it would go
/// round and round it, its own slip setting it outwards.
double speed_to_turn_in(const TurnLaw& law, const Vec2& ahead, const Vec2& to_goal) {
  constexpr double share = 0.7;  // the rest is for the slip
  const double aside = std::abs(cross(ahead, to_goal));
  if (aside <= 0.0) return Limits::none;
  const double error = math::atan2(aside, ahead.dot(to_goal));
  return share * law.order(0.0, error, 0.0).turn_rate * to_goal.squaredNorm() / aside;
}

/// What the inner avoider wants, as a course and a speed. One that cannot stop goes on where it would circle
/// its goal, until it can turn for it, and one that can slows until it turns in. One that stands without
/// being told to wait has found no velocity: then a way is looked for round the preferred one.
Plan plan_of(const TurnLaw& law, const Situation& s, const Vec2& ahead, const Plan& standing,
             const Command& asked, const Vec2& frame) {
  const Vec2 v = asked.velocity.head<2>() - frame;
  if (asked.mode == Mode::hold) return standing;
  if (asked.turn_rate) return {.direction = ahead, .speed = v.dot(ahead), .turn_rate = asked.turn_rate};
  if (asked.heading) {
    const Vec2 heading = unit_at(*asked.heading);
    return {.direction = heading, .speed = std::max(0.0, v.dot(heading))};
  }
  const Vec2 preferred = s.preferred_velocity().head<2>() - frame;
  const bool stands = (v + frame).norm() < standing_share * (preferred + frame).norm();
  const Vec2& wanted = stands ? preferred : v;
  const double speed = wanted.norm();
  if (speed <= hardly) return standing;
  Plan plan{.direction = wanted / speed, .speed = speed};
  const Vec2 to_goal = (s.goal.position - s.own.position).head<2>();
  if (!makes_for_goal(s, to_goal, plan.direction)) return plan;
  if (law.envelope().least == 0.0) {
    plan.speed = std::min(speed, speed_to_turn_in(law, ahead, to_goal));
  } else if (would_circle(law, s, ahead, to_goal)) {
    plan.direction = ahead;
  }
  return plan;
}

/// What the vehicle's own trials show bounds what is declared of tracking from below.
Margins beside_measured(Margins margins, const Envelope& can) noexcept {
  margins.tracking = std::max(margins.tracking, can.foresight_error - foresight_error_of_extra);
  return margins;
}

}  // namespace

Deviations::Deviations(double slow_cost_ratio) {
  struct Deviation {
    double cost, turn, speed_ratio;
  };
  std::array<Deviation, count> all{};
  std::size_t n = 0;
  all[n++] = {0.0, 0.0, 1.0};
  for (std::size_t i = 0; i < turn_count; ++i) {
    const std::size_t steps_aside = (i + 1) / 2;
    const double turn = (i % 2 == 1 ? 1.0 : -1.0) * turn_step * static_cast<double>(steps_aside);
    for (std::size_t k = 0; k < speed_count; ++k) {
      const double ratio = 1.0 - static_cast<double>(k) / speed_count;
      all[n++] = {1.0 - math::cos(turn) + slow_cost_ratio * (1.0 - ratio), turn, ratio};
    }
  }
  all[n++] = {1.7, 0.0, 0.0};
  std::ranges::stable_sort(std::span{all}.subspan(1), {}, &Deviation::cost);
  for (std::size_t i = 0; i < most_courses; ++i) {
    const Deviation& d = all[std::min(i, count - 1)];
    cosines[i] = math::cos(d.turn);
    sines[i] = math::sin(d.turn);
    speed_ratios[i] = d.speed_ratio;
  }
}

bool must_turn(const Situation& s) noexcept {
  return s.envelope != nullptr && !(s.limits.sway && s.envelope->sideways > hardly);
}

std::string_view words_of_ignorance(const Situation& s) noexcept {
  const bool is_unknown = s.envelope == nullptr && !s.limits.sway;
  return is_unknown ? "it has to turn, and what it can do is not known: no envelope is given" : "";
}

Keeper::Keeper(const Keeping& keeping, const Situation& s, Course& course) noexcept
    : s_{s},
      course_{course},
      ahead_{unit_at(s.own.yaw)},
      law_{*s.envelope, s.limits.max_turn_rate},
      margins_{beside_measured(keeping.margins, *s.envelope)},
      hold_{std::max(keeping.hold, s.period)},
      window_{window_of(law_, s, hold_)},
      frame_{s.envelope->least > 0.0 ? Vec2{s.current.head<2>()} : Vec2{Vec2::Zero()}},
      foresight_{law_,
                 s,
                 ahead_,
                 {.hold = hold_,
                  .window = window_,
                  .margin = margins_.total(window_),
                  .drift = observed_drift(s, ahead_, frame_, keeping.drift_settling, course),
                  .is_set_aside = is_set_aside(s, *course.unexplained),
                  .frame = frame_,
                  .climb = std::min(limit_or(s.limits.max_climb_rate, 1e9),
                                    std::abs(s.own.velocity.z()) + unasked_climb * s.envelope->ahead)}} {}

void Keeper::draw(Sketch& sketch, const Plan& plan, const Command& asked) const {
  const Foresight::Path path = foresight_.path(plan);
  std::array<Vec3, most_steps> points;
  for (std::size_t k = 0; k < path.count; ++k)
    points[k] = s_.own.position + Vec3{path.points[k].x(), path.points[k].y(), 0.0};
  sketch.path(std::span{points}.first(path.count), "foreseen");
  sketch.velocity(asked.velocity, "asked by the inner avoider");
  double radius = s_.own.radius;
  sketch.sphere(s_.own.position, radius, "own sphere");
  for (const Margins::Part& part : margins_.parts(window_)) {
    if (part.size > 0.0) sketch.sphere(s_.own.position, radius += part.size, part.meaning);
  }
}

std::optional<Plan> Keeper::refuge(const Plan& asked) const noexcept {
  const Plan standing = foresight_.standing(asked.direction);
  if (foresight_.is_clear(standing, standing.speed)) return standing;
  if (!s_.limits.sternway || !foresight_.all_stand()) return {};
  const double astern = std::min(s_.envelope->astern, astern_share * s_.goal.cruise_speed);
  const Plan back{.direction = ahead_, .speed = -astern, .turn_rate = 0.0};
  if (astern > hardly && foresight_.is_clear(back, astern)) return back;
  return {};
}

Choice Keeper::choose(const Plan& asked, const Deviations& deviations) noexcept {
  Courses courses;
  courses.north = asked.direction.x();
  courses.east = asked.direction.y();
  courses.side = course_.side;
  courses.cosines = deviations.cosines.data();
  courses.sines = deviations.sines.data();
  const double speed = std::max(asked.speed, 0.5 * s_.goal.cruise_speed);
  for (std::size_t i = 0; i < most_courses; ++i) courses.speeds[i] = deviations.speed_ratios[i] * speed;
  courses.speeds[0] = asked.speed;
  courses.quickest = speed;

  const auto [at, prospect] = foresight_.best_of(asked, courses, Deviations::count);
  if (prospect == Prospect::lost) {
    const std::optional<Plan>& last = course_.last;
    if (foresight_.cannot_stop() && last && foresight_.is_clear(*last, last->speed))
      return {*last, Prospect::clear, false};
    if (const std::optional<Plan> plan = refuge(asked)) return {*plan, Prospect::clear, false};
  }
  if (at == Deviations::count) return {asked, prospect, true};
  if (at == 0 && !asked.turn_rate) return {asked, prospect, true};
  const double sine = course_.side * deviations.sines[at];
  if (prospect != Prospect::lost && sine != 0.0) course_.side = std::copysign(1.0, sine);
  return {{deviations.cosines[at] * asked.direction + sine * starboard_of(asked.direction),
           courses.speeds[at],
           {}},
          prospect,
          false};
}

bool Keeper::is_as_good(const Plan& before, const Choice& chosen) const noexcept {
  if (chosen.prospect != Prospect::lost) {
    const bool changes_side =
        cross(ahead_, foresight_.bow(before)) * cross(ahead_, foresight_.bow(chosen.plan)) < 0.0;
    if (!changes_side || foresight_.is_safe(before)) return changes_side;
    // what is backed up and set aside may be lost again as soon as it turns
    if (chosen.prospect == Prospect::clear || !foresight_.is_set_aside()) return false;
  }
  const Foresight::Room of_before = foresight_.room_of(before), of_chosen = foresight_.room_of(chosen.plan);
  if (foresight_.cannot_stop())
    return foresight_.clear_steps(before, before.speed) >=
               foresight_.clear_steps(chosen.plan, chosen.plan.speed) &&
           of_before.least > of_chosen.least - more_room;
  return foresight_.is_nearly(of_before.least, of_chosen.least) &&
         foresight_.is_nearly(of_before.last, of_chosen.last);
}

Choice Keeper::settled(const Choice& chosen) noexcept {
  const bool is_as_asked = chosen.is_asked && chosen.prospect == Prospect::clear;
  const bool is_kept = !is_as_asked && course_.is_instead && is_as_good(*course_.last, chosen);
  course_.is_instead = !is_as_asked;
  const double since = is_kept ? course_.kept_since.value_or(s_.time) : s_.time;
  if (is_kept && (foresight_.cannot_stop() || s_.time - since <= quarter_turn_time(law_))) {
    course_.kept_since = since;
    const bool is_lost = chosen.prospect == Prospect::lost;
    return {*course_.last, is_lost ? Prospect::lost : Prospect::clear, false};
  }
  course_.kept_since.reset();
  return chosen;
}

Command Keeper::keep(const Command& asked, const Deviations& deviations, Sketch* sketch) noexcept {
  Plan plan = plan_of(law_, s_, ahead_, foresight_.standing(ahead_), asked, frame_);
  Command command = asked;
  if (foresight_.is_open()) {
    course_.is_instead = false;
  } else {
    const Choice choice = settled(choose(plan, deviations));
    plan = choice.plan;
    if (choice.prospect == Prospect::lost) {
      command.mode = Mode::infeasible;
      command.note = "no manoeuvre is left that keeps clear of all";
    } else if (choice.prospect != Prospect::clear || !choice.is_asked) {
      command.mode = Mode::avoid;
      command.note = "";
    }
  }
  course_.last = plan;
  if (foresight_.left_out() && command.note.empty()) command.note = words_of_left_out;
  if (sketch != nullptr) draw(*sketch, plan, asked);
  command.velocity.z() = foresight_.held_to_depths(command.velocity.z());
  if (command.mode == Mode::hold) return command;

  const TurnOrder order = foresight_.order(plan);
  command.velocity.head<2>() = (order.surge + frame_.dot(ahead_)) * ahead_;
  command.turn_rate = order.turn_rate;
  command.heading.reset();
  command.wrench.reset();
  return command;
}

}  // namespace fairway::trackable
