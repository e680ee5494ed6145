// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::avoa {

/// A velocity of own ship as campos2019 writes it, [v, theta].
struct PolarVelocity {
  double speed{};    ///< [m/s], >= 0
  double heading{};  ///< from the bow, positive to starboard, in [-pi, pi]; 0 where there is no speed [rad]

  static PolarVelocity of(const Vec2& v) { return {v.norm(), math::atan2(v.y(), v.x())}; }
  Vec2 cartesian() const { return speed * unit_at(heading); }
};

/// wrap_angle() without its cost for what is in [-pi, pi] already.
inline double wrapped(double angle) { return std::abs(angle) <= pi ? angle : wrap_angle(angle); }

/// The picture of velocity space in which campos2019 thinks (Figs. 3 to 6): side x side velocities, evenly
/// spaced over [-reach, reach]^2 in body axes, ahead and to starboard. Seen from above with the bow up: row 0
/// is the fastest ahead, column 0 the fastest to port. Cells are numbered row by row. All of it O(1).
class VelocityGrid {
 public:
  static constexpr int outside = -1;

  VelocityGrid() = default;
  /// `side` >= 2, `reach` > 0 [m/s].
  VelocityGrid(int side, double reach)
      : side_{side}, last_{side - 1}, reach_{reach}, per_speed_{last_ / (2.0 * reach)} {}

  int side() const { return side_; }
  int cell_count() const { return side_ * side_; }
  double reach() const { return reach_; }
  double spacing() const { return 2.0 * reach_ / last_; }

  double ahead(int row) const { return reach_ * (last_ - 2 * row) / last_; }
  double starboard(int column) const { return reach_ * (2 * column - last_) / last_; }
  Vec2 velocity(int cell) const { return {ahead(cell / side_), starboard(cell % side_)}; }

  /// Where a velocity to starboard lies in units of columns, without bounds.
  double column_of(double starboard) const { return (starboard + reach_) * per_speed_; }

  /// The cell nearest to `v`, or `outside`.
  int cell_at(const Vec2& v) const {
    if (!(std::abs(v.x()) <= reach_ && std::abs(v.y()) <= reach_)) return outside;
    const double middle = 0.5 * side_;  // of the picture, in cells from the outer edges of the outermost
    const int row = static_cast<int>(middle - v.x() * per_speed_);
    const int column = static_cast<int>(middle + v.y() * per_speed_);
    return row * side_ + column;
  }

  friend bool operator==(const VelocityGrid&, const VelocityGrid&) = default;

 private:
  int side_ = 2;
  int last_ = 1;
  double reach_ = 1.0;
  double per_speed_ = 0.5;
};

}  // namespace fairway::avoa
