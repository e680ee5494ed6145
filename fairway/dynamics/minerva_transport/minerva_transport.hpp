// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/dynamics/minerva/minerva.hpp"

namespace fairway {

/// Several Minervas, a payload cube and the links between them as one rigid body (rehman2021, section II;
/// there four vehicles in the horizontal plane). Body origin at the centre of the payload. Where each number
/// comes from, and what is assumed, stands in README.md beside this file.
///
/// Its actuators are Minerva's, vehicle by vehicle: vehicle0_lateral_n, ..., vehicle3_main_starboard_n.
class MinervaTransport : public CompositeVehicle {
 public:
  static constexpr VehicleInfo info{.name = "minerva_transport",
                                    .title = "Minervas carrying a payload on rigid links",
                                    .source =
                                        "rehman2021, composed from the minerva parameter set; "
                                        "fairway/dynamics/minerva_transport/README.md"};

  /// Where one vehicle is fixed.
  struct Station {
    double x_m{0.0}, y_m{0.0}, z_m{0.0};
    double yaw_deg{0.0};
    double thrust_ratio{1.0};

    static consteval auto fields() {
      constexpr Range offset{-100, 100};
      using S = Station;
      return std::tuple{
          field<&S::x_m>(offset, "origin of the vehicle, forward of the payload's centre"),
          field<&S::y_m>(offset, "origin of the vehicle, to starboard"),
          field<&S::z_m>(offset, "origin of the vehicle, below"),
          field<&S::yaw_deg>({-360, 360}, "its heading on the body, clockwise from above"),
          field<&S::thrust_ratio>({0, 1}, "share of thrust that its thrusters give; 0 = dead"),
      };
    }
  };

  struct Params {
    MinervaPlant plant{MinervaPlant::physical};
    DegreesOfFreedom degrees_of_freedom{DegreesOfFreedom::planar};
    std::vector<Station> layout{{.x_m = 2.26, .yaw_deg = 0.0},
                                {.y_m = 2.26, .yaw_deg = 90.0},
                                {.x_m = -2.26, .yaw_deg = 180.0},
                                {.y_m = -2.26, .yaw_deg = -90.0}};
    double payload_edge_m{1.0};
    double link_length_m{1.0};
    double link_diameter_m{0.1};
    double density_kgpm3{1025.0};
    double max_propeller_speed_hz{20.0};
    double thruster_time_constant_s{0.0};

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::plant>("equations: physical, or paper_compat, chosen after the times of rehman2021"),
          field<&P::degrees_of_freedom>("planar holds depth, roll and pitch; six frees them"),
          field<&P::layout>("where the vehicles are fixed; four on the arms of a cross if not given"),
          field<&P::payload_edge_m>({0, 20}, "edge of the payload cube, neutrally buoyant; 0 = none"),
          field<&P::link_length_m>({0, 20}, "links, outward from the payload's faces; 0 = none"),
          field<&P::link_diameter_m>({0, 2}, "links are round bars, neutrally buoyant; 0 = none"),
          field<&P::density_kgpm3>({900, 1100}, "of the water it is ballasted for; sets thrust and payload"),
          field<&P::max_propeller_speed_hz>({1, 60}, "fastest propeller turns; 20 = 1200 rpm"),
          field<&P::thruster_time_constant_s>({0, 10}, "lag of every thruster"),
      };
    }
  };

  /// Throws InputError for a layout that is empty, has more thrusters than max_actuators, puts a vehicle into
  /// another or into the payload, or whose thrusters cannot push along surge, sway and yaw (and heave, where
  /// it is free).
  explicit MinervaTransport(const Params& params);
};

}  // namespace fairway
