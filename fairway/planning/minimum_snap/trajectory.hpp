// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fairway/planning/minimum_snap/bezier.hpp"
#include "fairway/planning/planar_map.hpp"

namespace fairway {

/// Where a trajectory is at one time, and its first four derivatives in physical time [m, m/s, .. m/s4, NE].
struct TrajectorySample {
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  Vec2 acceleration = Vec2::Zero();
  Vec2 jerk = Vec2::Zero();
  Vec2 snap = Vec2::Zero();
};

/// A path in time: polynomials of degree 7 one after the other, each in its normalised time s = 0 .. 1
/// (rehman2021, eq. 19). A value. Times count from 0 at its start; before that it rests at its start, after
/// its duration at its end.
class Trajectory {
 public:
  using Coefficients = Eigen::Matrix<double, 2, 8>;  ///< of s^0 .. s^7, north and east [m]

  struct Segment {
    Coefficients coefficients = Coefficients::Zero();
    double duration{};  ///< [s], > 0
  };

  /// At rest at the origin, or at `position`, for no time.
  Trajectory() = default;
  explicit Trajectory(const Vec2& position) : resting_{position} {}

  /// At least one segment, each with a positive duration. Throws InputError otherwise.
  explicit Trajectory(std::vector<Segment> segments);

  double duration() const noexcept { return segments_.empty() ? 0.0 : ends_.back(); }
  std::span<const Segment> segments() const noexcept { return segments_; }

  /// O(log segments). At a knot the segment that begins there answers.
  TrajectorySample sample(double time) const noexcept;

  /// The derivative of `order` 0 .. 7 of one segment at its normalised time s, in physical time.
  Vec2 derivative(std::size_t segment, int order, double s) const noexcept;

  /// The same derivative all along the segment, as a curve over s.
  Bezier curve(std::size_t segment, int order = 0) const noexcept;

  /// Greatest speed [m/s] and acceleration [m/s2]: never less than the true one, and at most a millionth
  /// more.
  double peak_speed() const noexcept { return peak(1); }
  double peak_acceleration() const noexcept { return peak(2); }

  /// Integral of the squared norm of the snap [m2/s7].
  double snap_integral() const noexcept;

  /// Length of the way along one segment, or along all [m], by Simpson's rule on 64 pieces of each.
  double length(std::size_t segment) const noexcept;
  double length() const noexcept;

  /// The same way in `factor` > 0 times the time: speeds are divided by it, accelerations by its square.
  Trajectory slowed(double factor) const;

 private:
  double peak(int order) const noexcept;

  std::vector<Segment> segments_;
  std::vector<double> ends_;  // time at which each segment ends [s]
  Vec2 resting_ = Vec2::Zero();
};

}  // namespace fairway
