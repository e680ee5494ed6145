// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/headway.hpp"

#include <algorithm>

#include "fairway/avoidance/pledge/following.hpp"

namespace fairway::pledge {
namespace {

constexpr double stride = 0.1;      // between two times that are tried, at least [s]
constexpr double in_current = 2.0;  // times as much headway is wanted

/// The fastest that anybody goes who goes by it, in water that moves so [m/s].
double fastest(const Reference& reference, const Vec3& drift) noexcept {
  double most = drift.norm();  // while it is held
  const std::span<const Knot> all = reference.knots();
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Vec3 velocity = (all[i].position - all[i - 1].position) / (all[i].time - all[i - 1].time);
    most = std::max(most, (velocity - drift).norm());
  }
  return most;
}

}  // namespace

Headway headway_in(const Vec3& current, double still) noexcept {
  return {current.norm() > noticed_current ? in_current * still : still, current};
}

double headway_of(const Reference& a, const Reference& b, double apart, const Headway& wanted) noexcept {
  if (a.knots().size() < 2) return wanted.aim;  // who is held is not under way
  const double begins = a.knots().front().time, ends = a.end();
  const double speed = fastest(b, wanted.drift);
  double after = 0.0;
  while (after < wanted.aim) {
    const Reference stopped = a.moved(after, after * wanted.drift);
    const double off = least_distance(stopped, b, begins + after, ends + after) - apart;
    if (off <= 0.0) return after;
    after += speed > 0.0 ? std::max(off / speed, stride) : wanted.aim;
  }
  return wanted.aim;
}

double headway_of(std::size_t member, const Reference& reference, const Clearance& scene,
                  const Members& others, const Headway& wanted) noexcept {
  Headway least = wanted;
  for (std::size_t other = 0; other < most_members; ++other) {
    if (other == member || !scene.placed()[other] || !others[other]) continue;
    const double apart = scene.beside(member, other);
    least.aim = headway_of(reference, scene.reference(other), apart, least);
    least.aim = headway_of(scene.reference(other), reference, apart, least);
  }
  return least.aim;
}

double headway_of(const Clearance& scene, const Members& some, const Members& others,
                  const Headway& wanted) noexcept {
  Headway least = wanted;
  Members rest = others;
  for (std::size_t i = 0; i < most_members; ++i) {
    if (!some[i] || !scene.placed()[i]) continue;
    rest.reset(i);
    least.aim = headway_of(i, scene.reference(i), scene, rest, least);
  }
  return least.aim;
}

}  // namespace fairway::pledge
