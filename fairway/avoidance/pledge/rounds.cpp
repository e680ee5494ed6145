// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/rounds.hpp"

#include <algorithm>

namespace fairway::pledge {

Rounds::Rounds(std::size_t self, const Groups& groups) noexcept : self_{self}, groups_{groups} {}

bool Rounds::is_owner(std::size_t vehicle, std::int64_t round) const noexcept {
  const auto count = static_cast<std::int64_t>(groups_.count());
  return static_cast<std::int64_t>(groups_.group_of(vehicle)) == round % count;
}

void Rounds::hear(std::size_t from, std::uint8_t told, bool tells_place) noexcept {
  // of the four rounds that are told so, the one that is one behind the own, the same or one ahead
  const std::int64_t ahead = (told + 1 - round_ % modulus + 2 * modulus) % modulus - 1;
  if (ahead > 1) return;  // nobody can be there
  Other& other = others_[from];
  other.heard = std::max(other.heard, round_ + ahead);
  if (tells_place) other.placed = std::max(other.placed, round_ + ahead);
}

bool Rounds::knows_places() const noexcept {
  const auto count = static_cast<std::int64_t>(groups_.count());
  for (std::size_t i = 0; i < groups_.vehicles; ++i) {
    if (groups_.group_of(i) == own_group()) continue;
    const auto group = static_cast<std::int64_t>(groups_.group_of(i));
    const std::int64_t last_owned = round_ - (round_ - group + count) % count;
    if (others_[i].placed <= std::max(last_owned, std::int64_t{-1})) return false;
  }
  return true;
}

bool Rounds::everyone_has_come() const noexcept {
  for (std::size_t i = 0; i < groups_.vehicles; ++i)
    if (i != self_ && others_[i].heard < round_) return false;
  return true;
}

}  // namespace fairway::pledge
