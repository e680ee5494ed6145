// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fairway/scenario/scenario.hpp"

namespace fairway::transport {

/// What is known of a random field, and what moves in it. The three kinds of one seed have the same static
/// obstacles, so that runs pair.
enum class FieldKind {
  known,    ///< every obstacle is charted
  unknown,  ///< about half of them are not
  moving,   ///< as unknown, and three spheres drift through
};
inline constexpr std::array field_kinds{FieldKind::known, FieldKind::unknown, FieldKind::moving};
std::string_view name_of(FieldKind kind);

/// The footprint of the transport system: a disc that holds the four tips [m].
inline constexpr double footprint_radius = 3.2;

/// A square of 50 m with 8 to 14 discs of 1 to 4 m, to be crossed from corner to corner.
struct Field {
  Vec3 start = Vec3::Zero();
  Vec3 goal{50.0, 50.0, 0.0};
  std::vector<ObstacleSpec> obstacles;
};

/// The field of a seed. Start and goal are at least 2 m clear of the obstacles around the footprint. Drifters
/// have a radius of 0.5 to 1.5 m and a speed of 0.05 to 0.2 m/s, begin 20 m from the start or farther, and
/// aim at a point of the middle.
Field random_field(FieldKind kind, std::uint64_t seed);

/// Whether the field can be crossed by someone who knows all of it beforehand: a disc of the footprint's
/// radius and half a metre more, at no more than 0.25 m/s along north or east or at rest, gets from the start
/// to within 1 m of the goal in 1200 s without touching anything, drifters included. Decided by the reachable
/// set on a grid of 0.5 m and 2 s, so a way narrower than a cell is not seen: "no" is no proof, "yes" is.
bool has_escape(const Field& field);

/// Whether someone who is at `from` at `time` and knows everything can stay untouched for two minutes,
/// arriving or not; on the same grid, at the same speed, with a tenth of a metre to spare. "No" means caught:
/// between what stays and what drifts, nothing slower than that gets out.
bool can_stay_clear(std::span<const ObstacleSpec> obstacles, const Vec3& from, double time);

}  // namespace fairway::transport
