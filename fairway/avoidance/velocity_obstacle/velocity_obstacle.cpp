// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/velocity_obstacle.hpp"

#include <algorithm>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/segments.hpp"

namespace fairway::velocity_obstacle {
namespace {

/// When something at `w` meets the disc: 1 / t, or 0.
double urgency_of_disc(const Vec2& p, double radius, const Vec2& w) {
  const double closing = w.dot(p);
  const double gap2 = p.squaredNorm() - radius * radius;
  const double root2 = closing * closing - w.squaredNorm() * gap2;
  if (closing <= 0.0 || root2 <= 0.0) return 0.0;
  return (closing + std::sqrt(root2)) / gap2;
}

/// Across a wall, unit, towards the origin; zero for a disc, or if the origin lies in its line.
Vec2 facing(const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double across = cross(along, from);
  if (std::fabs(across) <= in_line * along.norm() * from.norm()) return Vec2::Zero();
  return std::copysign(1.0 / along.norm(), -across) * starboard_of(along);
}

/// The same for the straight side of a wall.
double urgency_of_side(const Vec2& from, const Vec2& to, double radius, const Vec2& w) {
  const Vec2 normal = facing(from, to);
  const double closing = -normal.dot(w);
  if (closing <= 0.0) return 0.0;
  const double gap = -normal.dot(from) - radius;
  const Vec2 along = to - from;
  const double place = along.dot(gap / closing * w - from);
  return place < 0.0 || place > along.squaredNorm() ? 0.0 : closing / gap;
}

}  // namespace

VelocityObstacle::VelocityObstacle(const RelativeCapsule& solid, const Horizons& outlook) noexcept
    : from_{solid.from},
      to_{solid.to},
      drift_{solid.velocity},
      radius_{solid.radius},
      inverse_interval_{1.0 / outlook.interval},
      gain_{1.0} {
  cone_.is_disc = from_ == to_;
  begin_at({solid.velocity.x(), solid.velocity.y(), 1.0 / outlook.horizon});
  const Vec2 p = nearest_on_segment<Vec2>(from_, to_, Vec2::Zero());
  const double d = p.norm();
  cone_.overlaps = solid.within || d <= radius_ * (1.0 + in_line);
  if (cone_.overlaps) {
    overlap(d > 0.0 ? Vec2{(solid.within ? 1.0 : -1.0) / d * p} : solid.parting,
            solid.within ? radius_ + d : std::max(radius_ - d, 0.0));
    return;
  }

  Legs<double> legs = legs_to_disc(from_.x(), from_.y(), from_.norm(), radius_);
  if (!cone_.is_disc) {
    // the outermost of those to the ends
    const Legs<double> to = legs_to_disc(to_.x(), to_.y(), to_.norm(), radius_);
    if (legs.port_north * to.port_east - legs.port_east * to.port_north < 0.0) {
      legs.port_north = to.port_north;
      legs.port_east = to.port_east;
    }
    if (legs.starboard_north * to.starboard_east - legs.starboard_east * to.starboard_north > 0.0) {
      legs.starboard_north = to.starboard_north;
      legs.starboard_east = to.starboard_east;
    }
  }
  take(legs);
}

VelocityObstacle::VelocityObstacle(const Discs& made, std::size_t at, const Vec2& parting) noexcept
    : from_{made.north[at], made.east[at]},
      to_{from_},
      drift_{made.velocity_north[at], made.velocity_east[at]},
      radius_{made.radius[at]},
      inverse_interval_{made.inverse_interval},
      gain_{1.0} {
  cone_.is_disc = true;
  begin_at({made.apex_north[at], made.apex_east[at], made.cut[at]});
  cone_.overlaps = made.overlaps[at] != 0.0;
  if (cone_.overlaps) {
    const double d = made.distance[at];
    overlap(d > 0.0 ? Vec2{-1.0 / d * from_} : parting, std::max(radius_ - d, 0.0));
  } else {
    take({made.port_north[at], made.port_east[at], made.starboard_north[at], made.starboard_east[at]});
  }
  if (made.shares[at] != 0.0) share({made.own_north, made.own_east});
}

VelocityObstacle VelocityObstacle::reciprocal(const RelativeCapsule& solid, const Vec2& own_velocity,
                                              const Horizons& outlook) noexcept {
  VelocityObstacle obstacle(solid, outlook);
  const Vec2 apex = 0.5 * (own_velocity + solid.velocity);
  obstacle.begin_at({apex.x(), apex.y(), 0.5 * obstacle.inverse_horizon_});
  obstacle.share(own_velocity);
  return obstacle;
}

VelocityObstacle VelocityObstacle::hybrid(const RelativeCapsule& solid, const Vec2& own_velocity,
                                          const Horizons& outlook) noexcept {
  VelocityObstacle obstacle = reciprocal(solid, own_velocity, outlook);
  const Cone& cone = obstacle.cone_;
  if (cone.overlaps || cross(obstacle.port_leg(), obstacle.starboard_leg()) <= in_line) return obstacle;
  obstacle.begin_at(hybrid_apex<double>(
      solid.from.x(), solid.from.y(), solid.radius,
      {cone.port_north, cone.port_east, cone.starboard_north, cone.starboard_east}, solid.velocity.x(),
      solid.velocity.y(), {cone.apex_north, cone.apex_east, obstacle.inverse_horizon_}));
  return obstacle;
}

void VelocityObstacle::begin_at(const Apex<double>& apex) noexcept {
  cone_.apex_north = apex.north;
  cone_.apex_east = apex.east;
  inverse_horizon_ = apex.inverse_horizon;
  cone_.near_north = inverse_horizon_ * from_.x();
  cone_.near_east = inverse_horizon_ * from_.y();
  cone_.far_north = inverse_horizon_ * to_.x();
  cone_.far_east = inverse_horizon_ * to_.y();
  cone_.radius = radius_ * inverse_horizon_;
}

void VelocityObstacle::take(const Legs<double>& legs) noexcept {
  cone_.port_north = legs.port_north;
  cone_.port_east = legs.port_east;
  cone_.starboard_north = legs.starboard_north;
  cone_.starboard_east = legs.starboard_east;
}

void VelocityObstacle::overlap(const Vec2& away, double depth) noexcept {
  cone_.away_north = away.x();
  cone_.away_east = away.y();
  cone_.rate = depth * inverse_interval_;
}

void VelocityObstacle::share(const Vec2& own_velocity) noexcept {
  gain_ = 2.0;
  drift_ += own_velocity;
  if (cone_.overlaps) cone_.rate *= 0.5;
}

double VelocityObstacle::depth(const Vec2& v) const noexcept { return depth_in<double>(cone_, v.x(), v.y()); }

Stretch VelocityObstacle::stretch(const Boundary& line, double margin) const noexcept {
  const Vec2 w = line.point - apex();
  const Vec2& d = line.direction;
  Stretch stretch;
  if (cone_.overlaps) {
    stretch.keep_positive(cone_.rate - w.dot(away()) - margin, -d.dot(away()));
    return stretch;
  }

  // between the legs, beyond where the cut touches them
  stretch.keep_positive(cross(port_leg(), w) - margin, cross(port_leg(), d));
  stretch.keep_positive(cross(w, starboard_leg()) - margin, cross(d, starboard_leg()));
  if (stretch.is_empty()) return stretch;
  const double radius = cone_.radius;
  const Vec2 near = near_end();
  if (cone_.is_disc) {
    const double tangent2 = near.squaredNorm() - radius * radius;
    if (tangent2 > 0.0) stretch.keep_positive(w.dot(near) - tangent2 - margin * near.norm(), d.dot(near));
    Stretch cut;
    cut.keep_disc({line.point - apex(), d, 0.0}, near, radius - margin);
    if (cut.is_empty()) return stretch;
    if (stretch.is_empty()) return cut;
    return {std::min(cut.from, stretch.from), std::max(cut.to, stretch.to)};
  }
  const Vec2 along = port_leg() + starboard_leg();
  const double cut = std::max(near.dot(along), far_end().dot(along));
  stretch.keep_positive(w.dot(along) - cut - margin, d.dot(along));
  return stretch;
}

bool VelocityObstacle::holds_disc(const Vec2& centre, double radius) const noexcept {
  if (depth(centre) <= radius) return false;
  if (cone_.overlaps || cone_.is_disc) return true;
  const Vec2 along = port_leg() + starboard_leg();
  const double cut = std::max(near_end().dot(along), far_end().dot(along));
  return (centre - apex()).dot(along) - cut > radius * along.norm();
}

double VelocityObstacle::urgency(const Vec2& v) const noexcept {
  const Vec2 w = gain_ * v - drift_;
  if (cone_.overlaps) {
    const double missing = gain_ * cone_.rate - w.dot(away());
    return missing > 0.0 ? inverse_interval_ + missing / std::max(radius_, in_line) : 0.0;
  }
  const double at_from = urgency_of_disc(from_, radius_, w);
  if (cone_.is_disc) return at_from;
  return std::max({at_from, urgency_of_disc(to_, radius_, w), urgency_of_side(from_, to_, radius_, w)});
}

std::size_t VelocityObstacle::boundaries(std::span<Boundary, max_boundaries> out) const noexcept {
  if (cone_.overlaps) {
    out[0] = Boundary::line(apex() + cone_.rate * away(), starboard_of(away()));
    return 1;
  }
  const double radius = cone_.radius;
  out[0] = Boundary::line(apex(), port_leg());
  out[1] = Boundary::line(apex(), starboard_leg());
  out[2] = Boundary::circle(apex() + near_end(), radius);
  if (cone_.is_disc) return 3;

  out[3] = Boundary::circle(apex() + far_end(), radius);
  const Vec2 normal = facing(from_, to_);
  if (normal == Vec2::Zero()) return 4;
  out[4] = Boundary::line(apex() + near_end() + radius * normal, starboard_of(normal));
  return 5;
}

Outline VelocityObstacle::outline(double reach) const noexcept {
  Outline outline;
  if (cone_.overlaps) {
    const Vec2 middle = apex() + cone_.rate * away();
    const Vec2 along = reach * starboard_of(away());
    const Vec2 inwards = -2.0 * reach * away();
    for (const Vec2& corner : {Vec2{middle - along + inwards}, Vec2{middle - along}, Vec2{middle + along},
                               Vec2{middle + along + inwards}}) {
      outline.add(corner);
    }
    return outline;
  }

  // a leg begins where the cut touches it
  const double port = std::max(near_end().dot(port_leg()), far_end().dot(port_leg()));
  const double starboard = std::max(near_end().dot(starboard_leg()), far_end().dot(starboard_leg()));
  outline.add(apex() + (port + reach) * port_leg());

  // the points of the cut by its normals, turned from the one leg's by way of the apex to the other's
  const Vec2 first = -starboard_of(port_leg());
  const double between = math::atan2(cross(port_leg(), starboard_leg()), port_leg().dot(starboard_leg()));
  const double radius = cone_.radius;
  for (std::size_t i = 0; i < Outline::cut_points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(Outline::cut_points - 1);
    const double angle = -share * (pi - between);
    const Vec2 normal = fairway::turned(first, angle);
    const Vec2 end = near_end().dot(normal) > far_end().dot(normal) ? near_end() : far_end();
    outline.add(apex() + end + radius * normal);
  }
  outline.add(apex() + (starboard + reach) * starboard_leg());
  return outline;
}

}  // namespace fairway::velocity_obstacle
