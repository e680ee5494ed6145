// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "fairway/avoidance/pledge/following.hpp"
#include "fairway/avoidance/pledge/rounds.hpp"

namespace fairway::pledge {

/// How own ship gets out of the way of others whose ways it knows, and who are not counted on to know of it.
/// It looks half a minute ahead at what becomes of holding, and of going one of some courses up, level or
/// down for some seconds and lying there: as own ship makes that, which runs on, turns, and goes. It takes
/// what comes least near to the others, soon weighing more than late. By a share that counts for wherever
/// they may have stopped on their ways by then, too. A value on the stack; nothing allocates or throws.
class Evasion {
 public:
  /// Of own ship, which takes so long to turn round [s].
  Evasion(const Situation& s, double turn) noexcept;

  /// Somebody goes so, and centres should be `apart` [m]. O(seconds x knots).
  void avoid(const Reference& way, double apart) noexcept;

  /// The velocity over ground to go with [m/s, NED]; none where it is best to hold. O(courses x seconds x
  /// (others x seconds + obstacles)).
  std::optional<Vec3> best() const noexcept;

 private:
  static constexpr std::size_t seconds = 30;  ///< that are foreseen
  static constexpr std::size_t most_others = most_members + most_vehicles;

  using Path = std::array<Vec3, seconds>;  ///< each second from one ahead on [m, NED]
  struct Other {
    Path path;
    double apart{};
    bool moves{};

    double nearness(const Vec3& place, std::size_t second) const noexcept;
  };

  Path gone(const Vec3& velocity, double begins, double lasts) const noexcept;
  double nearness(const Path& own, double enough) const noexcept;

  const Situation& s_;
  double turn_;
  Path adrift_;  ///< of own ship that only runs on
  std::array<Other, most_others> others_;
  std::size_t count_{0};
};

}  // namespace fairway::pledge
