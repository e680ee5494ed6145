// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/velocity_obstacle.hpp"

#include <algorithm>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::velocity_obstacle {
namespace {

/// Below this sine two directions are one.
constexpr double in_line = 1e-9;

/// Unit, along them.
struct Tangents {
  Vec2 port, starboard;
};

/// From the origin to a disc round `p` [m], more than `radius` away: at the half angle arcsin(R / d) to both
/// sides.
Tangents tangents_to_disc(const Vec2& p, double radius) {
  const double d = p.norm();
  const double sine = radius / d;
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  const Vec2 middle = p / d;
  return {turned(middle, cosine, -sine), turned(middle, cosine, sine)};
}

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
      apex_{solid.velocity},
      drift_{solid.velocity},
      radius_{solid.radius},
      inverse_horizon_{1.0 / outlook.horizon},
      inverse_interval_{1.0 / outlook.interval},
      gain_{1.0},
      is_disc_{from_ == to_} {
  const Vec2 p = nearest_on_segment(from_, to_, Vec2::Zero());
  const double d = p.norm();
  overlaps_ = solid.within || d <= radius_ * (1.0 + in_line);
  if (overlaps_) {
    away_ = d > 0.0 ? Vec2{(solid.within ? 1.0 : -1.0) / d * p} : solid.parting;
    rate_ = (solid.within ? radius_ + d : std::max(radius_ - d, 0.0)) * inverse_interval_;
    return;
  }

  const Tangents to_from = tangents_to_disc(from_, radius_);
  port_ = to_from.port;
  starboard_ = to_from.starboard;
  if (is_disc_) return;

  // the outermost of those to the ends
  const Tangents to_to = tangents_to_disc(to_, radius_);
  if (cross(port_, to_to.port) < 0.0) port_ = to_to.port;
  if (cross(starboard_, to_to.starboard) > 0.0) starboard_ = to_to.starboard;
}

VelocityObstacle VelocityObstacle::reciprocal(const RelativeCapsule& solid, const Vec2& own_velocity,
                                              const Horizons& outlook) noexcept {
  VelocityObstacle obstacle(solid, outlook);
  obstacle.apex_ = 0.5 * (own_velocity + solid.velocity);
  obstacle.inverse_horizon_ *= 0.5;
  obstacle.rate_ *= 0.5;
  obstacle.gain_ = 2.0;
  obstacle.drift_ = own_velocity + solid.velocity;
  return obstacle;
}

VelocityObstacle VelocityObstacle::hybrid(const RelativeCapsule& solid, const Vec2& own_velocity,
                                          const Horizons& outlook) noexcept {
  VelocityObstacle obstacle = reciprocal(solid, own_velocity, outlook);
  if (obstacle.overlaps_ || cross(obstacle.port_, obstacle.starboard_) <= in_line) return obstacle;

  // from the apex of VO to that of RVO, along the legs: e = a other + b kept
  const Vec2& p = solid.from;
  const Vec2 e = obstacle.apex_ - solid.velocity;
  const bool passes_to_starboard = cross(p, e) >= -in_line * p.norm() * e.norm();
  const Vec2& kept = passes_to_starboard ? obstacle.starboard_ : obstacle.port_;
  const Vec2& other = passes_to_starboard ? obstacle.port_ : obstacle.starboard_;
  const double b = cross(other, e) / cross(other, kept);

  // so the legs meet at b before the apex of RVO, whose leg is cut off where it was
  const double tangent = std::sqrt(p.squaredNorm() - solid.radius * solid.radius);
  obstacle.apex_ -= b * kept;
  obstacle.inverse_horizon_ = std::max(obstacle.inverse_horizon_ + b / tangent, 0.0);
  return obstacle;
}

double VelocityObstacle::depth(const Vec2& v) const noexcept {
  const Vec2 w = v - apex_;
  if (overlaps_) return rate_ - w.dot(away_);

  // before the cut: the nearest of what is left of the cone is where the solid looks at us
  const Vec2 out = w - (is_disc_ ? near_end() : nearest_on_segment(near_end(), far_end(), w));
  if (out.dot(port_) <= 0.0 && out.dot(starboard_) <= 0.0) return radius_ * inverse_horizon_ - out.norm();
  return std::min(cross(port_, w), cross(w, starboard_));
}

Stretch VelocityObstacle::stretch(const Boundary& line, double margin) const noexcept {
  const Vec2 w = line.point - apex_;
  const Vec2& d = line.direction;
  Stretch stretch;
  if (overlaps_) {
    stretch.keep_positive(rate_ - w.dot(away_) - margin, -d.dot(away_));
    return stretch;
  }

  // between the legs, beyond where the cut touches them
  stretch.keep_positive(cross(port_, w) - margin, cross(port_, d));
  stretch.keep_positive(cross(w, starboard_) - margin, cross(d, starboard_));
  if (stretch.is_empty()) return stretch;
  const double radius = radius_ * inverse_horizon_;
  const Vec2 near = near_end();
  if (is_disc_) {
    const double tangent2 = near.squaredNorm() - radius * radius;
    if (tangent2 > 0.0) stretch.keep_positive(w.dot(near) - tangent2 - margin * near.norm(), d.dot(near));
    Stretch cut;
    cut.keep_disc({line.point - apex_, d, 0.0}, near, radius - margin);
    if (cut.is_empty()) return stretch;
    if (stretch.is_empty()) return cut;
    return {std::min(cut.from, stretch.from), std::max(cut.to, stretch.to)};
  }
  const Vec2 along = port_ + starboard_;
  const double cut = std::max(near.dot(along), far_end().dot(along));
  stretch.keep_positive(w.dot(along) - cut - margin, d.dot(along));
  return stretch;
}

bool VelocityObstacle::holds_disc(const Vec2& centre, double radius) const noexcept {
  if (depth(centre) <= radius) return false;
  if (overlaps_ || is_disc_) return true;
  const Vec2 along = port_ + starboard_;
  const double cut = std::max(near_end().dot(along), far_end().dot(along));
  return (centre - apex_).dot(along) - cut > radius * along.norm();
}

double VelocityObstacle::urgency(const Vec2& v) const noexcept {
  const Vec2 w = gain_ * v - drift_;
  if (overlaps_) {
    const double missing = gain_ * rate_ - w.dot(away_);
    return missing > 0.0 ? inverse_interval_ + missing / std::max(radius_, in_line) : 0.0;
  }
  const double at_from = urgency_of_disc(from_, radius_, w);
  if (is_disc_) return at_from;
  return std::max({at_from, urgency_of_disc(to_, radius_, w), urgency_of_side(from_, to_, radius_, w)});
}

std::size_t VelocityObstacle::boundaries(std::span<Boundary, max_boundaries> out) const noexcept {
  if (overlaps_) {
    out[0] = Boundary::line(apex_ + rate_ * away_, starboard_of(away_));
    return 1;
  }
  const double radius = radius_ * inverse_horizon_;
  out[0] = Boundary::line(apex_, port_);
  out[1] = Boundary::line(apex_, starboard_);
  out[2] = Boundary::circle(apex_ + near_end(), radius);
  if (is_disc_) return 3;

  out[3] = Boundary::circle(apex_ + far_end(), radius);
  const Vec2 normal = facing(from_, to_);
  if (normal == Vec2::Zero()) return 4;
  out[4] = Boundary::line(apex_ + near_end() + radius * normal, starboard_of(normal));
  return 5;
}

Outline VelocityObstacle::outline(double reach) const noexcept {
  Outline outline;
  if (overlaps_) {
    const Vec2 middle = apex_ + rate_ * away_;
    const Vec2 along = reach * starboard_of(away_);
    const Vec2 inwards = -2.0 * reach * away_;
    for (const Vec2& corner : {Vec2{middle - along + inwards}, Vec2{middle - along}, Vec2{middle + along},
                               Vec2{middle + along + inwards}}) {
      outline.add(corner);
    }
    return outline;
  }

  // a leg begins where the cut touches it
  const double port = std::max(near_end().dot(port_), far_end().dot(port_));
  const double starboard = std::max(near_end().dot(starboard_), far_end().dot(starboard_));
  outline.add(apex_ + (port + reach) * port_);

  // the points of the cut by its normals, turned from the one leg's by way of the apex to the other's
  const Vec2 first = -starboard_of(port_);
  const double between = math::atan2(cross(port_, starboard_), port_.dot(starboard_));
  const double radius = radius_ * inverse_horizon_;
  for (std::size_t i = 0; i < Outline::cut_points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(Outline::cut_points - 1);
    const double angle = -share * (pi - between);
    const Vec2 normal = fairway::turned(first, angle);
    const Vec2 end = near_end().dot(normal) > far_end().dot(normal) ? near_end() : far_end();
    outline.add(apex_ + end + radius * normal);
  }
  outline.add(apex_ + (starboard + reach) * starboard_);
  return outline;
}

}  // namespace fairway::velocity_obstacle
