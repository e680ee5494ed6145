// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/tracker.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/perception/tracker/gate.hpp"

namespace fairway {
namespace {

constexpr int misses_made_up = 2;         // by one contact: who is seen less than every third time is none
constexpr double radius_tolerance = 0.2;  // things are not balls: a share of the radius

TrackerParams consistent(const TrackerParams& params) {
  check_params(params);
  check(params);
  return params;
}

/// Largest standard deviation in the horizontal plane.
double horizontal_sigma(const Mat3& covariance) {
  const double middle = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double half_difference = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(middle + math::hypot(half_difference, covariance(0, 1)));
}

}  // namespace

void check(const TrackerParams& params) {
  if (params.birth_hits_count > params.birth_pings_count)
    throw InputError({}, "birth_hits_count", "is more than birth_pings_count");
}

Tracker::Tracker(const TrackerParams& params)
    : params_{consistent(params)},
      noise_{.density = params.velocity_change_mps * params.velocity_change_mps,
             .wander = params.still_change_m,
             .still_ratio = params.still_ratio},
      gate_{gate_of(params.gate_ratio, 4)},
      assignment_{static_cast<std::size_t>(params.max_tracks_count), capacity()} {
  const auto most = static_cast<std::size_t>(params.max_tracks_count);
  targets_.reserve(most);
  rows_.reserve(most);
  contact_of_.reserve(most);
  used_.reserve(capacity());
}

void Tracker::update(double time, std::span<const Contact> contacts, const Fan& view) {
  contacts = contacts.first(std::min(contacts.size(), capacity()));
  const double period = time - time_;
  for (Target& target : targets_) {
    target.motion = target.motion.predicted(period, noise_);
    target.radius_variance += params_.radius_change_mps * params_.radius_change_mps * period;
  }
  time_ = time;

  // who is established chooses first
  contact_of_.assign(targets_.size(), std::nullopt);
  used_.assign(contacts.size(), 0);
  assign(contacts, true);
  assign(contacts, false);

  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (contact_of_[i])
      correct(targets_[i], contacts[*contact_of_[i]], period);
    else
      miss(targets_[i], view);
  }
  establish();
  std::erase_if(targets_, [&](const Target& target) { return is_lost(target); });
  for (std::size_t j = 0; j < contacts.size(); ++j) {
    if (used_[j] == 0) bear(contacts[j]);
  }
}

void Tracker::assign(std::span<const Contact> contacts, bool established) {
  rows_.clear();
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (targets_[i].established == established) rows_.push_back(i);
  }
  assignment_.begin(rows_.size(), contacts.size());
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Target& target = targets_[rows_[row]];
    for (std::size_t j = 0; j < contacts.size(); ++j) {
      if (used_[j] != 0) continue;
      const double distance = distance_to(contacts[j], target);
      if (distance < gate_) assignment_.offer(row, j, gate_ - distance);
    }
  }
  const auto pairs = assignment_.solve();
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (!pairs[row]) continue;
    contact_of_[rows_[row]] = pairs[row];
    used_[*pairs[row]] = 1;
  }
}

double Tracker::distance_to(const Contact& contact, const Target& target) const {
  const double tolerance = radius_tolerance * std::max(contact.radius, target.radius);
  const double variance =
      target.radius_variance + contact.radius_sigma * contact.radius_sigma + tolerance * tolerance;
  const double off = contact.radius - target.radius;
  const ConstantVelocity at = target.motion.believed();
  return off * off / variance +
         distance2(contact.position - at.position, at.position_covariance + contact.covariance, gate_);
}

void Tracker::correct(Target& target, const Contact& contact, double period) const {
  target.motion.correct(contact.position, contact.covariance, period, noise_);
  target.lasting = contact.lasting;
  target.seen = time_;
  ++target.pings;
  ++target.hits;
  target.missed = std::max(0, target.missed - misses_made_up);

  const double measured_variance = contact.radius_sigma * contact.radius_sigma;
  const double share = target.radius_variance / (target.radius_variance + measured_variance);
  target.radius += share * (contact.radius - target.radius);
  target.radius_variance *= 1.0 - share;
}

void Tracker::miss(Target& target, const Fan& view) const {
  ++target.pings;
  if (!target.established || view.covers(target.motion.believed().position, target.radius)) ++target.missed;
}

void Tracker::establish() {
  for (Target& target : targets_) {
    if (target.established || target.hits < params_.birth_hits_count) continue;
    target.established = true;
    target.id = TrackId{next_id_++};
  }
}

bool Tracker::is_lost(const Target& target) const {
  if (!target.established)
    return target.pings - target.hits > params_.birth_pings_count - params_.birth_hits_count;
  return target.missed >= std::min(params_.death_missed_count, target.hits) ||
         time_ - target.seen > params_.death_unseen_s ||
         horizontal_sigma(target.motion.believed().position_covariance) > params_.death_sigma_m;
}

void Tracker::bear(const Contact& contact) {
  if (targets_.size() >= static_cast<std::size_t>(params_.max_tracks_count)) return;
  targets_.push_back({.motion = {contact.position, contact.covariance, params_.first_speed_mps, noise_},
                      .lasting = contact.lasting,
                      .seen = time_,
                      .radius = contact.radius,
                      .radius_variance = contact.radius_sigma * contact.radius_sigma,
                      .pings = 1,
                      .hits = 1});
}

void Tracker::report(double time, std::vector<Track>& tracks) const {
  for (const Target& target : targets_) {
    if (!target.established) continue;
    const ConstantVelocity now = target.motion.predicted(time - time_, noise_).believed();
    tracks.push_back({.id = target.id,
                      .position = now.position,
                      .velocity = now.velocity,
                      .yaw = math::atan2(now.velocity.y(), now.velocity.x()),
                      .radius = target.radius,
                      .age = time - target.seen,
                      .priority = params_.contacts_react ? 0 : first_priority,
                      .reacts = params_.contacts_react,
                      .position_covariance = now.position_covariance + target.lasting,
                      .velocity_covariance = now.velocity_covariance});
  }
}

}  // namespace fairway
