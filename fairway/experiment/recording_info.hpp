// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/record/recording.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// What a recording of a run of this scenario says of it; nothing of what it keeps beside the vehicles'
/// states.
RecordingInfo recording_info(const Scenario& scenario);

/// The scenario of a recorded run, from which it can be made again. `file` is used in messages. Throws
/// InputError if it cannot be read, or is of other vehicles than the frames.
Scenario recorded_scenario(const Recording& recording, const std::string& file);

}  // namespace fairway
