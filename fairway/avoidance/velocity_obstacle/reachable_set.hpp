// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/velocity_obstacle/boundary.hpp"

namespace fairway::velocity_obstacle {

/// RV, the velocities that own ship can have made its own after an interval (cao2022, eq. 3): no faster than
/// the speed limit, within acceleration x interval of the present velocity, and, where turns are limited, on
/// a course within turn rate x interval of the heading. A vehicle that cannot stop goes no slower than its
/// least speed, and one that has no sternway either not abaft its beam. A limit that is not set does not
/// bind. What it makes beyond that by itself, too fast or too slow, or across or against its heading, counts
/// as the nearest velocity that obeys; so the set is never empty, and standing still is in it for who can
/// stop, as far as the acceleration allows.
class ReachableSet {
 public:
  ReachableSet(const Ownship& own, const Limits& limits, double interval) noexcept;

  /// With `slack` [m/s] to every side. O(1).
  bool contains(const Vec2& v, double slack) const noexcept;

  /// A part of a line that holds all of it that is in the set with that slack [m/s]. O(1).
  Stretch stretch(const Boundary& line, double slack) const noexcept;

  static constexpr std::size_t max_boundaries = 6;
  std::size_t boundaries(std::span<Boundary, max_boundaries> out) const noexcept;

  /// The present velocity, or what it counts as [m/s].
  const Vec2& middle() const { return middle_; }
  /// Unit; the way it points.
  const Vec2& bow() const { return bow_; }
  double max_speed() const { return max_speed_; }
  /// The largest change of the velocity within the interval [m/s].
  double max_change() const { return max_change_; }

 private:
  bool is_within_turn(const Vec2& v, double slack) const noexcept;
  bool makes_way(const Vec2& v, double slack) const noexcept;

  Vec2 bow_;
  double max_speed_;
  double min_speed_;
  double max_change_;
  double turn_cosine_ = -1.0;
  double turn_sine_ = 0.0;
  bool turns_freely_;
  bool only_ahead_;
  Vec2 middle_;
};

}  // namespace fairway::velocity_obstacle
