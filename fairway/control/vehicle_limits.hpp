// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/limits.hpp"
#include "fairway/dynamics/propulsion.hpp"
#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// Whether the thrusters push sideways.
bool can_sway(const Propulsion& propulsion);

/// A mission's limits, narrowed to what the vehicle can do: no sternway or sway that its actuators do not
/// give it, and, where it has fins, no speed at which they do not steer it. A mission may allow less, but no
/// more. Of a vehicle that no autopilot drives nothing is known. O(actuators).
Limits narrowed(const Limits& mission, const Vehicle& vehicle);

}  // namespace fairway
