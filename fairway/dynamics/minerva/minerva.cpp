// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/minerva/minerva.hpp"

#include "fairway/core/params.hpp"

namespace fairway {
namespace {

SubmergedBodyNumbers numbers_of(const Minerva::Params& p) {
  SubmergedBodyNumbers n;
  n.mass = n.displaced_mass = 460.0;
  n.density = p.density_kgpm3;
  n.r_g = {0.0, 0.0, 0.15};
  n.r_b = {0.0, 0.0, -0.12};
  // a uniform box of 460 kg, 1.44 m x 0.82 m x 0.80 m has (50.31, 104.02, 105.26): the file swaps Ix and Iz
  n.inertia.diagonal() << 50.31, 104.02, 105.26;
  if (p.plant == MinervaPlant::paper_compat) n.inertia.diagonal().reverseInPlace();
  n.added_mass.diagonal() << 293.0, 302.0, 326.0, 52.0, 52.0, 57.0;
  n.linear_damping << 29.0, 41.0, 254.0, 34.0, 59.0, 45.0;
  n.quadratic_damping << 292.0, 584.0, 635.0, 84.0, 148.0, 100.0;
  return n;
}

/// A propeller of `diameter_m` and its hull coefficients theta ahead and astern.
struct Propeller {
  double diameter_m, theta_ahead, theta_astern;
};

constexpr Propeller lateral{0.19, 1.04, 1.04};
constexpr Propeller vertical{0.22, 0.58, 0.58};
constexpr Propeller main{0.22, 0.72, 0.53};

/// Thrust at rest, f = rho D^4 K_T(0) theta n |n| with K_T(0) = 0.24 ahead and 0.15 astern.
Range thrust_range(const Propeller& propeller, const Minerva::Params& p, double ratio) {
  const double D = propeller.diameter_m, n = p.max_propeller_speed_hz;
  const double most = ratio * p.density_kgpm3 * D * D * D * D * n * n;
  return {-most * 0.15 * propeller.theta_astern, most * 0.24 * propeller.theta_ahead};
}

}  // namespace

Part minerva_part(const Minerva::Params& p, double thrust_ratio) {
  const auto thruster = [&](std::string name, std::string meaning, const Propeller& propeller,
                            const fossen::Vector6& column) {
    return Thruster{.name = std::move(name),
                    .meaning = std::move(meaning),
                    .column = column,
                    .range = thrust_range(propeller, p, thrust_ratio),
                    .time_constant_s = p.thruster_time_constant_s,
                    .propeller_diameter_m = propeller.diameter_m};
  };
  Part part{.numbers = numbers_of(p)};
  part.thrusters = {
      thruster("lateral_n", "thrust of the lateral thruster, positive to starboard", lateral,
               {0.0, 1.0, 0.0, 0.0, 0.0, 0.166}),
      thruster("vertical_port_n", "thrust of the port vertical thruster, positive down", vertical,
               {0.0, 0.0, 1.0, -0.20, 0.0, 0.0}),
      thruster("vertical_starboard_n", "thrust of the starboard vertical thruster, positive down", vertical,
               {0.0, 0.0, 1.0, 0.20, 0.0, 0.0}),
      thruster("main_port_n", "thrust of the port main thruster, positive ahead", main,
               {0.985, -0.174, 0.0, 0.0, 0.0, 0.335}),
      thruster("main_starboard_n", "thrust of the starboard main thruster, positive ahead", main,
               {0.985, 0.174, 0.0, 0.0, 0.0, -0.335})};
  return part;
}

CompositeBody::Options equations_of(MinervaPlant plant, DegreesOfFreedom degrees_of_freedom) {
  const bool physical = plant == MinervaPlant::physical;
  return {.degrees_of_freedom = degrees_of_freedom, .coriolis = physical, .quadratic_drag = physical};
}

Minerva::Minerva(const Params& params)
    : CompositeVehicle{std::array{minerva_part(checked_params(params))},
                       equations_of(params.plant, params.degrees_of_freedom)} {}

}  // namespace fairway
