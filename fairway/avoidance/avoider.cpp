// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoider.hpp"

#include <cmath>

namespace fairway {

Vec3 Avoider::within(const Situation& s, Vec3 v) noexcept {
  const Limits& limits = s.limits;
  v = clamp_norm(v, limits.max_speed);
  v.z() = std::fmax(-limits.max_climb_rate, std::fmin(limits.max_climb_rate, v.z()));

  // outside the depth band the way back stays open
  const double depth = s.own.position.z();
  const double slowest = std::fmin(0.0, (limits.min_depth - depth) / s.period);
  const double fastest = std::fmax(0.0, (limits.max_depth - depth) / s.period);
  v.z() = std::fmax(slowest, std::fmin(fastest, v.z()));
  return v;
}

}  // namespace fairway
