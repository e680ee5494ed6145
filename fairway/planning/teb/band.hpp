// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fairway/core/vec.hpp"
#include "fairway/planning/teb/teb_params.hpp"

namespace fairway::teb {

/// A pose in the plane.
struct Pose {
  Vec2 position = Vec2::Zero();  ///< [m, NE]
  double heading{};              ///< [rad]
};

/// One pose of a band and the time to the next.
using Knot = std::array<double, 4>;  ///< north [m], east [m], heading [rad], time [s]

inline constexpr std::size_t heading_of = 2, time_of = 3;  ///< members of a Knot

/// A timed elastic band: poses and the times between them (Roesmann et al. 2012, section 2). The time of the
/// last knot means nothing.
struct Band {
  std::vector<Knot> knots;

  std::size_t size() const { return knots.size(); }
  Vec2 position(std::size_t i) const { return {knots[i][0], knots[i][1]}; }
  Pose pose(std::size_t i) const { return {position(i), knots[i][heading_of]}; }
  double& time(std::size_t i) { return knots[i][time_of]; }
  double time(std::size_t i) const { return knots[i][time_of]; }
  /// From the first pose to the last [s].
  double duration() const;

  friend bool operator==(const Band&, const Band&) = default;
};

/// Along a polyline of at least two points, at the speed limits, from `start` to `end`, whose positions are
/// the ends of the polyline. O(length / step).
Band band_along(const TebParams& params, std::span<const Vec2> path, const Pose& start, const Pose& end);

/// Adds poses where the time between them is long and removes them where it is short: halves more than twice
/// dt_ref_s, hands what is over dt_ref_s to the next, merges what is under it, each beyond the hysteresis.
/// Once along the band, or with moving obstacles until nothing changes, at most a hundred times.
void resize(const TebParams& params, Band& band);

/// Whether the band's end is still near enough to `end` to be moved there.
bool still_leads_to(const TebParams& params, const Band& band, const Pose& end);

/// The warm start: drops the poses that have been passed, of the next ten, and moves the ends.
void advance(const TebParams& params, Band& band, const Pose& start, const Pose& end);

}  // namespace fairway::teb
