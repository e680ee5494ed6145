// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/agent.hpp"
#include "fairway/world/sea/sea.hpp"

namespace fairway {

/// Throws InputError, with its place in the file, for what can be read and cannot be simulated: a vehicle
/// that floats and is to start, go or stay elsewhere than at depth 0; a step that is too long for a vehicle's
/// fastest motion (step_limit() at rest, swaying, at its start and going ahead as fast as it can, with a
/// quarter to spare); a hull that meets water far faster than it goes by itself. `agents` are those of the
/// scenario as they start, in its sea. O(vehicles x different models).
void check_feasible(const Scenario& scenario, std::span<const Agent> agents, const Sea& sea);

}  // namespace fairway
