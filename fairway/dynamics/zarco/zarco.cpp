// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/zarco/zarco.hpp"

#include <cmath>

#include "fairway/core/params.hpp"

namespace fairway {
namespace {

constexpr double water_density = 1000.0;     // [kg/m3]
constexpr double waterplane_share = 0.8;     // of length times beam of a hull
constexpr double seakeeping_damping = 0.25;  // of critical, in heave, roll and pitch

/// Two slender hulls: waterplane area, and its second moments about the axes through the body origin. The
/// centre of gravity is taken at the body origin, low against the beam, so GM is the metacentric radius.
Hydrostatics hydrostatics_of(const Zarco::Params& p) {
  const double rho_g = water_density * fossen::gravity;
  const double area = 2.0 * waterplane_share * p.length_m * p.hull_beam_m;
  return {.heave = rho_g * area,
          .roll = rho_g * area * (p.hull_y_m * p.hull_y_m + p.hull_beam_m * p.hull_beam_m / 12.0),
          .pitch = rho_g * area * p.length_m * p.length_m / 12.0};
}

SubmergedBodyNumbers numbers_of(const Zarco::Params& p, const Hydrostatics& hydrostatics) {
  SubmergedBodyNumbers n;
  n.mass = n.displaced_mass = p.mass_kg;
  n.density = water_density;
  n.munk_moment = false;

  // radii of gyration; added mass as shares, after the Otter's of nearly the same size
  const double across = p.hull_y_m * p.hull_y_m;
  const double along = 0.0625 * p.length_m * p.length_m;
  n.inertia.diagonal() << p.mass_kg * across, p.mass_kg * along, p.mass_kg * (along + across);
  n.added_mass.diagonal() << 0.1 * p.mass_kg, 1.2 * p.mass_kg, p.mass_kg, 0.5 * p.mass_kg * across,
      p.mass_kg * along, 0.7 * p.mass_kg * (along + across);

  n.linear_damping << p.linear_damping_surge_kgps, p.linear_damping_sway_kgps, 0.0, 0.0, 0.0,
      p.linear_damping_yaw_kgm2ps;
  const auto settling = [](double stiffness, double inertia) {
    return 2.0 * seakeeping_damping * std::sqrt(stiffness * inertia);
  };
  n.linear_damping[2] = settling(hydrostatics.heave, n.mass + n.added_mass(2, 2));
  n.linear_damping[3] = settling(hydrostatics.roll, n.inertia(0, 0) + n.added_mass(3, 3));
  n.linear_damping[4] = settling(hydrostatics.pitch, n.inertia(1, 1) + n.added_mass(4, 4));
  n.quadratic_damping << p.quadratic_damping_surge_kgpm, p.quadratic_damping_sway_kgpm, 0.0, 0.0, 0.0,
      p.quadratic_damping_yaw_kgm2;
  return n;
}

}  // namespace

Zarco::Zarco(const Params& p)
    : body_{numbers_of(p, hydrostatics_of(checked_params(p)))},
      hydrostatics_{hydrostatics_of(p)},
      thruster_arm_{p.thruster_y_m},
      disk_area_{pi / 4 * p.propeller_diameter_m * p.propeller_diameter_m} {
  const Range thrust{-p.thrust_astern_n, p.thrust_ahead_n};
  const double lag = p.thruster_time_constant_s;
  actuators_ = {ActuatorInfo{"port_n", "thrust of the port thruster, positive ahead", thrust, lag},
                ActuatorInfo{"starboard_n", "thrust of the starboard thruster, positive ahead", thrust, lag}};

  propulsion_.effectiveness.resize(6, 2);
  propulsion_.effectiveness.col(0) = fossen::thruster_column({0.0, -p.thruster_y_m, 0.0}, Vec3::UnitX());
  propulsion_.effectiveness.col(1) = fossen::thruster_column({0.0, p.thruster_y_m, 0.0}, Vec3::UnitX());
  propulsion_.mass = body_.mass();
  propulsion_.linear_damping = body_.linear_damping();
  propulsion_.quadratic_damping = body_.quadratic_damping();
  propulsion_.restoring.setZero();
}

double Zarco::power(const ActuatorValues& u) const noexcept {
  return fossen::ideal_disk_power(u[0], disk_area_, water_density) +
         fossen::ideal_disk_power(u[1], disk_area_, water_density);
}

}  // namespace fairway
