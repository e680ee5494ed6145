// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca2d/wall.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/avoidance/orca2d/cone.hpp"
#include "fairway/core/math.hpp"

namespace fairway::orca2d {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Two sides whose distances differ by less than this share are equally near; the one offered first, to
/// starboard, is taken.
constexpr double equally_near = 1e-9;

/// Positions are not known better than this share of their distance.
constexpr double position_rounding = 1e-10;

/// Where on the wall own ship is nearest to it.
struct Foot {
  Vec2 away;             ///< unit, from there towards the side from which the wall is seen
  double distance;       ///< on that side [m]
  const WallEnd* end{};  ///< null if between the ends
};

/// Unit normal on the side from which the wall is seen; zero for a post.
Vec2 front_of(const Wall& wall) {
  const Vec2 along = wall.port.p - wall.starboard.p;
  const double length = along.norm();
  return length > 0.0 ? Vec2{starboard_of(along) / -length} : Vec2{Vec2::Zero()};
}

Foot foot_of(const Wall& wall, const Vec2& front, const Vec2& parting) {
  const Vec2 along = wall.port.p - wall.starboard.p;
  const double reached = -wall.starboard.p.dot(along);
  if (reached > 0.0 && reached < along.squaredNorm()) {
    const double distance = -front.dot(wall.starboard.p);
    return {front, distance};
  }
  const WallEnd& end = reached <= 0.0 ? wall.starboard : wall.port;
  const double distance = end.p.norm();
  if (distance > 0.0) return {end.p / -distance, distance, &end};
  return {front.isZero(0.0) ? parting : front, 0.0, &end};
}

/// One side of the velocity obstacle, before it is widened: start + t along, t from `lo` to `hi`.
struct Side {
  Vec2 start;
  Vec2 along;    ///< unit
  Vec2 outward;  ///< unit normal
  double lo = 0.0;
  double hi = endless;
  bool is_ours = true;
};

/// The wall itself, one horizon away; it runs on where the next one comes towards us.
Side cut_off(const Wall& wall, const Vec2& front, double horizon) {
  const double length = (wall.port.p - wall.starboard.p).norm() / horizon;
  return {.start = wall.starboard.p / horizon,
          .along = starboard_of(front),
          .outward = front,
          .lo = wall.starboard.is_convex ? 0.0 : -endless,
          .hi = wall.port.is_convex ? length : endless};
}

/// The tangent from the origin to the disc round `end`, as a leg that starts at `end` one horizon away.
/// `hand` is 1 for the leg to starboard and -1 for the one to port.
Side tangent_leg(const WallEnd& end, double hand, const Mariner& mariner) {
  const double d2 = end.p.squaredNorm();
  const double reach = std::sqrt(math::fmax(0.0, d2 - mariner.radius * mariner.radius));
  const Vec2 along = (reach * end.p + hand * mariner.radius * starboard_of(end.p)) / d2;
  return {.start = end.p / mariner.horizon, .along = along, .outward = hand * starboard_of(along)};
}

/// The same on the hand on which another wall may follow: no leg points into that one.
Side outer_leg(const WallEnd& end, double hand, const Mariner& mariner) {
  Side tangent = tangent_leg(end, hand, mariner);
  if (hand * cross(tangent.along, end.beyond) <= 0.0) return tangent;
  return {.start = tangent.start,
          .along = end.beyond,
          .outward = hand * starboard_of(end.beyond),
          .is_ours = false};
}

/// Looks for the point of the sides that is nearest to the velocity. Widened, the boundary is as far
/// beyond it, whether the velocity is within the velocity obstacle or not.
class Nearest {
 public:
  explicit Nearest(const Vec2& velocity) : velocity_{velocity} {}

  void offer(const Side& side) {
    const double reached = (velocity_ - side.start).dot(side.along);
    const Vec2 point = side.start + std::clamp(reached, side.lo, side.hi) * side.along;
    const double distance2 = (velocity_ - point).squaredNorm();
    is_outside_ = is_outside_ || side.outward.dot(velocity_ - side.start) > 0.0;
    if (distance2 > (is_corner_ ? 1.0 : 1.0 - equally_near) * distance2_) return;
    distance2_ = distance2;
    point_ = point;
    outward_ = side.outward;
    is_corner_ = reached < side.lo || reached > side.hi;
    is_ours_ = side.is_ours || is_corner_;
  }

  /// The tangent there, `width` beyond it; nothing where the boundary is not ours.
  std::optional<HalfPlane> tangent(double width) const {
    if (!is_ours_) return std::nullopt;
    const bool is_round = is_corner_ && is_outside_ && distance2_ > 0.0;
    const Vec2 normal = is_round ? Vec2{(velocity_ - point_) / std::sqrt(distance2_)} : outward_;
    return HalfPlane{normal, normal.dot(point_) + width};
  }

 private:
  Vec2 velocity_;
  double distance2_ = endless;
  Vec2 point_ = Vec2::Zero();
  Vec2 outward_ = Vec2::Zero();
  bool is_outside_ = false;
  bool is_corner_ = false;
  bool is_ours_ = false;
};

}  // namespace

std::optional<HalfPlane> half_plane(const Wall& wall, const Mariner& mariner) noexcept {
  const Vec2 front = front_of(wall);
  const Foot foot = foot_of(wall, front, mariner.parting);

  // seen along its length, the disc round the nearer end hides the rest, unless the next wall hides that
  const bool is_end_on = foot.end != nullptr && -front.dot(wall.starboard.p) <= mariner.radius;
  if (is_end_on && !foot.end->is_convex) return std::nullopt;
  if (foot.distance <= mariner.radius)
    return HalfPlane{foot.away, (mariner.radius - foot.distance) / mariner.period};

  Nearest nearest{mariner.velocity};
  if (is_end_on) {
    const double hand = foot.end == &wall.starboard ? 1.0 : -1.0;
    nearest.offer(outer_leg(*foot.end, hand, mariner));
    nearest.offer(tangent_leg(*foot.end, -hand, mariner));
  } else {
    nearest.offer(cut_off(wall, front, mariner.horizon));
    if (wall.starboard.is_convex) nearest.offer(outer_leg(wall.starboard, 1.0, mariner));
    if (wall.port.is_convex) nearest.offer(outer_leg(wall.port, -1.0, mariner));
  }
  return nearest.tangent(mariner.radius / mariner.horizon);
}

HalfPlane way_out(const Wall& wall, const Mariner& mariner) noexcept {
  const Foot foot = foot_of(wall, front_of(wall), mariner.parting);
  if (foot.end == nullptr) return {foot.away, (mariner.radius - foot.distance) / mariner.period};
  return {-foot.away, (mariner.radius + foot.distance) / mariner.period};
}

bool covers(const HalfPlane& half_plane, const Wall& wall, const Mariner& mariner) noexcept {
  // what is forbidden at the horizon is forbidden sooner, where no velocity at all is allowed
  const double bound = mariner.horizon * math::fmin(half_plane.offset, 0.0);
  const auto is_beyond = [&](const Vec2& p) {
    return half_plane.normal.dot(p) + mariner.radius <=
           bound + position_rounding * (p.norm() + mariner.radius);
  };
  return is_beyond(wall.starboard.p) && is_beyond(wall.port.p);
}

}  // namespace fairway::orca2d
