// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/otter/otter.hpp"

#include <cmath>

namespace fairway {
namespace {

// thrust per n |n| of one propeller at the bollard [N s2]
constexpr double ahead = 0.02216 / 2.0;
constexpr double astern = 0.01289 / 2.0;

double disk_area_of(const OtterParams& p) { return pi / 4 * p.propeller_diameter_m * p.propeller_diameter_m; }

double disk_power(double force_n, double area) noexcept {
  return fossen::ideal_disk_power(force_n, area, OtterHull::density_kgpm3);
}

}  // namespace

Otter::Otter(const Params& p) : hull_{p}, disk_area_{disk_area_of(p)} {
  const Range speed{-std::sqrt(OtterHull::max_astern_n / astern), std::sqrt(OtterHull::max_ahead_n / ahead)};
  actuators_ = {ActuatorInfo{"n1_radps", "speed of the port propeller, positive ahead", speed,
                             p.propeller_time_constant_s},
                ActuatorInfo{"n2_radps", "speed of the starboard propeller, positive ahead", speed,
                             p.propeller_time_constant_s}};
}

double Otter::thrust(double n_radps) noexcept {
  return (n_radps > 0.0 ? ahead : astern) * n_radps * std::abs(n_radps);
}

double Otter::power(const ActuatorValues& u) const noexcept {
  return disk_power(thrust(u[0]), disk_area_) + disk_power(thrust(u[1]), disk_area_);
}

OtterByThrust::OtterByThrust(const Params& p) : hull_{p}, disk_area_{disk_area_of(p)} {
  const Range range{-OtterHull::max_astern_n, OtterHull::max_ahead_n};
  actuators_ = {ActuatorInfo{"port_n", "thrust of the port propeller, positive ahead", range,
                             p.propeller_time_constant_s},
                ActuatorInfo{"starboard_n", "thrust of the starboard propeller, positive ahead", range,
                             p.propeller_time_constant_s}};

  propulsion_.effectiveness.resize(6, 2);
  propulsion_.effectiveness.col(0) =
      fossen::thruster_column({0.0, -OtterHull::propeller_y_m, 0.0}, Vec3::UnitX());
  propulsion_.effectiveness.col(1) =
      fossen::thruster_column({0.0, OtterHull::propeller_y_m, 0.0}, Vec3::UnitX());
  propulsion_.mass = hull_.mass();
  propulsion_.linear_damping = hull_.linear_damping();
  propulsion_.quadratic_damping.setZero();
  propulsion_.quadratic_damping[5] = OtterHull::yaw_quadratic_damping * hull_.linear_damping()[5];
  propulsion_.restoring.setZero();
}

double OtterByThrust::power(const ActuatorValues& u) const noexcept {
  return disk_power(u[0], disk_area_) + disk_power(u[1], disk_area_);
}

}  // namespace fairway
