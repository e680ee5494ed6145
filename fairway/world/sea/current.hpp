// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/core/vec.hpp"
#include "fairway/scenario/water_spec.hpp"

namespace fairway {

/// A current that depends on depth alone. `spec.profile` has at least two points, downwards.
class ShearedCurrent {
 public:
  explicit ShearedCurrent(const ShearedCurrentSpec& spec);

  struct Flow {
    double speed{};     ///< [m/s]
    double gradient{};  ///< d(speed)/d(depth) [1/s]; 0 beyond the profile
  };
  /// At `depth` [m, down]. O(log points).
  Flow at(double depth) const noexcept;

  const Vec2& direction() const { return direction_; }  ///< unit, [n, e]

 private:
  Vec2 direction_;
  std::vector<ProfilePoint> profile_;
};

/// dX/dt = (mean - X) / T + white noise, so large that X has the given standard deviation (Fossen 2021,
/// section 10.3). advance() is exact for any step:
///
///     X+ = mean + e^(-h/T) (X - mean) + deviation sqrt(1 - e^(-2h/T)) N(0, 1)
///
/// With mu = 1/T and noise of density sigma^2, deviation is sigma / sqrt(2 mu). It begins anywhere on the
/// process.
class GaussMarkov {
 public:
  GaussMarkov(double mean, double deviation, double correlation_time, Rng rng);

  void advance(double h) noexcept;  ///< [s]
  double value() const { return mean_ + offset_; }

 private:
  double mean_;
  double deviation_;
  double rate_;  // 1 / T
  Rng rng_;
  double offset_;
};

/// Speed and direction of the water, alike everywhere. A speed that leaves its limits is cut, not the
/// process that it is cut from, so that its statistics depend on no step.
class GaussMarkovCurrent {
 public:
  GaussMarkovCurrent(const GaussMarkovCurrentSpec& spec, const Rng& rng);

  void advance(double h) noexcept;
  const Vec3& velocity() const { return velocity_; }  ///< [m/s, NED]

 private:
  Vec3 now() const noexcept;

  double lowest_;
  double highest_;
  GaussMarkov speed_;
  GaussMarkov direction_;
  Vec3 velocity_;
};

}  // namespace fairway
