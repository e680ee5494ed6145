// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/dynamics/propulsion.hpp"
#include "fairway/dynamics/submerged_body.hpp"

namespace fairway {

/// Sparus II, a hovering torpedo-shaped AUV (1.6 m x 0.23 m) with two surge thrusters and one for heave.
/// Every number is an estimate; where each comes from stands in README.md beside this file.
class Sparus2 {
 public:
  static constexpr VehicleInfo info{.name = "sparus2",
                                    .title = "Sparus II AUV",
                                    .source =
                                        "estimated parameter set A, heave calibrated on raja2024; "
                                        "fairway/dynamics/sparus2/README.md"};

  struct Params {
    // body
    double mass_kg{52.0};
    double buoyancy_kg{52.1};
    double density_kgpm3{1000.0};
    double cg_x_m{0.0}, cg_y_m{0.0}, cg_z_m{0.0};
    double cb_x_m{0.0}, cb_y_m{0.0}, cb_z_m{-0.02};
    double inertia_roll_kgm2{0.5}, inertia_pitch_kgm2{9.4}, inertia_yaw_kgm2{9.5};

    // water
    double added_mass_surge_kg{2.0}, added_mass_sway_kg{64.6}, added_mass_heave_kg{68.5};
    double added_inertia_roll_kgm2{0.015}, added_inertia_pitch_kgm2{12.3}, added_inertia_yaw_kgm2{12.3};
    double quadratic_damping_surge_kgpm{14.2}, quadratic_damping_sway_kgpm{139.0};
    double quadratic_damping_heave_kgpm{126.0};
    double quadratic_damping_roll_kgm2prad2{0.0}, quadratic_damping_pitch_kgm2prad2{9.44};
    double quadratic_damping_yaw_kgm2prad2{9.44};
    bool munk_moment{false};

    // thrusters
    double heave_thruster_z_m{0.08};
    double surge_thruster_x_m{-0.59}, surge_thruster_y_m{0.17};
    double surge_forward_n{71.5}, surge_reverse_n{30.0};
    double heave_thrust_down_n{55.0}, heave_thrust_up_n{28.5};
    bool heave_calibrated{true};
    double heave_down_mps{0.305}, heave_up_mps{0.24};
    double surge_time_constant_s{0.8}, heave_time_constant_s{0.4};
    double propeller_diameter_m{0.13};

