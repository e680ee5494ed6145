// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <span>

#include "fairway/avoidance/pledge/clearance.hpp"
#include "fairway/avoidance/pledge/rounds.hpp"
#include "fairway/avoidance/pledge/words.hpp"

namespace fairway::pledge {

/// A vehicle of another group, as it last told where it rests.
struct Bystander {
  bool known{false};                                        ///< whether it did
  Vec3 place = Vec3::Zero();                                ///< [m, NED]
  double radius{};                                          ///< [m]
  Vec3 destination = Vec3::Zero();                          ///< [m, NED]
  double heard = -std::numeric_limits<double>::infinity();  ///< when the last word was said [s]
};

/// What a member knows of the vehicles of other groups: whose round it is, and where they are held.
class OtherGroups {
 public:
  OtherGroups() = default;
  OtherGroups(std::size_t self, const Groups& groups) noexcept : rounds{self, groups} {}

  Rounds rounds;

  /// A word of a vehicle of another group; one that was said before the last that was heard is passed over.
  void hear(const Word& word) noexcept;

  /// Where they are held, each a sphere of its radius and tube; of who is lost one that holds where it drifts
  /// in the time that it foretold. Written to `room`; as far as they have told it. O(vehicles).
  std::span<const Obstacle> places(const Tubes& tubes,
                                   std::array<Obstacle, most_vehicles>& room) const noexcept;

  std::span<const Bystander> bystanders() const { return bystanders_; }

 private:
  std::array<Bystander, most_vehicles> bystanders_{};
};

}  // namespace fairway::pledge
