// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/other_groups.hpp"

#include <algorithm>

namespace fairway::pledge {

void OtherGroups::hear(const Word& word, const Speech& speech) noexcept {
  const Header& header = header_of(word);
  const std::size_t from = header.sender;
  Bystander& other = bystanders_[from];
  if (header.sent <= other.said.sent) return;
  other.said = {speech, header.sent};
  const std::size_t group = rounds.groups().group_of(from);
  const auto* state = std::get_if<StateWord>(&word);
  if (state != nullptr) {
    learn(*state, other);
  } else if (const Plan& plan = std::get<PlanWord>(word).plan; groups_[group].plan.epoch < plan.epoch) {
    groups_[group].plan = plan;
  }
  const bool moves = header.status == Status::moving;
  if (!moves && state != nullptr) {
    other.goes_by = {};
    forget_way(from);
  }
  rounds.hear(from, header.round, moves ? tells_way(header, state) : state != nullptr);
  follow(group);
}

/// Whether who is on its way is on the one that is known of it, which is forgotten where it is not: it goes
/// by that plan, or speaks of a newer one and has not rested since. Of a newer plan alone that does not
/// follow.
bool OtherGroups::tells_way(const Header& header, const StateWord* state) noexcept {
  Bystander& other = bystanders_[header.sender];
  other.known = false;
  const bool goes_by_it = header.departed[rounds.groups().member_of(header.sender)];
  const bool has_rested = state != nullptr && state->member.version != other.version;
  if (goes_by_it ? other.goes_by != header.epoch : has_rested) {
    other.goes_by = goes_by_it ? header.epoch : Epoch{};
    forget_way(header.sender);
  }
  return is_passing(header.sender) && (goes_by_it || state != nullptr);
}

void OtherGroups::learn(const StateWord& word, Bystander& other) noexcept {
  const Groups& groups = rounds.groups();
  Group& group = groups_[groups.group_of(word.header.sender)];
  const std::size_t number = groups.member_of(word.header.sender);
  group.members[number] = word.member;
  group.known.set(number);
  if (word.header.status == Status::moving) return;
  const Member& member = word.member;
  other.known = true;
  other.place = member.anchor;
  other.radius = member.radius;
  other.destination = member.destination;
  if (word.header.status != Status::lost) return;
  const Vec3 half = 0.5 * (member.destination - member.anchor);
  other.place += half;
  other.radius += wandering + half.norm();
}

/// The ways of those of a group who are on their way by its newest plan, once the states are known that it
/// was made from.
void OtherGroups::follow(std::size_t group) noexcept {
  Group& g = groups_[group];
  if (!g.plan.epoch) return;
  const bool has_all = (g.plan.participants & ~g.known).none();
  if (g.understood != g.plan.epoch && has_all &&
      digest_of(g.members, g.plan.participants, terms_.datum) == g.plan.digest) {
    g.planned = g.members;
    g.understood = g.plan.epoch;
  }
  if (g.understood != g.plan.epoch) return;
  for (std::size_t i = 0; i < rounds.groups().size_of(group); ++i) {
    const std::size_t vehicle = rounds.groups().vehicle_of(group, i);
    const bool goes = g.plan.participants[i] && bystanders_[vehicle].goes_by == g.plan.epoch;
    if (!goes || is_passing(vehicle)) continue;
    const Clearance scene{g.planned, g.plan.participants, terms_.tubes, g.plan.start()};
    passing_[passing_count_] = scene.passing(i, reference_of(g.planned[i], g.plan, g.plan.codes[i]));
    passing_[passing_count_++].vehicle = vehicle;
    rounds.tell_place(vehicle);
    bystanders_[vehicle].version = g.planned[i].version;
  }
}

bool OtherGroups::is_passing(std::size_t vehicle) const noexcept {
  return std::ranges::find(passing(), vehicle, &Passing::vehicle) != passing().end();
}

void OtherGroups::forget_way(std::size_t vehicle) noexcept {
  for (std::size_t i = 0; i < passing_count_; ++i)
    if (passing_[i].vehicle == vehicle) passing_[i--] = passing_[--passing_count_];
}

bool OtherGroups::may_depart() const noexcept {
  if (!rounds.may_depart()) return false;
  const Groups& groups = rounds.groups();
  for (std::size_t i = 0; i < groups.vehicles; ++i)
    if (groups.group_of(i) != rounds.own_group() && !bystanders_[i].known && !is_passing(i)) return false;
  return true;
}

std::span<const Obstacle> OtherGroups::places(std::array<Obstacle, most_vehicles>& room) const noexcept {
  std::size_t count = 0;
  for (std::size_t i = 0; i < rounds.groups().vehicles; ++i) {
    if (bystanders_[i].known)
      room[count++] = {.kind = Obstacle::Kind::sphere,
                       .position = bystanders_[i].place,
                       .radius = bystanders_[i].radius + terms_.tubes.radius + 0.5 * terms_.tubes.told};
  }
  return std::span{room}.first(count);
}

}  // namespace fairway::pledge
