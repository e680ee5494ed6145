// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <string_view>

#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// A vehicle's motion about one state and setting of its actuators, as x' = A x of small deviations, has
/// modes that come and go as exp(rate t).
struct MotionMode {
  std::complex<double> rate;  ///< eigenvalue [1/s]
  std::string_view axis;      ///< along which it moves most, a radian counting as a metre: "yaw"
};

/// How long a step may be, and the mode that says so.
struct StepLimit {
  double step_s{};
  MotionMode mode;
};

/// Nothing if a step of `h` [s] by RK4 carries every mode about `x` as it is: a mode that decays does not
/// grow. Else the longest step that does, and the mode that needs it. A step multiplies a mode by R(h rate),
/// R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24 (Hairer and Wanner, Solving Ordinary Differential Equations II,
/// section IV.2), which is stable for |R| <= 1; a mode that grows by itself is the vehicle's business. A is
/// had by central differences. O(1): 25 derivatives and the eigenvalues of a matrix of twelve.
std::optional<StepLimit> step_limit(const Vehicle& vehicle, const VehicleState& x, const ActuatorValues& u,
                                    const Water& water, double h);

/// Where the vehicle comes to from `x` with its actuators held at `u`, in some 100 s: its steady motion,
/// where it has one. Nothing if it leaves what is possible. By linearly implicit Euler steps of growing
/// length, which no fast mode disturbs; 20 of them, 25 derivatives each.
std::optional<VehicleState> steady_state(const Vehicle& vehicle, VehicleState x, const ActuatorValues& u,
                                         const Water& water);

/// "-4.3 1/s", or "-1.2 +- 5.1i 1/s".
std::string text_of(const MotionMode& mode);

}  // namespace fairway
