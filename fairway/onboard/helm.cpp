// SPDX-License-Identifier: Apache-2.0
#include "fairway/onboard/helm.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

constexpr double return_gain = 0.3;   // [1/s], as a hold returns to its depth
constexpr double return_speed = 0.3;  // [m/s]
constexpr double farthest = 1e7;      // [m] from the origin: no goal is there

/// `depth`, or the nearest within the limits.
double within(const Limits& limits, double depth) {
  return std::fmax(limits.min_depth, std::fmin(limits.max_depth, depth));
}

bool is_place(const Vec3& position) {
  return is_finite(position) && position.cwiseAbs().maxCoeff() <= farthest;
}

/// What is left, without knowing where it is, to a vehicle that cannot stop.
BodyRequest circle_blind(const SteeringParams& steering) {
  return {.surge_mps = steering.min_speed_mps,
          .yaw_rate_radps = steering.min_speed_mps / steering.circle_radius_m};
}

}  // namespace

Helm::Helm(HelmSetup setup, Avoider avoider)
    : setup_{std::move(setup)},
      avoider_{std::move(avoider)},
      fresh_{avoider_},
      progress_watch_{setup_.policy.progress_window_s} {
  check_params(setup_.steering);
  check_params(setup_.policy);
  for (const TeamMate& mate : setup_.team)
    neighbours_.push_back({.radius = mate.radius, .priority = mate.priority});
  near_.reserve(neighbours_.size());
  tracks_.reserve(neighbours_.size());
  bystanders_.reserve(neighbours_.size());
}

void Helm::see_clock(double now) noexcept {
  if (!std::isfinite(now)) return;
  if (now < now_ - setup_.policy.max_ahead_s) {
    begin_again();
    now_ = now;
  }
  now_ = std::fmax(now_, now);
}

void Helm::begin_again() noexcept {
  ++clock_restarts_;
  avoider_ = fresh_;
  own_watch_ = {};
  for (std::size_t i = 0; i < neighbours_.size(); ++i)
    neighbours_[i] = {.radius = setup_.team[i].radius, .priority = setup_.team[i].priority};
  command_ = {};
  progress_watch_ = ProgressWatch{setup_.policy.progress_window_s};
  updated_ = next_decision_ = -std::numeric_limits<double>::infinity();
  task_ = Task::none;
  health_ = Health::good;
  arrived_ = holding_ = false;
}

bool Helm::set_out(Task task, const Leg& leg) noexcept {
  const double depth = leg.position.z();
  if (!is_place(leg.position) || !is_place(leg.from) || !std::isfinite(leg.speed_mps) ||
      leg.speed_mps <= 0.0 || std::fabs(within(setup_.limits, depth) - depth) > leg.arrival_m)
    return false;
  task_ = task;
  leg_ = leg;
  arrived_ = false;
  return true;
}

bool Helm::go_to(const Vec3& position, double speed) noexcept {
  return set_out(
      Task::go,
      {.kind = LegKind::transit, .position = position, .speed_mps = speed, .arrival_m = setup_.arrival});
}

bool Helm::follow(const Leg& leg) noexcept {
  return (leg.position - leg.from).norm() > 0.0 && set_out(Task::section, leg);
}

void Helm::keep_position() noexcept {
  if (task_ != Task::keep) holding_ = false;
  task_ = Task::keep;
}

void Helm::stand_by() noexcept { task_ = Task::none; }

std::optional<Vec3> Helm::goal() const noexcept {
  const bool goes = (task_ == Task::go || task_ == Task::section) && !arrived_;
  return goes ? std::optional{leg_.position} : std::nullopt;
}

