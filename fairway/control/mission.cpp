// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/mission.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace fairway {
namespace {

bool is_at(const Leg& leg, const Vec3& position) {
  const Vec3 error = (leg.position - position).cwiseAbs();
  const bool has_box = leg.box_m.maxCoeff() > 0.0;
  return has_box ? (error.array() <= leg.box_m.array()).all() : error.norm() <= leg.arrival_m;
}

}  // namespace

Mission::Mission(std::vector<Leg> legs, double stuck_after)
    : legs_{std::move(legs)}, stuck_after_{stuck_after} {
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    if (legs_[i].kind == LegKind::rendezvous) past_last_rendezvous_ = i + 1;
  }
}

const Leg* Mission::next_transit() const {
  for (std::size_t i = index_; i < legs_.size(); ++i)
    if (legs_[i].kind == LegKind::transit) return &legs_[i];
  return nullptr;
}

int Mission::rendezvous_reached() const {
  if (index_ >= past_last_rendezvous_) return std::numeric_limits<int>::max();
  return rendezvous_passed_ + (legs_[index_].kind == LegKind::rendezvous ? 1 : 0);
}

bool Mission::is_complete(const Leg& leg, const Ownship& own, double time,
                          bool everyone_ready) const noexcept {
  switch (leg.kind) {
    case LegKind::go_to:
    case LegKind::section:
    case LegKind::transit:
      return is_at(leg, own.position);
    case LegKind::keep_position:
      return time - leg_start_ >= leg.duration_s;
    case LegKind::rendezvous:
      return everyone_ready;
  }
  return true;
}

void Mission::begin_leg(const Ownship& own, double time) noexcept {
  leg_start_ = time;
  const Leg* next = leg();
  if (next == nullptr) {
    phase_ = Phase::arrived;
  } else if (next->kind == LegKind::transit) {
    phase_ = Phase::under_way;
    deadline_ = time + stuck_after_ * (next->position - own.position).norm() / next->speed_mps;
  } else {
    phase_ = next->kind == LegKind::rendezvous ? Phase::waiting : Phase::deploying;
  }
}

void Mission::advance(const Ownship& own, double time, bool everyone_ready) noexcept {
  if (!begun_) {
    begun_ = true;
    begin_leg(own, time);
  }
  while (const Leg* present = leg()) {
    if (!is_complete(*present, own, time, everyone_ready)) break;
    if (present->kind == LegKind::rendezvous) ++rendezvous_passed_;
    ++index_;
    begin_leg(own, time);
    everyone_ready = false;  // the next rendezvous is for another instant
  }
  if (phase_ == Phase::under_way && time > deadline_) phase_ = Phase::stuck;
}

void Mission::change(std::vector<Leg> legs, const Ownship& own, double time) {
  legs_ = std::move(legs);
  if (!begun_ || legs_.empty()) return;
  index_ = std::min(index_, legs_.size() - 1);
  const double began = leg_start_;
  begin_leg(own, time);
  if (legs_[index_].kind == LegKind::keep_position) leg_start_ = began;
}

}  // namespace fairway
