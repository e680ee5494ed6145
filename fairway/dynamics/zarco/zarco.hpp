// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/dynamics/hydrostatics.hpp"
#include "fairway/dynamics/propulsion.hpp"
#include "fairway/dynamics/submerged_body.hpp"

namespace fairway {

/// Zarco, an autonomous surface catamaran with two thrusters side by side (campos2019, section III-A and
/// IV-A; Cruz, Matos, Cunha, Silva 2007). No dimension, mass or damping is published in what this was built
/// from: every number is an estimate, chosen so that the published limits, 1.5 m/s and 0.3751 rad/s, can be
/// kept at the same time. README.md beside this file has them and where they come from.
class Zarco {
 public:
  static constexpr VehicleInfo info{.name = "zarco",
                                    .title = "Zarco surface catamaran",
                                    .source =
                                        "estimates within the limits of campos2019; "
                                        "fairway/dynamics/zarco/README.md",
                                    .floats = true};

  struct Params {
    double mass_kg{50.0};
    double length_m{1.5};
    double hull_beam_m{0.2};
    double hull_y_m{0.4};
    double thruster_y_m{0.4};
    double thrust_ahead_n{55.0}, thrust_astern_n{35.0};
    double thruster_time_constant_s{0.2};
    double linear_damping_surge_kgps{20.0}, quadratic_damping_surge_kgpm{20.0};
    double linear_damping_sway_kgps{80.0}, quadratic_damping_sway_kgpm{200.0};
    double linear_damping_yaw_kgm2ps{20.0}, quadratic_damping_yaw_kgm2{20.0};
    double propeller_diameter_m{0.15};

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::mass_kg>({1, 10000}, "mass, and mass of the displaced water"),
          field<&P::length_m>({0.1, 100}, "of the hulls in the waterline"),
          field<&P::hull_beam_m>({0.01, 10}, "of each hull in the waterline"),
          field<&P::hull_y_m>({0.01, 10}, "centreline of the hulls, to either side"),
          field<&P::thruster_y_m>({0.01, 10}, "thrusters, to either side"),
          field<&P::thrust_ahead_n>({0.1, 1e5}, "largest thrust of each thruster, ahead"),
          field<&P::thrust_astern_n>({0, 1e5}, "largest thrust of each thruster, astern"),
          field<&P::thruster_time_constant_s>({0, 10}, "lag of the thrusters"),
          field<&P::linear_damping_surge_kgps>({0, 1e5}, "-X_u"),
          field<&P::quadratic_damping_surge_kgpm>({0, 1e5}, "-X_|u|u"),
          field<&P::linear_damping_sway_kgps>({0, 1e5}, "-Y_v"),
          field<&P::quadratic_damping_sway_kgpm>({0, 1e5}, "-Y_|v|v"),
          field<&P::linear_damping_yaw_kgm2ps>({0, 1e5}, "-N_r"),
          field<&P::quadratic_damping_yaw_kgm2>({0, 1e5}, "-N_|r|r"),
          field<&P::propeller_diameter_m>({0.01, 1}, "of each propeller; for power only"),
      };
    }
  };

  explicit Zarco(const Params& params);

  /// port_n, starboard_n: thrusts, positive ahead.
  std::span<const ActuatorInfo> actuators() const { return actuators_; }

  [[gnu::always_inline]] StateRate derivative(const VehicleState& x, const ActuatorValues& u,
                                              const Water& water) const noexcept {
    Wrench tau = hydrostatics_.wrench(x, water);
    tau[0] += u[0] + u[1];
    tau[5] += thruster_arm_ * (u[0] - u[1]);
    return body_.derivative(x, tau, water);
  }

  /// The power of ideal actuator disks of the propellers' diameter [W], a lower bound of the electrical
  /// power.
  double power(const ActuatorValues& u) const noexcept;

  const Propulsion& propulsion() const { return propulsion_; }
  const SubmergedBody& body() const { return body_; }
  const Hydrostatics& hydrostatics() const { return hydrostatics_; }

 private:
  SubmergedBody body_;  ///< its weight and buoyancy cancel: hydrostatics_ holds it up
  Hydrostatics hydrostatics_;
  double thruster_arm_;  // [m]
  double disk_area_;     // [m2]
  std::array<ActuatorInfo, 2> actuators_;
  Propulsion propulsion_;
};

}  // namespace fairway
