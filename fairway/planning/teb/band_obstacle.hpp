// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/core/vec.hpp"
#include "fairway/planning/teb/teb_params.hpp"

namespace fairway::teb {

/// How far own sphere is from a surface, and which way leads off it.
struct Separation {
  double distance{};            ///< [m], negative where they overlap
  Vec2 outward = Vec2::Zero();  ///< gradient of the distance; zero at the centre of a disc
};

/// What a band keeps clear of, seen from above and grown by own radius: a disc, which may move on at constant
/// velocity, or an obstacle that stands still. Refers to the vertices of a polygon.
class BandObstacle {
 public:
  BandObstacle(const Obstacle& obstacle, double own_radius);
  BandObstacle(const Track& track, double own_radius, bool moves);

  /// From a vessel whose centre is at `p` [m, NE] in `time` [s] from now. O(vertices).
  Separation from(const Vec2& p, double time = 0.0) const noexcept;

  /// Where it is in `time` [s] from now, as one point [m, NE].
  Vec2 centre(double time = 0.0) const noexcept { return centre_ + time * velocity_; }

  /// As it is, not grown, at depth 0.
  const Obstacle& shape() const noexcept { return shape_; }

  bool moves() const noexcept { return moves_; }
  const Vec2& velocity() const noexcept { return velocity_; }

 private:
  Obstacle shape_;
  Vec2 centre_;
  Vec2 velocity_ = Vec2::Zero();
  double grown_;
  bool moves_{};
};

/// All that may come within reach of a band from where own ship is.
std::vector<BandObstacle> band_obstacles_near(const TebParams& params, const Situation& s);

}  // namespace fairway::teb
