// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/dynamics/composite/composite_vehicle.hpp"

namespace fairway {

/// Which set of equations stands for a Minerva.
enum class MinervaPlant {
  physical,      ///< Coriolis terms, linear and quadratic drag, yaw inertia of the hull
  paper_compat,  ///< linear drag alone, no Coriolis terms, Ix and Iz as in the published file
};

template <>
struct EnumNames<MinervaPlant> {
  static constexpr std::array names{"physical", "paper_compat"};
};

/// Minerva, a hovering underwater vehicle (1.44 m x 0.82 m x 0.81 m, 460 kg) with one lateral, two vertical
/// and two main thrusters. Where each number comes from stands in README.md beside this file.
///
/// Its actuators are lateral_n (positive to starboard), vertical_port_n, vertical_starboard_n (positive
/// down), main_port_n, main_starboard_n (positive ahead); with `planar` without the vertical ones.
class Minerva : public CompositeVehicle {
 public:
  static constexpr VehicleInfo info{.name = "minerva",
                                    .title = "Minerva HAUV",
                                    .source =
                                        "parameter set of Mo (2015) as published with rehman2021's group; "
                                        "fairway/dynamics/minerva/README.md"};
  static constexpr double breadth_m = 0.81;  ///< its smallest dimension

  struct Params {
    MinervaPlant plant{MinervaPlant::physical};
    DegreesOfFreedom degrees_of_freedom{DegreesOfFreedom::six};
    double density_kgpm3{1025.0};
    double max_propeller_speed_hz{20.0};
    double thruster_time_constant_s{0.0};

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::plant>("equations: physical, or paper_compat, chosen after the times of rehman2021"),
          field<&P::degrees_of_freedom>("planar holds depth, roll and pitch; six frees them"),
          field<&P::density_kgpm3>({900, 1100}, "of the water it is ballasted for; sets thrust"),
          field<&P::max_propeller_speed_hz>({1, 60}, "fastest propeller turns; 20 = 1200 rpm"),
          field<&P::thruster_time_constant_s>({0, 10}, "lag of every thruster"),
      };
    }
  };

  explicit Minerva(const Params& params);
};

/// A Minerva as a part at the origin of the whole; its thrusters give `thrust_ratio` of what they can.
Part minerva_part(const Minerva::Params& params, double thrust_ratio = 1.0);

/// The equations that go with `plant`.
CompositeBody::Options equations_of(MinervaPlant plant, DegreesOfFreedom degrees_of_freedom);

}  // namespace fairway