    static consteval auto fields() {
      constexpr Range offset{-0.5, 0.5};
      using P = Params;
      return std::tuple{
          field<&P::mass_kg>({1, 1000}, "mass in air, flooded volumes included"),
          field<&P::buoyancy_kg>({1, 1000}, "mass of displaced water of density_kgpm3"),
          field<&P::density_kgpm3>({900, 1100},
                                   "water that displacement, added mass and damping are given for"),
          field<&P::cg_x_m>(offset, "centre of gravity, forward of the body origin"),
          field<&P::cg_y_m>(offset, "centre of gravity, to starboard"),
          field<&P::cg_z_m>(offset, "centre of gravity, below"),
          field<&P::cb_x_m>(offset, "centre of buoyancy, forward of the body origin"),
          field<&P::cb_y_m>(offset, "centre of buoyancy, to starboard"),
          field<&P::cb_z_m>(offset, "centre of buoyancy, below; negative is stable"),
          field<&P::inertia_roll_kgm2>({0.01, 1000}, "moment of inertia Ixx about the centre of gravity"),
          field<&P::inertia_pitch_kgm2>({0.01, 1000}, "moment of inertia Iyy about the centre of gravity"),
          field<&P::inertia_yaw_kgm2>({0.01, 1000}, "moment of inertia Izz about the centre of gravity"),
          field<&P::added_mass_surge_kg>({0, 1000}, "-X_udot"),
          field<&P::added_mass_sway_kg>({0, 1000}, "-Y_vdot"),
          field<&P::added_mass_heave_kg>({0, 1000}, "-Z_wdot"),
          field<&P::added_inertia_roll_kgm2>({0, 1000}, "-K_pdot"),
          field<&P::added_inertia_pitch_kgm2>({0, 1000}, "-M_qdot"),
          field<&P::added_inertia_yaw_kgm2>({0, 1000}, "-N_rdot"),
          field<&P::quadratic_damping_surge_kgpm>({0, 1000}, "-X_|u|u"),
          field<&P::quadratic_damping_sway_kgpm>({0, 1000}, "-Y_|v|v"),
          field<&P::quadratic_damping_heave_kgpm>({0, 1000}, "-Z_|w|w"),
          field<&P::quadratic_damping_roll_kgm2prad2>(
              {0, 1000}, "-K_|p|p; zero in the published set: roll never dies out"),
          field<&P::quadratic_damping_pitch_kgm2prad2>({0, 1000}, "-M_|q|q"),
          field<&P::quadratic_damping_yaw_kgm2prad2>({0, 1000}, "-N_|r|r"),
          field<&P::munk_moment>("whether the translational added mass enters the Coriolis terms"),
          field<&P::heave_thruster_z_m>({-1, 1}, "heave thruster, below the body origin"),
          field<&P::surge_thruster_x_m>({-2, 2}, "surge thrusters, forward of the body origin"),
          field<&P::surge_thruster_y_m>({0.01, 1}, "surge thrusters, to either side"),
          field<&P::surge_forward_n>({0, 500}, "largest thrust of each surge thruster, forward"),
          field<&P::surge_reverse_n>({0, 500}, "largest thrust of each surge thruster, reverse"),
          field<&P::heave_thrust_down_n>({0, 500}, "largest thrust of the heave thruster, down"),
          field<&P::heave_thrust_up_n>({0, 500}, "largest thrust of the heave thruster, up"),
          field<&P::heave_calibrated>(
              "whether heave thrust is capped to give heave_down_mps and heave_up_mps"),
          field<&P::heave_down_mps>({0, 2}, "steady speed down at full heave thrust, if calibrated"),
          field<&P::heave_up_mps>({0, 2}, "steady speed up at full heave thrust, if calibrated"),
          field<&P::surge_time_constant_s>({0, 10}, "lag of the surge thrusters"),
          field<&P::heave_time_constant_s>({0, 10}, "lag of the heave thruster"),
          field<&P::propeller_diameter_m>({0.01, 1}, "of every thruster; for power only"),
      };
    }
  };

  explicit Sparus2(const Params& params);

  /// heave_n (positive down), surge_port_n, surge_starboard_n (positive forward).
  std::span<const ActuatorInfo> actuators() const { return actuators_; }

  [[gnu::always_inline]] StateRate derivative(const VehicleState& x, const ActuatorValues& u,
                                              const Water& water) const noexcept {
    return body_.derivative(x, push(u), water);
  }

  /// What the actuators push with: the two surge thrusters are mirror images, and the heave thruster sits on
  /// the z axis and turns nothing.
  [[gnu::always_inline]] lanes::PushOf<double> push(const ActuatorValues& u) const noexcept {
    const double heave = u[0], port = u[1], starboard = u[2];
    return {{port + starboard, 0.0, heave}, {0.0, 0.0, surge_arm_ * (port - starboard)}};
  }

  /// The power of ideal actuator disks of the propellers' diameter [W], a lower bound of the electrical
  /// power.
  double power(const ActuatorValues& u) const noexcept;

  const Propulsion& propulsion() const { return propulsion_; }
  const SubmergedBody& body() const { return body_; }

 private:
  SubmergedBody body_;
  double surge_arm_;  // [m]
  double disk_area_;  // [m2]
  double density_;    // [kg/m3]
  std::array<ActuatorInfo, 3> actuators_;
  Propulsion propulsion_;
};

}  // namespace fairway
