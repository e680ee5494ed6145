// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/safety_filter/barrier.hpp"

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// Nearer than this in the plane, the direction away from the centre means nothing [m].
constexpr double least_level = 1e-3;

/// psi_1 below this share of what it is made of is not rounding, nor the error of holding an acceleration
/// from one decision to the next.
constexpr double late = 0.02;

double squared(double x) { return x * x; }

}  // namespace

Barrier barrier(const Hazard& hazard, const Ownship& own, const BarrierGains& gains) noexcept {
  const Vec3 delta = own.position - hazard.centre;
  const Vec3 w = own.velocity - hazard.velocity;
  const double radius = own.radius + hazard.radius + gains.margin;
  const double h = delta.squaredNorm() - radius * radius;
  const double h_rate = 2.0 * delta.dot(w);

  // 2 Delta . a >= demand, along the level part of Delta
  const double distance = delta.norm();
  const double speed2 =
      hazard.is_flat ? squared(h_rate / (2.0 * math::fmax(distance, least_level))) : w.squaredNorm();
  const double demand = -(2.0 * speed2 + (gains.k1 + gains.k2) * h_rate + gains.k1 * gains.k2 * h);
  const double level = horizontal_norm(delta);
  const Vec2 normal = level > least_level ? Vec2{delta.head<2>() / level} : Vec2{hazard.parting.head<2>()};
  const double per_level = 1.0 / math::fmax(level, least_level);
  const double share = hazard.reacts ? 0.25 : 0.5;
  const double psi1 = h_rate + gains.k1 * h;
  double offset = share * demand * per_level;
  if (gains.response > 0.0) offset = math::fmax(offset, -share * psi1 * per_level / gains.response);

  const bool is_late = psi1 < -late * std::abs(h_rate);
  if (is_late && distance > radius) {
    const double closing = -h_rate / (2.0 * distance);
    offset = math::fmax(offset, closing * closing / (2.0 * (distance - radius)) * distance * per_level);
  }
  return {{normal, offset}, is_late};
}

}  // namespace fairway
