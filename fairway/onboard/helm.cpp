// SPDX-License-Identifier: Apache-2.0
#include "fairway/onboard/helm.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double return_gain = 0.3;   // [1/s], as a hold returns to its depth
constexpr double return_speed = 0.3;  // [m/s]
constexpr double farthest = 1e7;      // [m] from the origin: no goal is there
constexpr int most_standing = 10;  // updates by a time that is past or none, before the clock is not believed

/// `depth`, or the nearest within the limits.
double within(const Limits& limits, double depth) {
  return math::fmax(limits.min_depth, math::fmin(limits.max_depth, depth));
}

bool is_place(const Vec3& position) {
  return is_finite(position) && position.cwiseAbs().maxCoeff() <= farthest;
}

}  // namespace

Helm::Helm(Pilot pilot, HelmSetup setup, Avoider avoider)
    : pilot_{std::move(pilot)},
      setup_{std::move(setup)},
      avoider_{std::move(avoider)},
      fresh_{avoider_},
      progress_watch_{setup_.policy.progress_window_s} {
  check_params(*pilot_.ship().steering);
  check_params(setup_.policy);
  for (const TeamMate& mate : setup_.team)
    neighbours_.push_back({.radius = mate.radius, .priority = mate.priority});
  near_.reserve(neighbours_.size());
  tracks_.reserve(neighbours_.size());
  bystanders_.reserve(neighbours_.size());
  heard_.reserve(neighbours_.size());
}

void Helm::see_clock(double now) noexcept {
  if (!std::isfinite(now)) return;
  if (now < now_ - setup_.policy.max_ahead_s) {
    begin_again();
    now_ = now;
  }
  now_ = math::fmax(now_, now);
}

void Helm::begin_again() noexcept {
  ++clock_restarts_;
  set_back_ = setup_.wall_clock && own_watch_.last();
  avoider_ = fresh_;
  pilot_ = Pilot{pilot_.ship(), pilot_.period()};
  forget_what_was_heard();
  health_ = set_back_ ? Health::stale : Health::good;
  if (setup_.wall_clock) return;
  task_ = Task::none;
  arrived_ = false;
}

void Helm::forget_what_was_heard() noexcept {
  own_watch_ = {};
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    Neighbour& neighbour = neighbours_[i];
    neighbour = {.radius = setup_.team[i].radius,
                 .priority = setup_.team[i].priority,
                 .trail = std::move(neighbour.trail)};
    neighbour.trail.forget();
  }
  heard_.clear();
  next_turn_ = 0.0;
  current_ = Vec3::Zero();
  current_time_.reset();
  progress_watch_.forget();
  updated_ = -std::numeric_limits<double>::infinity();
  standing_ = 0;
  ahead_from_.reset();
}

bool Helm::set_out(const Leg& leg) noexcept {
  const double depth = leg.position.z();
  if (!is_place(leg.position) || !is_place(leg.from) || !std::isfinite(leg.speed_mps) ||
      leg.speed_mps <= 0.0 || !std::isfinite(leg.arrival_m) || leg.arrival_m <= 0.0 ||
      std::fabs(within(limits(), depth) - depth) > leg.arrival_m)
    return false;
  task_ = Task::go;
  leg_ = leg;
  arrived_ = false;
  return true;
}

bool Helm::go_to(const Vec3& position, double speed) noexcept {
  return set_out(
      {.kind = LegKind::transit, .position = position, .speed_mps = speed, .arrival_m = setup_.arrival});
}

bool Helm::follow(const Leg& leg) noexcept {
  Leg section = leg;
  section.kind = LegKind::section;
  return (leg.position - leg.from).norm() > 0.0 && set_out(section);
}

void Helm::keep_position() noexcept {
  if (task_ != Task::keep) {
    pilot_.end_hold();
    pilot_.ask_at_once();
  }
  task_ = Task::keep;
}

void Helm::stand_by() noexcept { task_ = Task::none; }

std::optional<Vec3> Helm::goal() const noexcept {
  return task_ == Task::go && !arrived_ ? std::optional{leg_.position} : std::nullopt;
}

