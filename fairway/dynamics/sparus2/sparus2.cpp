// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/sparus2/sparus2.hpp"

#include <algorithm>

#include "fairway/core/params.hpp"

namespace fairway {
namespace {

SubmergedBodyNumbers numbers_of(const Sparus2::Params& p) {
  SubmergedBodyNumbers n;
  n.mass = p.mass_kg;
  n.displaced_mass = p.buoyancy_kg;
  n.density = p.density_kgpm3;
  n.r_g = {p.cg_x_m, p.cg_y_m, p.cg_z_m};
  n.r_b = {p.cb_x_m, p.cb_y_m, p.cb_z_m};
  n.inertia.diagonal() << p.inertia_roll_kgm2, p.inertia_pitch_kgm2, p.inertia_yaw_kgm2;
  n.added_mass.diagonal() << p.added_mass_surge_kg, p.added_mass_sway_kg, p.added_mass_heave_kg,
      p.added_inertia_roll_kgm2, p.added_inertia_pitch_kgm2, p.added_inertia_yaw_kgm2;
  n.quadratic_damping << p.quadratic_damping_surge_kgpm, p.quadratic_damping_sway_kgpm,
      p.quadratic_damping_heave_kgpm, p.quadratic_damping_roll_kgm2prad2, p.quadratic_damping_pitch_kgm2prad2,
      p.quadratic_damping_yaw_kgm2prad2;
  n.munk_moment = p.munk_moment;
  return n;
}

/// Least and greatest thrust of the heave thruster [N, positive down]. Calibrated, full thrust balances
/// drag and net buoyancy at the given steady speeds: F = Z_|w|w w |w| + (B - W).
Range heave_range(const Sparus2::Params& p) {
  double down = p.heave_thrust_down_n;
  double up = p.heave_thrust_up_n;
  if (p.heave_calibrated) {
    const double net_buoyancy = (p.buoyancy_kg - p.mass_kg) * fossen::gravity;
    const double drag_down = p.quadratic_damping_heave_kgpm * p.heave_down_mps * p.heave_down_mps;
    const double drag_up = p.quadratic_damping_heave_kgpm * p.heave_up_mps * p.heave_up_mps;
    down = std::clamp(drag_down + net_buoyancy, 0.0, p.heave_thrust_down_n);
    up = std::clamp(drag_up - net_buoyancy, 0.0, p.heave_thrust_up_n);
  }
  return {-up, down};
}

}  // namespace

Sparus2::Sparus2(const Params& p)
    : body_{numbers_of(checked_params(p))},
      surge_arm_{p.surge_thruster_y_m},
      disk_area_{pi / 4 * p.propeller_diameter_m * p.propeller_diameter_m},
      density_{p.density_kgpm3} {
  const Range surge{-p.surge_reverse_n, p.surge_forward_n};
  actuators_ = {ActuatorInfo{"heave_n", "thrust of the vertical thruster, positive down", heave_range(p),
                             p.heave_time_constant_s},
                ActuatorInfo{"surge_port_n", "thrust of the port thruster, positive forward", surge,
                             p.surge_time_constant_s},
                ActuatorInfo{"surge_starboard_n", "thrust of the starboard thruster, positive forward", surge,
                             p.surge_time_constant_s}};

  propulsion_.effectiveness.resize(6, 3);
  propulsion_.effectiveness.col(0) = fossen::thruster_column({0.0, 0.0, p.heave_thruster_z_m}, Vec3::UnitZ());
  propulsion_.effectiveness.col(1) =
      fossen::thruster_column({p.surge_thruster_x_m, -p.surge_thruster_y_m, 0.0}, Vec3::UnitX());
  propulsion_.effectiveness.col(2) =
      fossen::thruster_column({p.surge_thruster_x_m, p.surge_thruster_y_m, 0.0}, Vec3::UnitX());
  propulsion_.mass = body_.mass();
  propulsion_.linear_damping = body_.linear_damping();
  propulsion_.quadratic_damping = body_.quadratic_damping();
  propulsion_.restoring = body_.level_restoring();
}

double Sparus2::power(const ActuatorValues& u) const noexcept {
  double watts = 0.0;
  for (const double force : u) watts += fossen::ideal_disk_power(force, disk_area_, density_);
  return watts;
}

}  // namespace fairway
