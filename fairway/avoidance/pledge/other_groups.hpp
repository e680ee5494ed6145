// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <span>

#include "fairway/avoidance/pledge/clearance.hpp"
#include "fairway/avoidance/pledge/rounds.hpp"
#include "fairway/avoidance/pledge/words.hpp"

namespace fairway::pledge {

/// What all vehicles that agree have to have in common.
struct Terms {
  std::size_t count{most_members};  ///< vehicles are 0 to count - 1
  Vec2 datum = Vec2::Zero();        ///< to which places are told [m, north and east]
  Tubes tubes{};

  Groups groups() const { return {.vehicles = count}; }
};

/// A word as it was said.
struct Said {
  Speech speech{};
  double sent = -std::numeric_limits<double>::infinity();  ///< [s]
};

/// A vehicle of another group, as it last told where it rests.
struct Bystander {
  bool known{false};                ///< whether it did, and has not departed since
  Vec3 place = Vec3::Zero();        ///< [m, NED]
  double radius{};                  ///< [m]
  Vec3 destination = Vec3::Zero();  ///< [m, NED]
  Epoch goes_by{};                  ///< the plan by which it says it is on its way
  std::uint8_t version{};           ///< of the state from which it departed, where its way is known
  Said said{};                      ///< the last word of it
};

/// What a member knows of the vehicles of other groups: whose round it is, where they are held, and by which
/// ways they go.
class OtherGroups {
 public:
  OtherGroups() = default;
  OtherGroups(std::size_t self, const Terms& terms) noexcept : rounds{self, terms.groups()}, terms_{terms} {}

  Rounds rounds;

  /// A word of a vehicle of another group; one that was said before the last that was heard is passed over.
  void hear(const Word& word, const Speech& speech) noexcept;

  /// Rule 1 of `Rounds`.
  bool may_depart() const noexcept;

  /// Where they are held, each a sphere of its radius and tube; of who is lost one that holds where it drifts
  /// in the time that it foretold. Written to `room`; as far as they have told it. O(vehicles).
  std::span<const Obstacle> places(std::array<Obstacle, most_vehicles>& room) const noexcept;

  /// Who are on their ways, as far as these are known.
  std::span<const Passing> passing() const { return std::span{passing_}.first(passing_count_); }

  std::span<const Bystander> bystanders() const { return bystanders_; }

 private:
  /// Of one other group.
  struct Group {
    std::array<Member, most_members> members{};  ///< as they last told
    Members known{};
    Plan plan{};                                 ///< the newest
    std::array<Member, most_members> planned{};  ///< the states that it was made from
    Epoch understood{};                          ///< the plan of which these are known
  };

  void learn(const StateWord& word, Bystander& other) noexcept;
  bool tells_way(const Header& header, const StateWord* state) noexcept;
  void follow(std::size_t group) noexcept;
  bool is_passing(std::size_t vehicle) const noexcept;
  void forget_way(std::size_t vehicle) noexcept;

  Terms terms_{};
  std::array<Bystander, most_vehicles> bystanders_{};
  std::array<Group, most_groups> groups_{};
  std::array<Passing, most_vehicles - most_members> passing_{};
  std::size_t passing_count_{0};
};

}  // namespace fairway::pledge