const HelmOrder& Helm::update(double now, Sketch* sketch) noexcept {
  const bool goes_on = now >= now_;
  see_clock(now);
  standing_ = goes_on ? 0 : standing_ + 1;
  see_health();
  order_ = {.time = now_};
  if (own_watch_.last()) own_ = own_at(*own_watch_.last());
  see_arrival();

  if (!own_watch_.last() && !set_back_) {
    let_go(HelmState::waiting);
  } else if (task_ == Task::none) {
    let_go(HelmState::idle);
  } else if (health_ == Health::lost) {
    let_go(HelmState::handed_back, is_blind()
                                       ? "own navigation is lost"
                                       : "own navigation was lost and has not been good for long enough");
  } else if (health_ == Health::stale) {
    hold_because(HelmState::holding, why_stale(), how_to_stay(Attendance::kept));
  } else if (arrived_) {
    hold_because(HelmState::arrived, {}, how_to_stay(Attendance::arrived));
  } else if (task_ == Task::keep) {
    hold_because(HelmState::keeping, {}, how_to_stay(Attendance::kept));
  } else if (waits_for_neighbour()) {
    hold_because(HelmState::holding, "a neighbour is lost", how_to_stay(Attendance::kept));
  } else {
    order_.state = HelmState::under_way;
    order_.in_charge = true;
    if (pilot_.is_due(now_, now_ - updated_)) decide(sketch);
  }
  if (order_.state != HelmState::under_way) stop_watching_progress();
  order_.progress = progress_;
  if (order_.in_charge) {
    order_.command = pilot_.command();
    order_.request = is_blind() ? pilot_.blind_request() : pilot_.request(own_, current_);
    double& turn_rate = order_.request.yaw_rate_radps;
    turn_rate = math::fmax(-limits().max_turn_rate, math::fmin(limits().max_turn_rate, turn_rate));
  }
  updated_ = now_;
  return order_;
}

void Helm::let_go(HelmState state, std::string_view reason) noexcept {
  order_.state = state;
  order_.reason = reason;
  order_.in_charge = false;
  pilot_.end_hold();
  pilot_.ask_at_once();
}

void Helm::hold_because(HelmState state, std::string_view reason, const Command& how) noexcept {
  order_.state = state;
  order_.reason = reason;
  order_.in_charge = true;
  Command led = how;
  if (led.turn_rate) lead_back(led);  // else the place that it keeps is within the depths
  pilot_.obey(led, within_depths(), current_);
  if (is_blind()) pilot_.end_hold();
  pilot_.ask_at_once();
}

/// A method that speaks goes on speaking where it has arrived or was stopped, and may say how to hold there.
Command Helm::how_to_stay(Attendance attendance) noexcept {
  if (!avoider_.speaks()) return {.mode = Mode::hold};
  Situation situation =
      pilot_.situation(now_, own_, {.kind = LegKind::transit, .position = own_.position}, {}, setup_.chart);
  situation.attendance = attendance;
  situation.current = current_;
  show_link(situation);
  Command command = avoider_.decide(situation);
  if (command.mode != Mode::hold) return {.mode = Mode::hold};
  return command;
}

void Helm::show_link(Situation& situation) noexcept {
  if (!avoider_.speaks()) return;
  link_ = {heard_, turn_period_, next_turn_ > now_ ? next_turn_ : now_ + turn_period_};
  situation.link = &link_;
}

void Helm::see_health() noexcept {
  const OnboardPolicy& policy = setup_.policy;
  const bool has_begun = own_watch_.last().has_value();
  const double age = own_watch_.age(now_);
  if (has_begun && age > policy.own_lost_s) {
    health_ = Health::lost;
  } else if (set_back_ || (has_begun && (age > policy.own_stale_s || !has_clock()))) {
    health_ = std::max(health_, Health::stale);
  } else if (!has_begun || now_ - own_watch_.good_since() >= policy.recovery_s) {
    health_ = Health::good;
  }
}

void Helm::see_arrival() noexcept {
  if (task_ != Task::go) arrived_ = false;
  if (task_ == Task::go && own_watch_.last() && health_ == Health::good &&
      (leg_.position - own_.position).norm() <= leg_.arrival_m)
    arrived_ = true;
}

Ownship Helm::own_at(const Fix& fix) const noexcept {
  const double age = now_ - fix.time;
  Ownship own = pilot_.own_ship(fix.state, fix.position_sigma, arrived_);
  if (age != 0.0) {
    own.position += age * own.velocity;
    own.yaw = wrap_angle(own.yaw + age * own.yaw_rate);
  }
  return own;
}

bool Helm::is_outrun() const noexcept {
  return ahead_from_ && ahead_by_ - *ahead_from_ > setup_.policy.own_stale_s;
}

/// By a clock that stands, runs back, or says no time, nothing grows old.
bool Helm::has_clock() const noexcept { return standing_ < most_standing && !is_outrun(); }

std::string_view Helm::why_stale() const noexcept {
  if (standing_ >= most_standing) return "the clock runs back or says no time";
  if (is_outrun()) return "own navigation goes on and is ahead of the clock, which stands";
  if (set_back_) return "the clock was set back";
  return is_blind() ? "own navigation is stale"
                    : "own navigation was stale and has not been good for long enough";
}

bool Helm::is_blind() const noexcept { return own_watch_.age(now_) > setup_.policy.own_stale_s; }

bool Helm::waits_for_neighbour() const noexcept {
  return setup_.policy.neighbour_lost == LostPolicy::hold &&
         std::ranges::any_of(neighbours_, [&](const Neighbour& n) { return is_lost(n); });
}

bool Helm::is_lost(const Neighbour& neighbour) const noexcept {
  return neighbour.watch.last() && neighbour.watch.age(now_) > setup_.policy.neighbour_lost_s;
}

