// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/fleet_duty.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "ros/bridge/messages.hpp"

namespace fairway::bridge {
namespace {

constexpr double tending_period_s = 0.1;  // of the state, and of the clock while it stands still
constexpr double repeat_s = 0.25;         // in lockstep, of wall time
constexpr double lag_forgiven_s = 0.25;   // behind by more, the clock begins anew

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

const char* word_of(Alert alert) {
  constexpr std::array words{"clear", "detected", "collided"};
  return words[static_cast<std::size_t>(alert)];
}

}  // namespace

FleetDuty::FleetDuty(FleetNodeSettings settings)
    : settings_{std::move(settings)}, fleet_{settings_}, ports_(fleet_.size()), paused_{settings_.paused} {}

void FleetDuty::command(std::size_t vehicle, const BodyVelocity& velocity, std::int64_t stamp) {
  const double age = std::fabs(static_cast<double>(stamp - now_)) * 1e-9;
  const bool is_of_now =
      settings_.lockstep ? stamp == now_ : stamp == 0 || age <= settings_.command_timeout_s;
  if (!is_of_now || !is_finite(velocity)) {
    ++refused_;
    return;
  }
  if (fleet_.command(vehicle, velocity)) ports_[vehicle].answered = stamp;
}

bool FleetDuty::pause() { return paused_ = true; }

bool FleetDuty::resume() {
  paused_ = false;
  return !fleet_.is_done();
}

bool FleetDuty::step_once() {
  const bool can = paused_ && !fleet_.is_done();
  steps_ += can ? 1 : 0;
  return can;
}

/// What comes in is handled for so long.
void FleetDuty::spin(double seconds) {
  const auto end = Steady::now() + std::chrono::duration<double>(std::max(seconds, 0.0));
  do {
    outlet_->handle(
        std::clamp(seconds_between(Steady::now(), std::chrono::time_point_cast<Steady::duration>(end)), 0.0,
                   tending_period_s));
    tend();
  } while (outlet_->goes_on() && Steady::now() < end);
}

/// The state and the picture, at their own pace whatever the run does.
void FleetDuty::tend() {
  const auto now = Steady::now();
  if (seconds_between(tended_, now) >= tending_period_s) {
    tended_ = now;
    outlet_->show_clock(fleet_.time());
    outlet_->show_state(state_json());
  }
  if (settings_.marker_rate_hz <= 0.0 || seconds_between(drawn_, now) < 1.0 / settings_.marker_rate_hz)
    return;
  drawn_ = now;
  outlet_->show_picture();
}

void FleetDuty::await_listeners() {
  if (settings_.wait_for_subscribers == 0) return;
  const auto is_ready = [this](std::size_t vehicle) {
    return outlet_->listeners(vehicle) >= settings_.wait_for_subscribers &&
           (settings_.autonomous || outlet_->is_steered(vehicle));
  };
  const auto all_ready = [&] {
    for (std::size_t i = 0; i < ports_.size(); ++i)
      if (!is_ready(i)) return false;
    return true;
  };
  while (outlet_->goes_on() && !all_ready()) spin(0.05);
}

bool FleetDuty::show_goals() {
  bool is_new = false;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const std::optional<Triple>& goal = fleet_.vehicle(i).goal_n;
    if (goal && goal != ports_[i].shown_goal) {
      outlet_->show_goal(i, *goal, fleet_.time());
      is_new = true;
    }
    ports_[i].shown_goal = goal;
  }
  return is_new;
}

void FleetDuty::show_instant() {
  now_ = nanoseconds_of(fleet_.time());
  outlet_->show_clock(fleet_.time());
  if (show_goals()) outlet_->deliver_goals();
  outlet_->show_navigation();
  outlet_->show_truth();

  std::string telling = std::to_string(fleet_.collisions());
  for (std::size_t i = 0; i < ports_.size(); ++i)
    telling += fleet_.vehicle(i).phase + (fleet_.vehicle(i).holding ? "!" : "");
  if (std::exchange(shown_, telling) != telling) outlet_->show_state(state_json());
}

bool FleetDuty::has_answered(std::size_t vehicle) const {
  return !fleet_.vehicle(vehicle).wants_command || ports_[vehicle].answered == now_;
}

bool FleetDuty::all_answered() const {
  for (std::size_t i = 0; i < ports_.size(); ++i)
    if (!has_answered(i)) return false;
  return true;
}

