// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/avoidance/sketch.hpp"
#include "fairway/core/params.hpp"

namespace fairway {

/// One thing that an algorithm drew. Only the members of its kind mean anything.
struct Stroke {
  enum class Kind : std::uint8_t {
    velocity,    ///< `points` is one velocity [m/s, NED]
    half_space,  ///< `points` is a point of the plane and its normal, towards what is allowed [m/s, NED]
    region,      ///< `points` is the outline of forbidden velocities [m/s, NED]
    path,        ///< `points` is a line through positions [m, NED]
    tree,        ///< `points` is pairs of positions, an edge each [m, NED]
    sphere,      ///< `points` is its centre [m, NED]; `size` its radius [m]
    image,       ///< `rgb`, `side`, `size` (reach [m/s]) and `yaw` [rad] as in VelocityImage
  };
  Kind kind{};
  std::string meaning;
  std::vector<Vec3> points;
  double size{};
  double yaw{};
  std::int32_t side{};
  std::vector<std::uint32_t> rgb;

  friend bool operator==(const Stroke&, const Stroke&) = default;
};

template <>
struct EnumNames<Stroke::Kind> {
  static constexpr std::array names{"velocity", "half_space", "region", "path", "tree", "sphere", "image"};
};

/// Keeps what is drawn, in order. Allocates: for looking at decisions, not for campaigns.
class Drawing final : public Sketch {
 public:
  void velocity(const Vec3& v, std::string_view meaning) override;
  void half_space(const Vec3& point, const Vec3& normal, std::string_view meaning) override;
  void region(std::span<const Vec3> outline, std::string_view meaning) override;
  void path(std::span<const Vec3> points, std::string_view meaning) override;
  void tree(std::span<const Vec3> edges, std::string_view meaning) override;
  void sphere(const Vec3& centre, double radius, std::string_view meaning) override;
  void image(const VelocityImage& image, std::string_view meaning) override;

  std::span<const Stroke> strokes() const { return strokes_; }
  void clear() { strokes_.clear(); }

 private:
  Stroke& add(Stroke::Kind kind, std::string_view meaning);

  std::vector<Stroke> strokes_;
};

}  // namespace fairway
