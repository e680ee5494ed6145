// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/record/recording.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway {

/// RecordingInfo::program of what was recorded in Python with methods of its own.
inline constexpr std::string_view python_program = "Python";

/// What a recording of a run of this scenario says of it; nothing of what it keeps beside the vehicles'
/// states.
RecordingInfo recording_info(const Scenario& scenario);

/// The scenario of a recorded run, from which it can be made again. `file` is used in messages. Throws
/// InputError if it cannot be read, or is of other vehicles than the frames.
Scenario recorded_scenario(const Recording& recording, const std::string& file);

/// Throws InputError unless `catalogs` have the methods of a recorded run, without which it cannot be
/// simulated again: which one they lack, and where it may be asked.
void check_methods(const Recording& recording, const Scenario& scenario, const Catalogs& catalogs,
                   const std::string& file);

}  // namespace fairway
