// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/sea/current.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {

ShearedCurrent::ShearedCurrent(const ShearedCurrentSpec& spec)
    : direction_{unit_at(spec.direction_rad)}, profile_{spec.profile} {}

ShearedCurrent::Flow ShearedCurrent::at(double depth) const noexcept {
  const auto below = std::ranges::upper_bound(profile_, depth, {}, &ProfilePoint::depth_m);
  if (below == profile_.begin()) return {profile_.front().speed_mps, 0.0};
  if (below == profile_.end()) return {profile_.back().speed_mps, 0.0};
  const ProfilePoint& above = *(below - 1);
  const double gradient = (below->speed_mps - above.speed_mps) / (below->depth_m - above.depth_m);
  return {above.speed_mps + gradient * (depth - above.depth_m), gradient};
}

GaussMarkov::GaussMarkov(double mean, double deviation, double correlation_time, Rng rng)
    : mean_{mean},
      deviation_{deviation},
      rate_{1.0 / correlation_time},
      rng_{rng},
      offset_{deviation_ * rng_.normal()} {}

void GaussMarkov::advance(double h) noexcept {
  const double kept = math::exp(-rate_ * h);
  const double fresh = std::sqrt(-math::expm1(-2.0 * rate_ * h));
  offset_ = kept * offset_ + fresh * deviation_ * rng_.normal();
}

GaussMarkovCurrent::GaussMarkovCurrent(const GaussMarkovCurrentSpec& s, const Rng& rng)
    : lowest_{s.min_speed_mps},
      highest_{s.max_speed_mps},
      speed_{s.mean_speed_mps, s.deviation_mps, s.correlation_time_s, rng.stream("speed")},
      direction_{s.direction_rad, s.direction_deviation_rad, s.direction_correlation_time_s,
                 rng.stream("direction")},
      velocity_{now()} {}

void GaussMarkovCurrent::advance(double h) noexcept {
  speed_.advance(h);
  direction_.advance(h);
  velocity_ = now();
}

Vec3 GaussMarkovCurrent::now() const noexcept {
  const double speed = std::clamp(speed_.value(), lowest_, highest_);
  const Vec2 direction = unit_at(direction_.value());
  return {speed * direction.x(), speed * direction.y(), 0.0};
}

}  // namespace fairway
