// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/control/autopilot.hpp"
#include "fairway/core/envelope.hpp"
#include "fairway/core/limits.hpp"
#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// What `vehicle` can do under `autopilot`, as short simulations in still water show it, in steps of `step`
/// [s] as in the scenario. `limits` are those of the mission; it is asked for nothing beyond them. The bounds
/// on following errors are those of the law of `trackable::TurnLaw`, and the error of foresight is that of
/// `trackable::Foresight`. The same numbers for the same arguments, to the bit. Nothing for a vehicle that
/// does not get under way. Some 10^4 steps of the vehicle.
std::optional<Envelope> measured_envelope(const Vehicle& vehicle, const Autopilot& autopilot,
                                          const Limits& limits, double step);

}  // namespace fairway