std::string FleetDuty::missing() const {
  std::string names;
  for (std::size_t i = 0; i < ports_.size(); ++i)
    if (!has_answered(i)) names += (names.empty() ? "" : ", ") + fleet_.vehicle(i).name;
  return names;
}

void FleetDuty::await_permission() {
  if (!paused_) return;
  while (outlet_->goes_on() && paused_ && steps_ == 0) spin(0.05);
  if (steps_ > 0) --steps_;
  anchor_ = Steady::now();
  anchor_time_ = fleet_.time();
}

/// Who has not heard the instant, because it was only just joining, hears it again.
void FleetDuty::await_commands() {
  const auto begin = Steady::now();
  double repeat = repeat_s;
  while (outlet_->goes_on() && !all_answered()) {
    const double waited = seconds_between(begin, Steady::now());
    if (waited >= settings_.lockstep_timeout_s) {
      if (missed_++ == 0)
        outlet_->warn("no command of " + missing() + " at " + std::to_string(fleet_.time()) +
                      " s; the run goes on");
      return;
    }
    if (waited >= repeat) {
      outlet_->show_navigation();
      repeat += repeat_s;
      ++repeated_;
    }
    outlet_->handle(std::min({settings_.lockstep_timeout_s - waited, repeat - waited, tending_period_s}));
    tend();
  }
}

/// Until the wall clock has come as far as the next instant.
void FleetDuty::await_clock() {
  if (settings_.speed <= 0.0) {
    spin(0.0);
    return;
  }
  const double due = (fleet_.time() + fleet_.step_period() - anchor_time_) / settings_.speed;
  const double rest = due - seconds_between(anchor_, Steady::now());
  spin(rest);
  if (rest < -lag_forgiven_s) {
    behind_s_ -= rest;
    anchor_ = Steady::now();
    anchor_time_ = fleet_.time() + fleet_.step_period();
  }
}

double FleetDuty::behind() const {
  if (paused_ || fleet_.is_done() || settings_.speed <= 0.0) return behind_s_;
  const double due = (fleet_.time() - anchor_time_) / settings_.speed;
  return behind_s_ + std::max(0.0, seconds_between(anchor_, Steady::now()) - due);
}

std::string FleetDuty::state_json() const {
  nlohmann::json vehicles = nlohmann::json::array();
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const FleetVehicle& vehicle = fleet_.vehicle(i);
    vehicles.push_back({{"name", vehicle.name},
                        {"phase", vehicle.phase},
                        {"wants_command", vehicle.wants_command},
                        {"holding", vehicle.holding},
                        {"alert", word_of(vehicle.alert)}});
  }
  return nlohmann::json{{"scenario", fleet_.name()},
                        {"time_s", fleet_.time()},
                        {"wall_s", seconds_between(begin_, Steady::now())},
                        {"behind_s", behind()},
                        {"frame", settings_.frame == Frame::enu ? "enu" : "ned"},
                        {"paused", paused_},
                        {"done", fleet_.is_done()},
                        {"collisions", fleet_.collisions()},
                        {"missed_count", missed_},
                        {"refused_count", refused_},
                        {"repeated_count", repeated_},
                        {"vehicles", vehicles}}
      .dump();
}

int FleetDuty::run(FleetOutlet& outlet) {
  outlet_ = &outlet;
  begin_ = Steady::now();
  now_ = nanoseconds_of(fleet_.time());
  await_listeners();
  begin_ = anchor_ = Steady::now();
  anchor_time_ = fleet_.time();
  while (outlet.goes_on() && !fleet_.is_done()) {
    show_instant();
    await_permission();
    if (settings_.lockstep) await_commands();
    await_clock();
    if (outlet.goes_on()) fleet_.step();
  }
  const double wall_s = seconds_between(begin_, Steady::now());
  fleet_.finish();
  if (!fleet_.is_done()) {
    outlet.warn("interrupted at " + std::to_string(fleet_.time()) + " s");
    return 130;
  }
  show_instant();
  outlet.show_state(state_json());
  std::cout << fleet_.summary(wall_s) << std::flush;
  do spin(0.3);
  while (outlet.goes_on() && !settings_.until_done);
  return fleet_.expectations_kept() ? 0 : 1;
}

}  // namespace fairway::bridge
