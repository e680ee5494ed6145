// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "fairway/avoidance/situation.hpp"
#include "fairway/planning/planar_map.hpp"

namespace fairway {

/// What a way through space and time is looked for in.
struct SpaceTimeTask {
  Vec2 from = Vec2::Zero();                ///< now [m, NE]
  Vec2 towards = Vec2::Zero();             ///< [m, NE]
  double speed{};                          ///< greatest [m/s]
  double radius{};                         ///< of own sphere [m]
  double margin{};                         ///< kept from everything [m]
  std::span<const PlanarMap* const> maps;  ///< inflated by own radius at least
  std::span<const Track> tracks;           ///< each taken to keep its velocity
};

/// The first leg of the best way on which nothing is touched for about a minute, and how long to take it.
struct SpaceTimeLeg {
  Vec2 to = Vec2::Zero();  ///< [m, NE]
  double duration{};       ///< [s]
};

/// Dynamic programming over a square of about 30 m around the vehicle and 40 steps of time; a step is to stay
/// or to go to one of eight neighbouring cells. The best way is the one that ends nearest to `towards`, what
/// lies on the way being dear where it is near to something. Nothing if there is none. O(cells x steps),
/// about a million operations; allocates.
std::optional<SpaceTimeLeg> way_through(const SpaceTimeTask& task);

}  // namespace fairway
