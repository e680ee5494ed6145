// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/capsule.hpp"

#include <algorithm>
#include <ranges>

#include "fairway/core/segments.hpp"

namespace fairway::avoa_improved {
namespace {

/// From `p` to the segment from `a` to `b`; rounded otherwise than in core, and decisions rest on it.
double distance_to_axis_of(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  if (square <= 0.0) return (p - a).norm();
  const double share = std::clamp(along.dot(p - a) / square, 0.0, 1.0);
  return (p - a - share * along).norm();
}

bool is_at(const Capsule& one, const Capsule& other, double within) {
  return (one.from - other.from).norm() <= within && (one.to - other.to).norm() <= within;
}

}  // namespace

double distance_to_axis(const Capsule& solid, const Vec2& p) noexcept {
  return distance_to_axis_of(solid.from, solid.to, p);
}

double distance_to_axis(const Capsule& solid, const Vec2& p, const Vec2& q) noexcept {
  if (solid.is_disc()) return distance_to_axis_of(p, q, solid.from);
  if (cross_each_other(solid.from, solid.to, p, q)) return 0.0;
  return std::min({distance_to_axis(solid, p), distance_to_axis(solid, q),
                   distance_to_axis_of(p, q, solid.from), distance_to_axis_of(p, q, solid.to)});
}

void Capsules::add_near(const Capsule& solid, const Vec2& own) noexcept {
  const double gap = distance_to_axis(solid, own) - solid.radius;
  if (count_ == capacity && gap >= gaps_[capacity - 1]) return;
  std::size_t at = count_ < capacity ? count_++ : capacity - 1;
  for (; at > 0 && gaps_[at - 1] > gap; --at) {
    gaps_[at] = gaps_[at - 1];
    all_[at] = all_[at - 1];
  }
  gaps_[at] = gap;
  all_[at] = solid;
}

Capsules movers(const Situation& s) noexcept {
  Capsules found;
  const Vec2 own = s.own.position.head<2>();
  for (const Track& t : s.tracks) {
    const Vec2 p = t.position.head<2>();
    found.add_near({p, p, t.radius, t.velocity.head<2>()}, own);
  }
  return found;
}

void Chart::enter(const Situation& s, bool remembers, double same_place, const DepthRange& depths,
                  double kept) noexcept {
  const Vec2 own = s.own.position.head<2>();
  Capsules now;
  const auto is_in_the_way = [&](const Obstacle& o) { return depths.is_met_by(o, kept); };
  for (const Obstacle& o : s.obstacles | std::views::filter(is_in_the_way))
    for_each_solid(o, [&](const Capsule& solid) { now.add_near(solid, own); });
  if (remembers) {
    const Capsules in_sight = now;
    const auto is_seen = [&](const Capsule& old) {
      return std::ranges::any_of(in_sight.view(),
                                 [&](const Capsule& solid) { return is_at(solid, old, same_place); });
    };
    const auto is_passed = [&](const Capsule& old) {
      return std::ranges::any_of(s.obstacles, [&](const Obstacle& o) {
        const Vec2 place = o.position.head<2>();
        return !is_in_the_way(o) && is_at({place, place}, old, same_place);
      });
    };
    for (const Capsule& old : known_.view()) {
      if (!is_seen(old) && !is_passed(old)) now.add_near(old, own);
    }
  }
  known_ = now;
}

}  // namespace fairway::avoa_improved
