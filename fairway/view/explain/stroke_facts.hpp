// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "fairway/avoidance/drawing.hpp"

namespace fairway {

/// A velocity this near the plane of a half-space is on it [m/s].
inline constexpr double on_plane_mps = 1e-6;

/// (v - point) . normal of a stroke of the kind half_space: how far inside the half-space `v` is, negative
/// outside [m/s].
double margin_of(const Stroke& half_space, const Vec3& v) noexcept;

/// Whether the north-east part of `v` is inside the outline of a stroke of the kind region. O(points).
bool contains(const Stroke& region, const Vec3& v) noexcept;

/// All strokes of one kind and meaning, and where the preferred and the commanded velocity are among them.
struct StrokeFacts {
  Stroke::Kind kind{};
  std::string meaning;
  std::size_t count{};
  std::size_t points{};                ///< of all of them
  double length{};                     ///< of lines and edges [m]
  std::size_t forbids_preferred{};     ///< half-spaces without it, regions with it inside
  std::size_t forbids_commanded{};     ///< likewise
  std::size_t active{};                ///< half-spaces whose plane the commanded velocity is on
  std::vector<const Stroke*> strokes;  ///< in the order drawn
};

/// In the order in which they first appear. Points into `strokes`. O(strokes times meanings).
std::vector<StrokeFacts> facts_of(std::span<const Stroke> strokes, const Vec3& preferred,
                                  const Vec3& commanded);

}  // namespace fairway
