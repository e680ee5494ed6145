// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/control/craft.hpp"
#include "fairway/core/envelope.hpp"

namespace fairway {

/// By how much a vehicle gets elsewhere than `trackable::Foresight` has it by `envelope`, in the first 8 s:
/// farther ahead, while it stops; of who cannot stop, in any direction, while it turns [m]. `under_way` goes
/// at its greatest speed; `max_turn_rate` [rad/s] is that of the mission, or infinite. Some 10^4 steps of the
/// vehicle.
double foresight_error(const Craft& under_way, const Envelope& envelope, double max_turn_rate);

}  // namespace fairway
