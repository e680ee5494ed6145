// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "fairway/avoidance/velocity_obstacle/boundary.hpp"
#include "fairway/avoidance/velocity_obstacle/cone.hpp"

namespace fairway::velocity_obstacle {

/// What is in the way, grown by the own radius, as a disc or a wall with round ends. Horizontal, relative to
/// own ship.
struct RelativeCapsule {
  Vec2 from;                     ///< one end, P_o - P_u of a disc [m]
  Vec2 to;                       ///< the other end; `from` for a disc [m]
  double radius{};               ///< R = R_u + R_o, or R_u at a wall [m]
  Vec2 velocity = Vec2::Zero();  ///< v_o [m/s]
  Vec2 parting = Vec2::UnitX();  ///< unit; where to go from exactly there
  bool within = false;           ///< own ship is inside something solid, whose nearest side this is
};

/// How long ahead a velocity must be clear.
struct Horizons {
  double horizon;   ///< T_h [s], > 0
  double interval;  ///< who overlaps is to be apart after this long [s], > 0
};

/// A closed line, on the stack.
class Outline {
 public:
  void add(const Vec2& point) { points_[count_++] = point; }
  std::span<const Vec2> view() const { return {points_.data(), count_}; }

  static constexpr std::size_t cut_points = 9;  ///< along the cut
  static constexpr std::size_t max_points = cut_points + 2;

 private:
  std::array<Vec2, max_points> points_;
  std::size_t count_ = 0;
};

/// The velocities of own ship that lead into a solid within the horizon: a cone cut off by the solid as it
/// looks after that time. Open and convex. Where own ship is within the solid: all velocities that do not
/// lead out of it within one interval.
class VelocityObstacle {
 public:
  VelocityObstacle() = default;

  /// VO: the solid keeps its velocity (cao2022, eqs. 2 and 6, cut off at T_h). Apex v_o.
  VelocityObstacle(const RelativeCapsule& solid, const Horizons& outlook) noexcept;

  /// RVO: {v' | 2 v' - v_u in VO} (cao2022, eq. 7; van den Berg, Lin, Manocha 2008, definition 5). Apex
  /// (v_u + v_o) / 2; seen from there the cut is that of twice the horizon.
  static VelocityObstacle reciprocal(const RelativeCapsule& solid, const Vec2& own_velocity,
                                     const Horizons& outlook) noexcept;

  /// HRVO (Snape, van den Berg, Guy, Manocha 2011, section IV): the leg of RVO on the side where the two
  /// pass each other if both go on as they do, the leg of VO on the other; starboard if they would meet
  /// head to head. Its cut is tangent to both legs and meets the former where RVO's does.
  static VelocityObstacle hybrid(const RelativeCapsule& solid, const Vec2& own_velocity,
                                 const Horizons& outlook) noexcept;

  /// One of these three of a disc, made side by side with others; own ship is left along `parting` by who is
  /// exactly there.
  VelocityObstacle(const Discs& made, std::size_t at, const Vec2& parting) noexcept;

  /// How far `v` is inside [m/s]: positive inside, zero on the boundary, negative outside. Of the sign
  /// everywhere; the distance to the boundary where one of its parts is nearest from both sides. O(1).
  double depth(const Vec2& v) const noexcept;
  /// What decides on that.
  const Cone& cone() const { return cone_; }

  /// A stretch of the line that is deeper than `margin` [m/s]: all of it of a disc's, less where the cut of a
  /// wall is met. O(1).
  Stretch stretch(const Boundary& line, double margin) const noexcept;

  /// Whether a disc of velocities is all inside; false too where that is not sure, next to the cut of a wall.
  bool holds_disc(const Vec2& centre, double radius) const noexcept;

  /// 1 / t of the first contact if own ship goes on at `v` (at 2 v - v_u in RVO and HRVO), 0 if there is
  /// none, and at least 1 / interval where it overlaps already and does not get apart within it. [1/s] O(1).
  double urgency(const Vec2& v) const noexcept;

  /// The lines and circles that the boundary consists of; what they have beyond it is outside, or inside.
  static constexpr std::size_t max_boundaries = 5;
  std::size_t boundaries(std::span<Boundary, max_boundaries> out) const noexcept;

  /// For pictures, closed: down the port leg from `reach` beyond where the cut touches it, round the cut to
  /// starboard, and as far up the starboard leg. Where it overlaps, a rectangle, `reach` to either side of
  /// the point of its boundary nearest to the apex and twice that deep. [m/s]
  Outline outline(double reach) const noexcept;

  Vec2 apex() const { return {cone_.apex_north, cone_.apex_east}; }
  Vec2 port_leg() const { return {cone_.port_north, cone_.port_east}; }
  Vec2 starboard_leg() const { return {cone_.starboard_north, cone_.starboard_east}; }

 private:
  Vec2 near_end() const { return {cone_.near_north, cone_.near_east}; }
  Vec2 far_end() const { return {cone_.far_north, cone_.far_east}; }
  Vec2 away() const { return {cone_.away_north, cone_.away_east}; }
  void begin_at(const Apex<double>& apex) noexcept;
  void take(const Legs<double>& legs) noexcept;
  /// Of RVO and HRVO.
  void share(const Vec2& own_velocity) noexcept;
  /// Own ship gets out of what it overlaps along `away`, by so much. [m]
  void overlap(const Vec2& away, double depth) noexcept;

  Cone cone_;
  double inverse_horizon_;  ///< of the cut, seen from the apex [1/s]
  Vec2 from_;               ///< the ends of the solid [m]
  Vec2 to_;
  Vec2 drift_;  ///< gain v - drift is what VO is asked about [m/s]
  double radius_;
  double inverse_interval_;
  double gain_;
};

}  // namespace fairway::velocity_obstacle
