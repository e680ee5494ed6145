// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fairway/core/shapes.hpp"
#include "fairway/core/state.hpp"
#include "fairway/perception/sonar/sonar_params.hpp"

namespace fairway {

/// The first surface along every beam of a sonar, without noise. A beam is a sector of a plane: all
/// directions of one bearing in the plane of the hull, up to half the vertical aperture above and below it.
/// Its range is the least distance [m], in space, to a surface within it; infinite where there is none; zero
/// from inside a solid. Allocates when made, then never.
class Sweep {
 public:
  explicit Sweep(const SonarParams& params);

  /// Begins anew from a place [m, NED] with an attitude (body to NED, unit).
  void look_from(const Vec3& p_n, const Eigen::Quaterniond& q_nb);

  /// Puts a ball in the way. `centre` [m, NED]. O(beams that it covers).
  void add_sphere(const Vec3& centre, double radius);

  /// Puts an obstacle in the way: a segment is a line without thickness, a polygon is its walls through
  /// every depth. O(beams that it covers), for a polygon O(beams x vertices).
  void add(const Obstacle& obstacle);

  /// By beam, from port to starboard.
  std::span<const double> ranges() const { return ranges_; }

  /// The bearing of the middle of a beam [rad], 0 ahead, positive to starboard.
  double bearing(std::size_t beam) const {
    return (static_cast<double>(beam) + 0.5) * spacing_ - half_field_;
  }
  double spacing() const { return spacing_; }  ///< between beams [rad]

  /// Beams from `first` up to and without `end`.
  struct Beams {
    std::size_t first;
    std::size_t end;
  };
  /// Those whose bearing lies between two [rad].
  Beams beams_between(double low, double high) const;

 private:
  void add_segment(const Vec3& from, const Vec3& to);
  void add_wall(const Vec2& from, const Vec2& to);
  void hear(std::size_t beam, double range);

  double half_field_;
  double half_aperture_;
  double tan_aperture_;
  double max_range_;
  double spacing_;
  std::vector<Vec2> bearings_b_;  // of each beam a unit vector in the plane of the hull
  std::vector<Vec2> bearings_n_;  // their horizontal parts
  std::vector<double> ranges_;
  Vec3 origin_ = Vec3::Zero();
  Eigen::Quaterniond q_bn_ = Eigen::Quaterniond::Identity();
  Vec2 down_n_ = Vec2::Zero();  // horizontal part of the hull's own down
};

}  // namespace fairway
