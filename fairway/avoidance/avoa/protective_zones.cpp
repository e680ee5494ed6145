// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/protective_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fairway::avoa {
namespace {

/// An interval of relative velocities to starboard in one row [m/s]; empty unless lo <= hi.
struct Interval {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();

  bool empty() const { return !(lo <= hi); }
};

constexpr Interval nothing{1.0, -1.0};

/// Relative velocities w with normal . w >= offset.
struct HalfPlane {
  Vec2 normal = Vec2::UnitX();
  double offset = 0.0;

  /// The part of `row` where it holds, in the row at `ahead`.
  Interval cut(Interval row, double ahead) const {
    const double left = offset - normal.x() * ahead;
    if (normal.y() > 0.0) return {std::max(row.lo, left / normal.y()), row.hi};
    if (normal.y() < 0.0) return {row.lo, std::min(row.hi, left / normal.y())};
    return left <= 0.0 ? row : nothing;
  }
};

/// The part of a disc's row at `ahead` from its centre.
Interval chord(double radius, double ahead) {
  const double squared = radius * radius - ahead * ahead;
  if (!(squared >= 0.0)) return nothing;
  const double half = std::sqrt(squared);
  return {-half, half};
}

Interval moved(const Interval& interval, double by) { return {interval.lo + by, interval.hi + by}; }

/// The smallest interval that has both.
Interval hull(const Interval& a, const Interval& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

/// A column as a whole number in 0 .. side, where `column` may be anything.
int whole_column(double column, int side) {
  if (!(column > 0.0)) return 0;
  return column < side ? static_cast<int>(column) : side;
}

/// The relative velocities whose ray meets a disc, seen from a point outside of it.
struct Cone {
  Cone(const Vec2& centre, double distance, double radius) {
    const Vec2 axis = centre / distance;
    const double sine = radius / distance;
    const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
    const Vec2 across{-axis.y(), axis.x()};
    sides[0].normal = sine * axis + cosine * across;
    sides[1].normal = sine * axis - cosine * across;
  }

  Interval row(double ahead) const { return sides[1].cut(sides[0].cut({}, ahead), ahead); }

  HalfPlane sides[2];
};

}  // namespace

void ProtectiveZones::clear(const VelocityGrid& grid) {
  grid_ = grid;
  forbidden_.assign(static_cast<std::size_t>(grid.cell_count()), 0);
  empty_ = true;
}

void ProtectiveZones::forbid(int row, int from, int to) {
  if (from >= to) return;
  const auto begin = forbidden_.begin() + static_cast<std::ptrdiff_t>(row) * grid_.side();
  std::fill(begin + from, begin + to, std::uint8_t{1});
  empty_ = false;
}

void ProtectiveZones::add(const MovingDisc& disc, double window, TimeToContact contact) {
  const int side = grid_.side();
  const double distance = disc.position.norm();
  const double gap = distance - disc.radius;

  // columns of the row that lie within an interval of relative velocities, its ends too
  const auto first = [&](double lo) {
    return whole_column(std::ceil(grid_.column_of(lo + disc.velocity.y())), side);
  };
  const auto beyond = [&](double hi) {
    return whole_column(std::floor(grid_.column_of(hi + disc.velocity.y())) + 1.0, side);
  };

  // inside: only what leads further in, without the boundary
  if (gap <= 0.0) {
    const Vec2 inward = distance > 0.0 ? disc.position : disc.inward;
    const HalfPlane allowed{-inward};
    for (int row = 0; row < side; ++row) {
      const Interval out = allowed.cut({}, grid_.ahead(row) - disc.velocity.x());
      if (out.empty()) {
        forbid(row, 0, side);
      } else {
        forbid(row, 0, first(out.lo));
        forbid(row, beyond(out.hi), side);
      }
    }
    return;
  }

  // nothing in the picture comes near fast enough
  const double slow = gap / window;
  if (slow >= std::numbers::sqrt2 * grid_.reach() + disc.velocity.norm()) return;

  const Cone cone{disc.position, distance, disc.radius};
  if (contact == TimeToContact::bound) {
    for (int row = 0; row < side; ++row) {
      const double ahead = grid_.ahead(row) - disc.velocity.x();
      const Interval collision = cone.row(ahead);
      if (collision.empty()) continue;

      // of the cone, what is not in the disc of the slow ones round its apex
      const Interval not_imminent = chord(slow, ahead);
      const int from = first(collision.lo);
      const int to = beyond(collision.hi);
      if (not_imminent.empty()) {
        forbid(row, from, to);
      } else {
        forbid(row, from, std::min(to, first(not_imminent.lo)));
        forbid(row, std::max(from, beyond(not_imminent.hi)), to);
      }
    }
    return;
  }

  // contact at the window's end is the disc shrunk by the window; before it, the cone from that disc's
  // tangent points on. The two together are convex.
  const Vec2 centre = disc.position / window;
  const HalfPlane from_tangents{disc.position / distance,
                                gap * (distance + disc.radius) / (distance * window)};
  for (int row = 0; row < side; ++row) {
    const double ahead = grid_.ahead(row) - disc.velocity.x();
    const Interval last = moved(chord(disc.radius / window, ahead - centre.x()), centre.y());
    const Interval collision = hull(last, from_tangents.cut(cone.row(ahead), ahead));
    if (!collision.empty()) forbid(row, first(collision.lo), beyond(collision.hi));
  }
}

}  // namespace fairway::avoa
