// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/search.hpp"

namespace fairway::pledge {
namespace {

constexpr int rings = static_cast<int>(ring_radius.size());
constexpr int carousels = 2 * rings * rings;  // either way round, a ring for each class
constexpr int carousel_cost = 4;              // of one carousel, in codes
constexpr int codes = 256;

/// First where the straight ways cross, in the mean; then the middle of where all are, to go round each other
/// there; then where each of them is, to go round it.
Vec2 centre_of(const std::array<Member, most_members>& members, const Members& participants,
               std::size_t attempt) {
  const std::size_t choice = attempt % (2 + most_members);
  if (choice >= 2) return members[choice - 2].anchor.head<2>();
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < most_members; ++i) {
    const Member& m = members[i];
    if (participants[i])
      sum += choice == 0 ? Vec2{0.5 * (m.anchor + m.destination).head<2>()} : Vec2{m.anchor.head<2>()};
  }
  return participants.any() ? Vec2{sum / static_cast<double>(participants.count())} : sum;
}

bool dives(const Member& member) { return member.destination.z() > member.anchor.z(); }

}  // namespace

Search::Search(const std::array<Member, most_members>& members, const Members& participants,
               const std::array<Reference, most_members>& others, const Terms& terms,
               std::size_t attempt) noexcept
    : members_{members},
      participants_{participants},
      others_{others},
      tubes_{terms.tubes},
      attempt_{attempt},
      centre_{centre_as_told(centre_of(members, participants, attempt), terms.datum)} {
  begin();
}

void Search::begin() noexcept {
  stage_ = participants_.any() ? Stage::carousel : Stage::done;
  number_ = 0;
}

bool Search::go_on(int count) noexcept {
  for (; count > 0 && stage_ != Stage::done; --count) {
    if (stage_ == Stage::carousel) {
      count -= carousel_cost - 1;
      try_carousel(number_++);
      if (number_ == carousels) end_carousels();
    } else if (stage_ == Stage::one_by_one) {
      try_next_code();
    } else {
      improve_next();
    }
  }
  return stage_ == Stage::done;
}

/// Nobody of the participants placed yet.
Clearance Search::empty() const noexcept {
  Clearance scene{members_, participants_, tubes_, 0.0};
  for (std::size_t i = 0; i < most_members; ++i)
    if (!participants_[i] && !others_[i].knots().empty()) scene.place(i, others_[i]);
  return scene;
}

/// The participant after this one; false, and the first again, after the last.
bool Search::next_member() noexcept {
  number_ = 0;
  soonest_ = never;
  do {
    if (++turn_ < most_members) continue;
    turn_ = 0;
    member_ = numbered(0);
    return false;
  } while (!participants_[numbered(turn_)]);
  member_ = numbered(turn_);
  return true;
}

void Search::try_carousel(int number) noexcept {
  const Code down{static_cast<std::uint8_t>(number % rings)},
      up{static_cast<std::uint8_t>(number / rings % rings)};
  Plan plan{.centre = centre_, .to_port = number >= rings * rings, .participants = participants_};
  Clearance scene = empty();
  for (std::size_t i = 0; i < most_members; ++i) {
    if (!participants_[i]) continue;
    plan.codes[i] = dives(members_[i]) ? down : up;
    const Reference reference = reference_of(members_[i], plan, plan.codes[i]);
    if (!scene.accepts(i, reference)) return;
    scene.place(i, reference);
  }
  keep(scene, plan);
}

/// The best carousel is improved; without one the members go one by one.
void Search::end_carousels() noexcept {
  number_ = 0;
  turn_ = 0;
  member_ = numbered(0);
  soonest_ = never;
  stage_ = found() ? Stage::improve : Stage::one_by_one;
  plan_ = found() ? best_ : Plan{.centre = centre_};
  scene_ = empty();
  for (std::size_t i = 0; i < most_members; ++i)
    if (plan_.participants[i]) scene_.place(i, reference_of(members_[i], plan_, plan_.codes[i]));
}

/// One code of the member whose turn it is; when all were tried it takes the soonest, or stays.
void Search::try_next_code() noexcept {
  if (!participants_[member_]) number_ = codes;
  const Code code = Code::of(static_cast<std::uint8_t>(number_));
  const Reference reference = reference_of(members_[member_], plan_, code);
  if (number_ < codes && reference.end() < soonest_ && scene_.accepts(member_, reference)) {
    soonest_ = reference.end();
    code_ = code;
  }
  if (++number_ < codes) return;
  if (soonest_ < never) {
    plan_.codes[member_] = code_;
    plan_.participants.set(member_);
    scene_.place(member_, reference_of(members_[member_], plan_, code_));
  }
  if (next_member()) return;
  if (plan_.participants == participants_) {
    keep(scene_, plan_);
    stage_ = Stage::improve;
    return;
  }
  for (std::size_t i = 0; i < most_members; ++i)
    if (participants_[i] && !plan_.participants[i]) others_[i] = Reference{members_[i].anchor};
  participants_ = plan_.participants;
  begin();
}

/// The same of somebody who has a code already. Ends with the first round in which nobody found a sooner one.
void Search::improve_next() noexcept {
  if (!plan_.participants[member_]) {
    number_ = codes - 1;
  } else {
    if (number_ == 0) scene_.take_away(member_);
    const Code code = Code::of(static_cast<std::uint8_t>(number_));
    const Reference reference = reference_of(members_[member_], plan_, code);
    const double now = scene_.reference(member_).end();
    if (reference.end() < math::fmin(soonest_, now - 0.05) && scene_.accepts(member_, reference)) {
      soonest_ = reference.end();
      code_ = code;
    }
  }
  if (++number_ < codes) return;
  if (plan_.participants[member_]) {
    if (soonest_ < never) {
      plan_.codes[member_] = code_;
      improved_ = true;
    }
    scene_.place(member_, reference_of(members_[member_], plan_, plan_.codes[member_]));
  }
  if (next_member()) return;
  keep(scene_, plan_);
  stage_ = improved_ ? Stage::improve : Stage::done;
  improved_ = false;
}

/// More who go are better, then a shorter time in the mean.
void Search::keep(const Clearance& scene, const Plan& plan) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < most_members; ++i)
    if (plan.participants[i]) sum += scene.reference(i).end();
  const double mean = sum / static_cast<double>(plan.participants.count());
  const std::size_t had = best_.participants.count(), has = plan.participants.count();
  if (found() && (has < had || (has == had && mean >= best_time_))) return;
  best_ = plan;
  best_time_ = mean;
}

}  // namespace fairway::pledge
