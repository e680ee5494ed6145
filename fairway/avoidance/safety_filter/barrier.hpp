// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/plane_program/plane_program.hpp"
#include "fairway/avoidance/safety_filter/hazards.hpp"

namespace fairway {

/// How a barrier is kept.
struct BarrierGains {
  double k1;        ///< [1/s]
  double k2;        ///< [1/s]
  double margin;    ///< between own sphere and a hazard's [m]
  double response;  ///< time in which a commanded velocity is taken up [s]; 0 for forces
};

/// What a hazard asks of own horizontal acceleration.
struct Barrier {
  HalfPlane acceleration;  ///< allowed [m/s2, north and east]
  bool is_late;            ///< psi_1 < 0: closing in faster than the barrier ever lets
};

/// With Delta = own position - centre, w = own velocity - the hazard's and R the sum of both radii and the
/// margin:
///
///     h     = |Delta|^2 - R^2
///     psi_1 = h' + k1 h            h' = 2 Delta . w
///     psi_1' + k2 psi_1 >= 0       h'' = 2 |w|^2 + 2 Delta . a
///
/// For a flat hazard w is its part along Delta, since the part along the surface does not open the range. As
/// long as psi_1 >= 0 at the start and this holds, h >= 0. The hazard's acceleration is taken as zero; of one
/// that reacts, half of the demand is left to it. When late, the demand is also no less than the constant
/// deceleration c^2 / (2 gap) that stops the closing speed c at the margin. Positions and velocities are in
/// space, only the acceleration is not. O(1).
Barrier barrier(const Hazard& hazard, const Ownship& own, const BarrierGains& gains) noexcept;

}  // namespace fairway
