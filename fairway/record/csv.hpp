// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>

#include "fairway/record/output_check.hpp"
#include "fairway/record/recording.hpp"

namespace fairway {

/// As all of these begin.
inline constexpr FileKind recording_table{
    .name = "a table of a recording", .begins = "tick,time_s,vehicle,", .holds = "", .is_table = true};

/// One row per vehicle and frame, frames in order and vehicles by index within one. Columns: tick, time_s,
/// vehicle (its name), those of quantities() in that order, then actuator_0, actuator_1, ... in the order
/// and units of the vehicle's model, as many as the vehicle with most of them has. Numbers read back to the
/// same bits; an empty field means there is no such value. O(rows).
void export_csv(const Recording& recording, std::ostream& out);

/// Likewise one row per track: tick, time_s, vehicle (who perceived it), record_columns<Track>(). Nearest
/// first within a vehicle and frame. Throws InputError if perception is not recorded. O(rows).
void export_tracks_csv(const Recording& recording, std::ostream& out);

/// Likewise one row per echo: tick, time_s, vehicle, range_m, bearing_rad.
void export_echoes_csv(const Recording& recording, std::ostream& out);

}  // namespace fairway
