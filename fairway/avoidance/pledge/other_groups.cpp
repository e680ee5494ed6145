// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/other_groups.hpp"

namespace fairway::pledge {

void OtherGroups::hear(const Word& word) noexcept {
  const Header& header = header_of(word);
  Bystander& other = bystanders_[header.sender];
  if (header.sent <= other.heard) return;
  other.heard = header.sent;
  const auto* state = std::get_if<StateWord>(&word);
  const bool rests = state != nullptr && header.status != Status::moving;
  rounds.hear(header.sender, header.round, rests);
  if (!rests) return;
  const Member& member = state->member;
  other.known = true;
  other.place = member.anchor;
  other.radius = member.radius;
  other.destination = member.destination;
  if (header.status != Status::lost) return;
  const Vec3 half = 0.5 * (member.destination - member.anchor);
  other.place += half;
  other.radius += wandering + half.norm();
}

std::span<const Obstacle> OtherGroups::places(const Tubes& tubes,
                                              std::array<Obstacle, most_vehicles>& room) const noexcept {
  std::size_t count = 0;
  for (std::size_t i = 0; i < rounds.groups().vehicles; ++i) {
    if (bystanders_[i].known)
      room[count++] = {.kind = Obstacle::Kind::sphere,
                       .position = bystanders_[i].place,
                       .radius = bystanders_[i].radius + tubes.radius + 0.5 * tubes.told};
  }
  return std::span{room}.first(count);
}

}  // namespace fairway::pledge
