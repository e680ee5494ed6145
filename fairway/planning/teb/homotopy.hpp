// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/planning/teb/band.hpp"
#include "fairway/planning/teb/band_obstacle.hpp"

namespace fairway::teb {

/// How a way goes round each barrier: the turns of the line from the barrier to who goes along it, positive
/// to starboard. For barriers that stand still the components of the H-signature of Bhattacharya et al.
/// (2010), kept apart where the original adds them up with weights; for those that move, the integral of the
/// H-signature in (x, y, t) (2012) along a barrier's straight line in space-time, which is an angle about it
/// by Ampere's law.
using Signature = std::vector<double>;

/// From `from` to `to`, in a straight line that begins and ends at those times [s]. O(barriers).
Signature signature_of(std::span<const BandObstacle> barriers, const Vec2& from, const Vec2& to, double begin,
                       double end);

/// O(poses x barriers).
Signature signature_of(std::span<const BandObstacle> barriers, const Band& band);

/// Whether two ways with the same ends are of one class. Where nothing moves: none of their turns differ by a
/// half or more, since they differ by whole ones. Otherwise the ends differ in time, and the signs of the
/// turns count, where both are beyond the threshold.
bool are_alike(const TebParams& params, const Signature& a, const Signature& b);

/// Whether one of `classes` is alike.
bool is_among(const TebParams& params, const Signature& turns, std::span<const Signature> classes);

/// Ways round the barriers from `start` to `end` that are of none of the `known` classes, nor of each
/// other's, at most `most`, found depth first in a graph of random points in a box between the ends (Roesmann
/// et al. 2013, section III-B, there a Voronoi diagram; 2017, section 4.2). Edges lead towards the end and
/// keep min_obstacle_dist_m from all surfaces, not counting own radius. The signatures found are appended to
/// `known`.
std::vector<std::vector<Vec2>> ways_of_new_classes(const TebParams& params,
                                                   std::span<const BandObstacle> barriers, const Vec2& start,
                                                   const Vec2& end, std::size_t most,
                                                   std::vector<Signature>& known, Rng& rng);

}  // namespace fairway::teb
