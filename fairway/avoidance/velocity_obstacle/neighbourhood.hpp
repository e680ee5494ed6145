// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "fairway/avoidance/nearest_few.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/sketch.hpp"
#include "fairway/avoidance/velocity_obstacle/choice.hpp"
#include "fairway/avoidance/velocity_obstacle/decision.hpp"

namespace fairway::velocity_obstacle {

/// The velocity obstacles of all that is in range: the nearest tracks, then the obstacles as listed, of too
/// many the nearest; a sphere is a disc at its full radius, a polygon is its sides. O(tracks + vertices).
class Neighbourhood {
 public:
  Neighbourhood(const Situation& s, const Params& params, Responsibility responsibility) noexcept;

  std::span<const VelocityObstacle> obstacles() const { return {obstacles_.data(), places_.count()}; }
  /// Something in range found no room.
  bool left_out() const { return places_.left_out(); }

  /// Outlines, each `reach` beyond its cut [m/s].
  void draw(double reach, Sketch& sketch) const;

 private:
  void add_tracks(const Situation& s, const Params& params, Responsibility responsibility) noexcept;
  void add_obstacle(const Obstacle& obstacle, const Situation& s, const Params& params) noexcept;
  void add_polygon(const Obstacle& polygon, const Situation& s, const Params& params) noexcept;
  /// Unless it is out of range, or there is no room but for what is nearer.
  void add_solid(const RelativeCapsule& solid, const Params& params) noexcept;

  std::array<VelocityObstacle, max_obstacles> obstacles_;
  std::array<TrackId, max_obstacles> ids_;  // of the tracks
  NearestFew<max_obstacles> places_;
  std::size_t track_count_ = 0;
};

}  // namespace fairway::velocity_obstacle