const HelmOrder& Helm::update(double now, Sketch* sketch) noexcept {
  see_clock(now);
  see_health();
  order_ = {.time = now_};
  if (own_watch_.last()) own_ = own_at(*own_watch_.last());
  see_arrival();

  if (!own_watch_.last()) {
    let_go(HelmState::waiting);
  } else if (task_ == Task::none) {
    let_go(HelmState::idle);
  } else if (health_ == Health::lost) {
    let_go(HelmState::handed_back, is_blind()
                                       ? "own navigation is lost"
                                       : "own navigation was lost and has not been good for long enough");
  } else if (health_ == Health::stale) {
    hold_because(HelmState::holding, is_blind()
                                         ? "own navigation is stale"
                                         : "own navigation was stale and has not been good for long enough");
  } else if (arrived_) {
    hold_because(HelmState::arrived);
  } else if (task_ == Task::keep) {
    hold_because(HelmState::keeping);
  } else if (waits_for_neighbour()) {
    hold_because(HelmState::holding, "a neighbour is lost");
  } else {
    order_.state = HelmState::under_way;
    order_.in_charge = true;
    if (is_due()) decide(sketch);
  }
  if (order_.state != HelmState::under_way) stop_watching_progress();
  order_.progress = progress_;
  if (order_.in_charge) carry_out();
  updated_ = now_;
  return order_;
}

void Helm::let_go(HelmState state, std::string_view reason) noexcept {
  order_.state = state;
  order_.reason = reason;
  order_.in_charge = false;
  holding_ = false;
  next_decision_ = now_;
}

void Helm::hold_because(HelmState state, std::string_view reason) noexcept {
  order_.state = state;
  order_.reason = reason;
  order_.in_charge = true;
  command_ = {.mode = Mode::hold};
  next_decision_ = now_;
}

void Helm::see_health() noexcept {
  const OnboardPolicy& policy = setup_.policy;
  const bool has_begun = own_watch_.last().has_value();
  const double age = own_watch_.age(now_);
  if (has_begun && age > policy.own_lost_s) {
    health_ = Health::lost;
  } else if (has_begun && age > policy.own_stale_s) {
    health_ = std::max(health_, Health::stale);
  } else if (!has_begun || now_ - own_watch_.good_since() >= policy.recovery_s) {
    health_ = Health::good;
  }
}

void Helm::see_arrival() noexcept {
  const bool goes = task_ == Task::go || task_ == Task::section;
  if (!goes) arrived_ = false;
  if (goes && own_watch_.last() && health_ == Health::good &&
      (leg_.position - own_.position).norm() <= leg_.arrival_m)
    arrived_ = true;
}

Ownship Helm::own_at(const Fix& fix) const noexcept {
  const VehicleState& x = fix.state;
  const double age = now_ - fix.time;
  Ownship own{.id = setup_.id,
              .position = x.p_n,
              .velocity = x.v_n(),
              .yaw = yaw_of(x.q_nb),
              .yaw_rate = x.omega_b.z(),
              .radius = setup_.radius,
              .priority = arrived_ ? std::numeric_limits<std::int32_t>::max() : setup_.priority};
  if (age != 0.0) {
    own.position += age * own.velocity;
    own.yaw = wrap_angle(own.yaw + age * own.yaw_rate);
  }
  return own;
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
  const double late = std::fmax(0.0, age - policy.neighbour_stale_s);
  return std::fmin(policy.max_growth_m, policy.growth_mps * late);
}

