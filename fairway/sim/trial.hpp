// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "fairway/dynamics/catalog.hpp"
#include "fairway/record/output_check.hpp"

namespace fairway {

inline constexpr std::string_view trial_columns =
    "time_s,x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad,u_mps,v_mps,w_mps,p_radps,q_radps,r_radps\n";

/// As run_trial() writes its outputs.
inline constexpr FileKind trial_table{
    .name = "a table of states by fairway trial", .begins = trial_columns, .holds = "", .is_table = true};

/// An open-loop manoeuvre: actuators in, motion out, nobody at the helm.
///
/// `inputs` is CSV. The header names `time_s` and any of the vehicle's actuators, in any order; an actuator
/// without a column stays at 0. Each row's values hold until the next row; they are the actuators' state:
/// clamped to their limits, without lag, unless `actuator_dynamics`, which makes them commands that the
/// actuators follow from 0.
///
/// `outputs` is CSV with columns time_s, x_m, y_m, z_m [NED], roll_rad, pitch_rad, yaw_rad, u_mps, v_mps,
/// w_mps (over ground, body axes), p_radps, q_radps, r_radps: one row per input row, the state at its time,
/// each number as the shortest decimal that reads back the same. The first row is the initial state.
///
/// `settings`: `state.x_m` ... `state.r_radps` (initial state, columns as above), `current.north_mps`,
/// `current.east_mps`, `current.down_mps`, one regular wave by `wave.amplitude_m`, `wave.period_s`,
/// `wave.direction_deg` (where it runs: 0 north, 90 east) and `wave.phase_deg`, `water.density_kgpm3`,
/// `actuator_dynamics`, `step_s` (longest RK4 step), and the parameters of the vehicle by their bare names.
/// The wave is at its phase at the time of the first row.
///
/// Throws InputError with file (`input_name`), line and column for whatever cannot be used; then nothing
/// has been written.
void run_trial(const VehicleCatalog& catalog, std::string_view vehicle, std::istream& inputs,
               const std::string& input_name, std::ostream& outputs, const ParamValues& settings);

}  // namespace fairway
