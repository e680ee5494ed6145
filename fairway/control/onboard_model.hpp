// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/core/onboard_model.hpp"
#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// What a vehicle's avoider may know of its dynamics: the diagonals of its equations, and what its actuators
/// give along each axis with all others at zero. Nothing for a vehicle that is driven by setpoints.
std::optional<OnboardModel> onboard_model(const Vehicle& vehicle);

}  // namespace fairway
