// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "fairway/avoidance/orca2d/wall.hpp"
#include "fairway/core/shapes.hpp"

namespace fairway::orca2d {

/// A disc, or one wall, of what does not move.
struct Landmark {
  enum class Kind : std::uint8_t { disc, wall, wall_from_inside };
  double distance;         ///< from own ship to its surface [m]; 0 inside
  std::uint32_t obstacle;  ///< its index
  std::uint32_t edge;      ///< of a polygon: from this vertex to the next
  Kind kind;
  bool is_reversed;  ///< the polygon's vertices are counted from the last
};

/// What to look for round own ship.
struct Sight {
  Vec2 position;      ///< [m, north and east]
  double disc_range;  ///< how far to look for discs, to their surface [m]
  double wall_range;  ///< how far to look for walls [m]
};

/// More landmarks than this are not looked at, the nearest first.
inline constexpr std::size_t max_landmarks = 512;

/// The landmarks in range, nearest first, equal distances in the order of the obstacles. A wall of a solid
/// is one that faces own ship; from inside a solid there is only the nearest way out. On the stack.
class Shore {
 public:
  /// O(vertices + landmarks log landmarks).
  Shore(std::span<const Obstacle> obstacles, const Sight& sight) noexcept;

  std::span<const Landmark> landmarks() const { return {landmarks_.data(), count_}; }

 private:
  void add_polygon(std::span<const Vec3> vertices, std::uint32_t index, const Sight& sight);
  void add(const Landmark& landmark);

  std::array<Landmark, max_landmarks> landmarks_;
  std::size_t count_ = 0;
};

/// The wall that `landmark` is of its `obstacle`, as it is seen from `position`. O(1), more where vertices
/// repeat.
Wall wall_at(const Obstacle& obstacle, const Landmark& landmark, const Vec2& position) noexcept;

}  // namespace fairway::orca2d
