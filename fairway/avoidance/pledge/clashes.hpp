// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fairway/avoidance/pledge/reference.hpp"

namespace fairway::pledge {

/// Which ways by rings of one side and width were found not to go together, so that nobody looks twice: a
/// clash of two members is the same whatever the others do.
class Clashes {
 public:
  using Rings = std::array<std::uint8_t, most_members>;  ///< of each member, by number

  /// Of two members by their rings; of one with itself: it can go that way with nobody.
  void add(std::size_t a, std::size_t b, const Rings& rings) noexcept {
    known_[a][b] |= bit(rings[a], rings[b]);
  }

  /// Whether some of the members are known not to go together. O(members^2).
  bool are_any(const Members& members, const Rings& rings) const noexcept {
    for (std::size_t a = 0; a < most_members; ++a) {
      for (std::size_t b = 0; members[a] && b <= a; ++b)
        if (members[b] && (known_[a][b] & bit(rings[a], rings[b])) != 0) return true;
    }
    return false;
  }

 private:
  static std::uint64_t bit(std::uint8_t a, std::uint8_t b) {
    return std::uint64_t{1} << (a * ring_radius.size() + b);
  }

  std::array<std::array<std::uint64_t, most_members>, most_members> known_{};  ///< the later member first
};

}  // namespace fairway::pledge
