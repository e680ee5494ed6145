// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fairway/avoidance/situation.hpp"

namespace fairway::environment {

/// The axes of all that has a direction, seen or asked.
enum class Axes : std::uint8_t {
  ned,      ///< north, east, down
  heading,  ///< ahead, to starboard, down: NED turned by the vehicle's yaw
};

/// How many numbers one vehicle sees, and what they are: the vehicle itself, then its nearest tracks, nearest
/// first, then the nearest points of the nearest obstacles. Where there are fewer, zeros follow.
struct ObservationShape {
  static constexpr int own_size = 12;
  static constexpr int track_size = 9;
  static constexpr int obstacle_size = 4;
  static constexpr int most_tracks = 64;
  static constexpr int most_obstacles = 16;

  int tracks{-1};
  int obstacles{-1};
  Axes axes{Axes::ned};

  std::size_t size() const {
    return std::size_t{own_size} + static_cast<std::size_t>(tracks) * track_size +
           static_cast<std::size_t>(obstacles) * obstacle_size;
  }

  /// A name for each number, ending in its unit.
  std::vector<std::string> names() const;
};

/// What a vehicle knows at an instant.
struct Sight {
  const Ownship& own;
  Goal goal;
  std::span<const Track> tracks;        ///< nearest first
  std::span<const Obstacle> obstacles;  ///< in any order
};

/// Writes shape.size() numbers. O(tracks + obstacles x shape.obstacles), allocates nothing.
void observe(const ObservationShape& shape, const Sight& sight, std::span<float> numbers) noexcept;

/// `v` of NED in `axes`, and back.
Vec3 to_axes(Axes axes, double yaw, const Vec3& v) noexcept;
Vec3 from_axes(Axes axes, double yaw, const Vec3& v) noexcept;

}  // namespace fairway::environment
