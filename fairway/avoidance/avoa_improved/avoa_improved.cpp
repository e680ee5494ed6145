// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/avoa_improved.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "fairway/avoidance/ability.hpp"
#include "fairway/avoidance/avoa/velocity_metric.hpp"
#include "fairway/avoidance/avoa_improved/outlook.hpp"
#include "fairway/avoidance/avoa_improved/wish.hpp"
#include "fairway/core/math.hpp"

namespace fairway::avoa_improved {
namespace {

using Params = AvoaImproved::Params;

/// A command to be judged.
struct Candidate {
  double cost;  ///< without that of danger
  Manoeuvre manoeuvre;
  std::size_t index;  ///< of equal costs the smaller is taken; 0 is the wish itself
};

/// What `effort` of the limits allows.
VesselResponse helm_of(const Params& p, const Limits& limits, double effort) {
  const double turn_rate = limit_or(limits.max_turn_rate, p.max_turn_rate_radps);
  const double acceleration = limit_or(limits.max_acceleration, p.max_acceleration_mps2);
  return {.turn_gain = p.turn_gain_hz,
          .max_turn_rate = effort * turn_rate,
          .max_turn_acceleration = effort * p.max_turn_acceleration_radps2,
          .max_acceleration = effort * acceleration,
          .response = p.response_s};
}

/// Own ship now, its drift as learnt so far.
OwnMotion motion_of(const Params& params, const Situation& s, Drift& drift) {
  const Vec2 ahead = unit_at(s.own.yaw);
  const Vec2 velocity = s.own.velocity.head<2>();
  OwnMotion motion{.position = s.own.position.head<2>(), .yaw = s.own.yaw, .yaw_rate = s.own.yaw_rate};
  if (params.turn_aware) {
    drift.observe(velocity, ahead, helm_of(params, s.limits, 1.0), s.period, params.drift_settling_s);
    motion.drift = drift.velocity();
  }
  motion.speed = (velocity - motion.drift).dot(ahead);
  return motion;
}

/// Whether own ship is known to be one that goes sideways as well as ahead: then it need not turn.
bool goes_any_way(const Situation& s) {
  return s.envelope != nullptr && s.limits.sway && s.envelope->sideways > 0.5 * s.envelope->ahead;
}

double greatest_speed(const Situation& s) {
  return limit_or(s.limits.max_speed,
                  math::fmax(s.goal.cruise_speed, horizontal_norm(s.preferred_velocity())));
}

/// The commands that there are to choose from, the one nearest to the wish first.
class Choices {
 public:
  Choices(const Params& params, const Wish& wish, const Situation& s, double fastest)
      : metric_{{.speed = wish.speed, .heading = 0.0},
                fastest,
                params.speed_weight_ratio,
                params.heading_weight_ratio,
                params.danger_weight_ratio} {
    list_speeds(params, wish, s.limits, fastest);
    // the desired heading, then away from it to both sides in turn, and last the present one
    for (int i = 0; i < params.heading_count; ++i) {
      const int steps_away = (i + 1) / 2;
      const double away = 2.0 * pi / params.heading_count * steps_away;
      add(wish.heading, i % 2 == 1 ? away : -away, static_cast<std::size_t>(i), s);
    }
    add(wish.heading, wrap_angle(s.own.yaw - wish.heading), static_cast<std::size_t>(params.heading_count),
        s);
    const auto rank = [](const Candidate& a, const Candidate& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.index < b.index;
    };
    std::sort(all_.begin(), all_.begin() + static_cast<std::ptrdiff_t>(count_), rank);
  }

  std::span<const Candidate> view() const { return {all_.data(), count_}; }

  double cost_of_danger(double danger) const { return metric_(metric_.desired(), danger); }

  /// The danger that costs this much.
  double bearable(double cost) const { return cost / cost_of_danger(1.0); }

 private:
  static constexpr std::size_t most_speeds = 24;

  /// A speed, and that after the turn.
  struct Speeds {
    double now;
    double after;
  };

  void list_speeds(const Params& params, const Wish& wish, const Limits& limits, double fastest) {
    const auto list = [&](double now, double after) {
      const bool is_new = now != wish.speed || after != wish.speed;
      if (is_new && std::abs(now) >= limits.min_speed) speeds_[speed_count_++] = {now, after};
    };
    speeds_[speed_count_++] = {wish.speed, wish.speed};
    for (int i = params.speed_count; i > 0; --i) {
      const double speed = fastest * i / params.speed_count;
      if (speed >= params.least_speed_mps) list(speed, speed);
    }
    if (!params.turn_aware) return;
    list(0.0, 0.0);
    list(0.0, wish.speed_after);
    if (params.astern_mps <= 0.0 || !limits.sternway) return;
    const double astern = -math::fmin(params.astern_mps, fastest);
    list(astern, astern);
    list(astern, wish.speed_after);
  }

