// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoider.hpp"

#include <algorithm>

namespace fairway {

Vec3 Avoider::within(const Situation& s, Vec3 v) noexcept {
  const Limits& limits = s.limits;
  v = clamp_norm(v, limits.max_speed);
  v.z() = std::max(-limits.max_climb_rate, std::min(limits.max_climb_rate, v.z()));

  // outside the depth band the way back stays open
  const double depth = s.own.position.z();
  const double slowest = std::min(0.0, (limits.min_depth - depth) / s.period);
  const double fastest = std::max(0.0, (limits.max_depth - depth) / s.period);
  v.z() = std::max(slowest, std::min(fastest, v.z()));
  return v;
}

}  // namespace fairway