Track Helm::track_of(std::size_t index) const noexcept {
  const TeamMate& mate = setup_.team[index];
  const Neighbour& neighbour = neighbours_[index];
  const Fix& fix = *neighbour.watch.last();
  const double age = now_ - fix.time;
  const double since = std::fmax(0.0, age);
  const double drift = setup_.policy.unforeseen_acceleration_mps2 * since;
  Track track{.id = TrackId{number(mate.id)},
              .position = fix.state.p_n,
              .velocity = fix.state.v_n(),
              .yaw = yaw_of(fix.state.q_nb),
              .radius = neighbour.radius + growth_of(age),
              .age = since,
              .priority = neighbour.arrived ? std::numeric_limits<std::int32_t>::max() : neighbour.priority,
              .destination = neighbour.arrived ? std::nullopt : neighbour.goal,
              .reacts = mate.reacts,
              .position_covariance = 0.25 * since * since * drift * drift * Mat3::Identity(),
              .velocity_covariance = drift * drift * Mat3::Identity()};

  // whoever is lost may lie anywhere by now: it stays where the prediction has come to, and is not counted on
  track.position += std::fmin(age, setup_.policy.neighbour_lost_s) * track.velocity;
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

bool Helm::is_due() const noexcept {
  const double interval = std::clamp(now_ - updated_, 0.0, setup_.period);
  return now_ + 0.5 * interval >= next_decision_;
}

void Helm::decide(Sketch* sketch) noexcept {
  look_round();
  Situation situation{.time = now_,
                      .period = setup_.period,
                      .own = own_,
                      .goal = {.position = leg_.position, .cruise_speed = leg_.speed_mps},
                      .limits = setup_.limits,
                      .model = setup_.model ? &*setup_.model : nullptr,
                      .tracks = tracks_,
                      .obstacles = setup_.chart};
  if (task_ == Task::section) situation.goal.velocity = follow_section(leg_, own_).velocity;
  command_ = avoider_.decide(situation, sketch);
  lead_back(command_);
  see_progress(situation);
  next_decision_ = now_ + setup_.period;
  order_.decided = true;
  ++decisions_;
  if (command_.mode == Mode::infeasible) ++infeasible_;
}

void Helm::see_progress(const Situation& situation) noexcept {
  const double window = setup_.policy.progress_window_s;
  Goal goal = situation.goal;
  goal.cruise_speed = std::fmin(goal.cruise_speed, setup_.limits.max_speed);
  progress_watch_.see(now_, own_.position, goal, true);
  bystanders_.clear();
  for (std::size_t k = 0; k < near_.size(); ++k) {
    const Track& track = tracks_[k];
    Neighbour& neighbour = neighbours_[near_[k].index];
    neighbour.trail.see(now_, track.position, progress_watch_.step(), window);
    bystanders_.push_back({.id = track.id,
                           .gap = std::sqrt(near_[k].distance2) - own_.radius - track.radius,
                           .rests_since = neighbour.trail.since(),
                           .may_clear_way = track.reacts && !neighbour.arrived});
  }
  progress_ = progress_watch_.judge(command_.mode, bystanders_);
}

void Helm::stop_watching_progress() noexcept {
  progress_watch_.see(now_, own_.position, {.position = leg_.position}, false);
  progress_ = progress_watch_.judge(command_.mode, {});
}

void Helm::lead_back(Command& command) const noexcept {
  const double error = within(setup_.limits, own_.position.z()) - own_.position.z();
  const double fastest = std::fmin(return_speed, setup_.limits.max_climb_rate);
  const double back = std::clamp(return_gain * error, -fastest, fastest);
  double& down = command.velocity.z();
  if (error > 0.0) down = std::fmax(down, back);
  if (error < 0.0) down = std::fmin(down, back);
}

void Helm::carry_out() noexcept {
  order_.command = command_;
  const bool hold_here = command_.mode == Mode::hold && !is_blind();
  if (hold_here && !holding_) {
    hold_ = {own_.position, own_.yaw};
    hold_.position.z() = within(setup_.limits, own_.position.z());
  }
  holding_ = hold_here;
  order_.request = request();
}

BodyRequest Helm::request() const noexcept {
  const SteeringParams& steering = setup_.steering;
  const bool can_stop = steering.kind != SteeringKind::crab;
  if (is_blind()) return can_stop ? BodyRequest{} : circle_blind(steering);
  if (can_stop) return holding_ ? ::fairway::keep_position(hold_, own_) : steer(steering, command_, own_.yaw);

  const Command command =
      holding_ ? circle(hold_, steering.circle_radius_m, steering.min_speed_mps, own_) : command_;
  return steer_through_water(steering, command, own_.yaw, Vec3::Zero());
}

}  // namespace fairway
