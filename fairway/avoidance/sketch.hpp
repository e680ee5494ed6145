// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fairway/core/vec.hpp"

namespace fairway {

/// A picture over horizontal velocities: side x side pixels, evenly spaced over [-reach, reach]^2 in axes
/// turned by `yaw`, row by row from the fastest ahead, in each row from the fastest to port. So with its top
/// turned by `yaw` from north it lies as on a chart, its middle being no velocity.
struct VelocityImage {
  std::span<const std::uint32_t> rgb;  ///< 0xRRGGBB
  int side{};
  double reach{};  ///< of the outermost pixels' middles [m/s]
  double yaw{};    ///< of the picture's top [rad], 0 north, positive to starboard
};

/// What an algorithm draws of its own thinking, for the viewer and `fairway explain`; null in a
/// campaign. `meaning` is a short label such as "allowed by vehicle 3" (label.hpp).
class Sketch {
 public:
  virtual ~Sketch() = default;

  /// A point or arrow in velocity space, relative to own position when drawn [m/s, NED].
  virtual void velocity(const Vec3& v, std::string_view meaning) = 0;
  /// Velocities v with (v - point) . normal >= 0 are allowed [m/s, NED].
  virtual void half_space(const Vec3& point, const Vec3& normal, std::string_view meaning) = 0;
  /// Velocities inside the closed outline are forbidden [m/s, NED].
  virtual void region(std::span<const Vec3> outline, std::string_view meaning) = 0;
  /// A line through positions [m, NED].
  virtual void path(std::span<const Vec3> points, std::string_view meaning) = 0;
  /// Edges between positions, each two of them, as of a search tree [m, NED].
  virtual void tree(std::span<const Vec3> edges, std::string_view meaning) = 0;
  /// A ball of positions [m, NED].
  virtual void sphere(const Vec3& centre, double radius, std::string_view meaning) = 0;
  /// Something about every velocity of a horizontal square. The pixels are valid during the call only.
  virtual void image(const VelocityImage& image, std::string_view meaning) = 0;
};

}  // namespace fairway
