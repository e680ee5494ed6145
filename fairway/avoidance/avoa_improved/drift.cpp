// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/drift.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway::avoa_improved {

void Drift::observe(const Vec2& velocity, const Vec2& ahead, const VesselResponse& helm, double period,
                    double settling) noexcept {
  if (!is_known_) {
    is_known_ = true;
    speed_ = commanded_ = velocity.dot(ahead);
    drift_ = velocity - speed_ * ahead;
    return;
  }
  speed_ = helm.speed_after(speed_, commanded_, period, helm.share(period));
  drift_ += (1.0 - math::exp(-period / settling)) * (velocity - speed_ * ahead - drift_);
}

double crab_angle(const Vec2& direction, const Vec2& drift, double speed) noexcept {
  const double to_starboard = direction.x() * drift.y() - direction.y() * drift.x();
  return speed > 0.0 ? -math::asin(std::clamp(to_starboard / speed, -1.0, 1.0)) : 0.0;
}

}  // namespace fairway::avoa_improved
