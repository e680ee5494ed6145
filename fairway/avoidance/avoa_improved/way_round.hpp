// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "fairway/avoidance/avoa_improved/capsule.hpp"

namespace fairway::avoa_improved {

/// Which of several ways of nearly the same length is taken.
struct Preference {
  std::optional<Vec2> committed;  ///< the direction of the way taken so far, unit [NED]
  double commitment{};            ///< to turn back from it, another way is to be shorter by this [m]
  std::optional<Vec2> heading;    ///< the present one, from which the way turns off, unit [NED]
  double bend{};                  ///< what a turn costs beyond its length [m/rad]
};

/// A way of straight lines and arcs.
struct WayRound {
  static constexpr std::size_t most_points = 64;

  bool is_straight = false;                ///< nothing is in the way
  double length{};                         ///< [m]
  Vec2 direction = Vec2::Zero();           ///< at its beginning, unit [NED]
  std::array<Vec2, most_points> points{};  ///< its corners: begin, ends of straight lines, end [m, NED]
  std::size_t point_count = 0;
};

/// The shortest way from `own` to `goal` that keeps out of the solids where they are at time 0, each as wide
/// as its radius: a taut string, found by A* over the tangents of their rounded ends. A solid that `own` or
/// `goal` lies in is taken to be only just so wide that it does not. Nothing if there is no way, or none
/// among the first few thousand partial ways. O(ends^2 solids) at worst.
std::optional<WayRound> way_round(std::span<const Capsule> solids, const Vec2& own, const Vec2& goal,
                                  const Preference& preference) noexcept;

}  // namespace fairway::avoa_improved
