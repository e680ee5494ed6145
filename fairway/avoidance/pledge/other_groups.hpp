// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <span>

#include "fairway/avoidance/pledge/clearance.hpp"
#include "fairway/avoidance/pledge/rounds.hpp"
#include "fairway/avoidance/pledge/words.hpp"

namespace fairway::pledge {

/// What a member knows of the vehicles of other groups: whose round it is, and where they are held.
class OtherGroups {
 public:
  OtherGroups() = default;
  OtherGroups(std::size_t self, const Groups& groups) noexcept : rounds{self, groups} {}

  /// A word of a vehicle of another group; one that was said before the last that was heard is passed over.
  void hear(const Word& word) noexcept;

  /// Where they are held, each a sphere of its radius and tube; of who is lost one that holds where it drifts
  /// in the time that it foretold. Written to `room`; as far as they have told it. O(vehicles).
  std::span<const Obstacle> places(const Tubes& tubes,
                                   std::array<Obstacle, most_vehicles>& room) const noexcept;

  Rounds rounds;

 private:
  struct Sphere {
    bool known{false};
    Vec3 place = Vec3::Zero();
    double radius{};
    double heard = -std::numeric_limits<double>::infinity();  ///< when the last word was said [s]
  };
  std::array<Sphere, most_vehicles> spheres_{};
};

}  // namespace fairway::pledge