  void add(double desired, double offset, std::size_t heading_index, const Situation& s) {
    const double off_the_bow = std::abs(wrap_angle(desired + offset - s.own.yaw));
    if (only_goes_ahead(s.limits) && off_the_bow >= 0.5 * pi) return;
    for (std::size_t k = 0; k < speed_count_; ++k) {
      const double cost = metric_({.speed = speeds_[k].now, .heading = offset}, 0.0);
      all_[count_++] = {cost,
                        {speeds_[k].now, desired + offset, heading_index, speeds_[k].after},
                        heading_index * most_speeds + k};
    }
  }

  avoa::VelocityMetric metric_;
  std::array<Speeds, most_speeds> speeds_;
  std::size_t speed_count_ = 0;
  std::array<Candidate, most_speeds * Outlook::most_headings> all_;
  std::size_t count_ = 0;
};

struct BestCommand {
  Candidate candidate;
  Prospect prospect;
};

/// The cheapest command that is clear; if none is, that which loses least of the margin.
BestCommand choose(const Choices& choices, Outlook& outlook) {
  std::optional<BestCommand> best;
  double least_cost = Limits::none;
  for (const Candidate& c : choices.view()) {
    if (c.cost >= least_cost) break;
    const Prospect prospect = outlook.of(c.manoeuvre, choices.bearable(least_cost - c.cost));
    const double cost = c.cost + choices.cost_of_danger(prospect.danger);
    if (!prospect.is_clear || cost >= least_cost) continue;
    best = {c, prospect};
    least_cost = cost;
  }
  if (best) return *best;

  for (const Candidate& c : choices.view()) {
    const double too_severe = best ? best->prospect.severity : Limits::none;
    const Prospect prospect = outlook.to_the_end_of(c.manoeuvre, too_severe);
    if (!best || prospect.severity < best->prospect.severity) best = {c, prospect};
  }
  return *best;
}

Command command_for(const Params& params, const Situation& s, const Wish& wish, const BestCommand& choice) {
  const Manoeuvre& m = choice.candidate.manoeuvre;
  const bool is_free = choice.prospect.is_clear && choice.prospect.danger == 0.0;
  Command command{.mode = choice.prospect.is_clear ? Mode::avoid : Mode::infeasible};
  if (choice.candidate.index == 0 && wish.is_preferred) {
    command.velocity = s.preferred_velocity();
    if (is_free) command.mode = Mode::cruise;
    return command;
  }
  const Vec2 velocity = m.speed * unit_at(m.speed > 0.0 ? m.heading : s.own.yaw);
  command.velocity = {velocity.x(), velocity.y(), 0.0};
  if (m.speed <= 0.0)
    command.turn_rate = helm_of(params, s.limits, 1.0).turn_rate(wrap_angle(m.heading - s.own.yaw));
  return command;
}

void draw(Sketch& sketch, const Situation& s, Outlook& outlook, const BestCommand& choice,
          const Command& command) {
  std::array<Vec3, Outlook::most_steps> points;
  std::size_t count = 0;
  for (const Vec2& p : outlook.path(choice.candidate.manoeuvre))
    points[count++] = {p.x(), p.y(), s.own.position.z()};
  sketch.path({points.data(), count}, "foreseen");
  sketch.velocity(s.preferred_velocity(), "desired");
  sketch.velocity(command.velocity, "chosen");
}

Command decision(const Params& params, const Situation& s, AvoaImproved::Memory& memory, Sketch* sketch) {
  // what is known, and the way round it
  memory.chart.enter(s, params.memory, params.same_place_m);
  const Capsules moving = movers(s);
  const OwnMotion own = motion_of(params, s, memory.drift);
  const Wish wish = wish_of(params, s, moving.view(), memory, sketch);

  // what every command would come to
  const Foresight foresight{.turn_aware = params.turn_aware,
                            .window = params.window_s,
                            .hold = params.turn_aware ? params.hold_s : params.window_s,
                            .near = params.turn_aware ? params.near_s : params.window_s,
                            .margin = wish.margin,
                            .danger = params.danger_m};
  const double fastest = greatest_speed(s);
  Outlook outlook{helm_of(params, s.limits, params.effort_ratio),
                  foresight,
                  own,
                  s.own.radius,
                  fastest,
                  memory.chart.view(),
                  moving.view()};
  if (fastest <= 0.0 || (outlook.is_open() && !memory.committed))
    return {.velocity = s.preferred_velocity(), .mode = Mode::cruise};

  // the best of them
  const Choices choices{params, wish, s, fastest};
  const BestCommand choice = choose(choices, outlook);
  Command command = command_for(params, s, wish, choice);
  if (sketch != nullptr) draw(*sketch, s, outlook, choice, command);
  return command;
}

}  // namespace
}  // namespace fairway::avoa_improved

namespace fairway {

Command AvoaImproved::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  if (s.comes_after_pause(memory.time)) memory.drift = {};
  memory.time = s.time;
  Params now = params;
  now.turn_aware = params.turn_aware && !avoa_improved::goes_any_way(s);
  Situation wary = s;
  wary.own.radius += s.own.position_error();
  Command command = avoa_improved::decision(now, wary, memory, context.sketch);
  const double sign = command.turn_rate ? -1.0 : 1.0;
  memory.drift.command(sign * horizontal_norm(command.velocity));
  return command;
}

}  // namespace fairway
