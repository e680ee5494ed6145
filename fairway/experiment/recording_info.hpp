// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/record/recording_writer.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// What a recording of a run of this scenario says of it; nothing of what it keeps beside the vehicles'
/// states.
RecordingInfo recording_info(const Scenario& scenario);

}  // namespace fairway