double Helm::growth_of(double age) const noexcept {
  const OnboardPolicy& policy = setup_.policy;
  const double late = math::fmax(0.0, age - policy.neighbour_stale_s);
  return math::fmin(policy.max_growth_m, policy.growth_mps * late);
}

Track Helm::track_of(std::size_t index) const noexcept {
  const TeamMate& mate = setup_.team[index];
  const Neighbour& neighbour = neighbours_[index];
  const Fix& fix = *neighbour.watch.last();
  const double age = now_ - fix.time;
  const double since = math::fmax(0.0, age);
  const double drift = setup_.policy.unforeseen_acceleration_mps2 * since;
  Track track{.id = TrackId{number(mate.id)},
              .position = fix.state.p_n,
              .velocity = fix.state.v_n(),
              .yaw = yaw_of(fix.state.q_nb),
              .radius = neighbour.radius + growth_of(age),
              .age = since,
              .priority = neighbour.arrived_at ? last_priority : neighbour.priority,
              .destination = neighbour.arrived_at ? std::nullopt : neighbour.goal,
              .reacts = mate.reacts,
              .position_covariance = 0.25 * since * since * drift * drift * Mat3::Identity(),
              .velocity_covariance = drift * drift * Mat3::Identity()};

  // whoever is lost may lie anywhere by now: it stays where the prediction has come to, and is not counted on
  track.position += math::fmin(age, setup_.policy.neighbour_lost_s) * track.velocity;
  if (is_lost(neighbour)) {
    track.velocity = Vec3::Zero();
    track.reacts = false;
  }
  return track;
}

void Helm::look_round() noexcept {
  near_.clear();
  const double range2 = setup_.range * setup_.range;
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    Neighbour& neighbour = neighbours_[i];
    const bool forgotten = is_lost(neighbour) && setup_.policy.neighbour_lost == LostPolicy::forget;
    neighbour.shown = false;
    if (!neighbour.watch.last() || forgotten) continue;
    const double distance2 = (track_of(i).position - own_.position).squaredNorm();
    neighbour.shown = distance2 <= range2;
    if (neighbour.shown) near_.push_back({distance2, setup_.team[i].id, i});
  }
  std::ranges::sort(near_, [](const Near& a, const Near& b) {
    return a.distance2 != b.distance2 ? a.distance2 < b.distance2 : number(a.id) < number(b.id);
  });
  tracks_.clear();
  for (const Near& near : near_) tracks_.push_back(track_of(near.index));
}

void Helm::decide(Sketch* sketch) noexcept {
  look_round();
  Situation situation = pilot_.situation(now_, own_, leg_, tracks_, setup_.chart);
  situation.current = current_;
  show_link(situation);
  Command command = avoider_.decide(situation, sketch);
  lead_back(command);
  pilot_.obey(command, within_depths(), current_);
  pilot_.note_decision(now_);
  see_progress(situation);
  order_.decided = true;
  ++decisions_;
  if (command.mode == Mode::infeasible) ++infeasible_;
}

void Helm::see_progress(const Situation& situation) noexcept {
  const double window = setup_.policy.progress_window_s;
  Goal goal = situation.goal;
  goal.cruise_speed = math::fmin(goal.cruise_speed, limits().max_speed);
  progress_watch_.see(now_, own_.position, goal, true);
  bystanders_.clear();
  for (std::size_t k = 0; k < near_.size(); ++k) {
    const Track& track = tracks_[k];
    Neighbour& neighbour = neighbours_[near_[k].index];
    neighbour.trail.see(now_, track.position, progress_watch_.step(), window);
    bystanders_.push_back({.id = track.id,
                           .gap = std::sqrt(near_[k].distance2) - own_.radius - track.radius,
                           .rests_since = neighbour.trail.since(),
                           .may_clear_way = track.reacts && !neighbour.arrived_at});
  }
  progress_ = progress_watch_.judge(pilot_.command().mode, bystanders_);
}

void Helm::stop_watching_progress() noexcept {
  progress_watch_.see(now_, own_.position, {.position = leg_.position}, false);
  progress_ = progress_watch_.judge(pilot_.command().mode, {});
}

void Helm::lead_back(Command& command) const noexcept {
  const double error = within(limits(), own_.position.z()) - own_.position.z();
  const double fastest = math::fmin(return_speed, limits().max_climb_rate);
  const double back = std::clamp(return_gain * error, -fastest, fastest);
  double& down = command.velocity.z();
  if (error > 0.0) down = math::fmax(down, back);
  if (error < 0.0) down = math::fmin(down, back);
}

/// Own ship, so that a hold that begins now is at a depth that the limits allow.
Ownship Helm::within_depths() const noexcept {
  Ownship own = own_;
  own.position.z() = within(limits(), own.position.z());
  return own;
}

}  // namespace fairway
