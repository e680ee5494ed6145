// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoa_improved/vessel_response.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::avoa_improved {

/// What a vessel makes good beyond what it was steered to: a current, wind, sideslip. Learnt from the
/// difference of the velocity over ground and that which the helm's model expects,
///
///     c' = (v - m e(yaw) - c) / T_c
///
/// with m the speed through the water after the commands so far. [m/s, NED]
class Drift {
 public:
  /// At each decision, `period` seconds after the one before. At first only what goes across the heading is
  /// drift.
  void observe(const Vec2& velocity, const Vec2& ahead, const VesselResponse& helm, double period,
               double settling) noexcept;

  /// The speed ahead that was asked for in the meantime [m/s].
  void command(double speed) noexcept { commanded_ = speed; }

  const Vec2& velocity() const noexcept { return drift_; }

 private:
  bool is_known_ = false;
  double speed_{};      ///< m [m/s]
  double commanded_{};  ///< [m/s]
  Vec2 drift_ = Vec2::Zero();
};

/// How far to turn up into the drift, from the direction that is to be made good at `speed` through the water
/// [rad]. As far as helps where the drift is the faster. O(1).
double crab_angle(const Vec2& direction, const Vec2& drift, double speed) noexcept;

}  // namespace fairway::avoa_improved
