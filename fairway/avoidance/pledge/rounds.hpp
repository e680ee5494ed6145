// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fairway::pledge {

/// Members of a group, as many as a plan's word has room for.
inline constexpr std::size_t most_members = 8;
inline constexpr std::size_t most_groups = 4;
inline constexpr std::size_t most_vehicles = most_groups * most_members;

/// How vehicles, which are numbered from 0, are dealt out to as few groups as hold them: one to each group in
/// turn, so that groups differ by one member at most.
struct Groups {
  std::size_t vehicles{most_members};
  std::size_t most{most_members};  ///< in a group

  std::size_t count() const { return (vehicles + most - 1) / most; }
  std::size_t group_of(std::size_t vehicle) const { return vehicle % count(); }
  std::size_t member_of(std::size_t vehicle) const { return vehicle / count(); }
  std::size_t size_of(std::size_t group) const { return (vehicles - group + count() - 1) / count(); }
  std::size_t vehicle_of(std::size_t group, std::size_t member) const { return member * count() + group; }
};

/// Whose turn it is to move, where there are several groups. Every vehicle counts rounds for itself, and
/// tells its round with every word, modulo four. Round k is owned by group k modulo the number of groups. The
/// rules, on which claims C7 and C8 of the README rest:
///
/// 1. A vehicle departs only in a round that its own group owns, and only when it has of everybody in another
///    group a place at which that one rests, or the way by which it goes until it rests, told in a later
///    round than the last that its group has owned.
/// 2. It leaves a round that its own group owns only when it is at rest where it says, or on the way that it
///    says.
/// 3. It leaves no round before it has heard everybody in that round or a later one.
/// 4. Of two words of one vehicle that which was said later counts.
///
/// By 3 nobody is more than one round from anybody, so two bits tell which round a word is of. A value;
/// O(vehicles) a call; nothing allocates or throws.
class Rounds {
 public:
  static constexpr std::int64_t modulus = 4;

  Rounds() = default;
  Rounds(std::size_t self, const Groups& groups) noexcept;

  const Groups& groups() const { return groups_; }
  std::int64_t round() const { return round_; }
  std::uint8_t told() const { return static_cast<std::uint8_t>(round_ % modulus); }

  /// A word of another vehicle, said later than all that was heard of it before: in which round, modulo four,
  /// and whether it tells a place at which its sender rests.
  void hear(std::size_t from, std::uint8_t told, bool tells_place) noexcept;
  /// The last word that was heard of another tells a place, or the way by which its sender goes.
  void tell_place(std::size_t from) noexcept { others_[from].placed = others_[from].heard; }

  /// The latest round in which another was heard; -1 before any.
  std::int64_t heard_in(std::size_t other) const { return others_[other].heard; }

  std::size_t own_group() const { return groups_.group_of(self_); }
  bool owns() const { return is_owner(self_, round_); }
  /// The second half of rule 1.
  bool knows_places() const noexcept;
  /// Rule 3.
  bool everyone_has_come() const noexcept;

  /// Rule 1.
  bool may_depart() const noexcept { return owns() && knows_places(); }
  /// Rules 2 and 3. `is_settled`: as rule 2 asks.
  bool may_go_on(bool is_settled) const noexcept {
    return groups_.count() > 1 && everyone_has_come() && (is_settled || !owns());
  }
  void go_on() noexcept { ++round_; }

 private:
  struct Other {
    std::int64_t heard{-1};   ///< the latest round
    std::int64_t placed{-1};  ///< the latest round in which it told a place, or its way
  };

  bool is_owner(std::size_t vehicle, std::int64_t round) const noexcept;

  std::size_t self_{};
  Groups groups_{};
  std::int64_t round_{0};
  std::array<Other, most_vehicles> others_{};
};

}  // namespace fairway::pledge
