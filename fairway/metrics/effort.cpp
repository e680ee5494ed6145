// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/effort.hpp"

#include <cmath>

namespace fairway {
namespace {

constexpr std::size_t surge = 0, sway = 1, yaw = 5;

}  // namespace

const std::vector<QuantityInfo>& EffortMetric::quantities() {
  static const std::vector<QuantityInfo> all{
      {"path_length_m", true, "length of the way, from the first tick under way to the end of the run"},
      {"displacement_m", true, "straight distance between the ends of that way"},
      {"rms_surge_power_w", true, "root mean square of surge force times surge velocity"},
      {"rms_sway_power_w", true, "root mean square of sway force times sway velocity"},
      {"rms_yaw_power_w", true, "root mean square of yaw moment times yaw rate"},
      {"mean_surge_power_w", true, "mean of the absolute value of surge force times surge velocity"},
      {"mean_sway_power_w", true, "mean of the absolute value of sway force times sway velocity"},
      {"mean_yaw_power_w", true, "mean of the absolute value of yaw moment times yaw rate"},
      {"body_energy_j", true, "integral of the absolute power along all six body axes"},
      {"rms_thruster_power_w", true, "root mean square of what the actuators draw together"},
      {"mean_thruster_power_w", true, "mean of what the actuators draw together"},
  };
  return all;
}

void EffortMetric::see(const Frame& frame) {
  begin(frame);
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) see(frame, i);
}

void EffortMetric::see(const Frame& frame, std::size_t index) {
  const VehicleFrame& vehicle = frame.vehicles[index];
  Own& own = own_[index];
  if (!own.started && is_avoiding(vehicle.phase)) {
    own.started = true;
    own.start = own.last = vehicle.state.p_n;
  }
  if (own.started) see(vehicle, frame.period, own);
}

void EffortMetric::see(const VehicleFrame& vehicle, double period, Own& own) {
  own.path_length += (vehicle.state.p_n - own.last).norm();
  own.last = vehicle.state.p_n;
  own.time += period;

  const Vec3& v = vehicle.state.v_b;
  const Vec3& omega = vehicle.state.omega_b;
  const std::array<double, 6> nu{v.x(), v.y(), v.z(), omega.x(), omega.y(), omega.z()};
  std::array<double, 6> power;
  for (std::size_t axis = 0; axis < nu.size(); ++axis) {
    power[axis] = vehicle.wrench[static_cast<Eigen::Index>(axis)] * nu[axis];
    own.absolute[axis] += std::abs(power[axis]) * period;
  }
  own.surge_square += power[surge] * power[surge] * period;
  own.sway_square += power[sway] * power[sway] * period;
  own.yaw_square += power[yaw] * power[yaw] * period;
  own.thruster_square += vehicle.power * vehicle.power * period;
  own.thruster_energy += vehicle.power * period;
}

void EffortMetric::report(std::vector<Measure>& measures) const {
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const Own& own = own_[i];
    const auto mean = [&](double integral) { return own.time > 0.0 ? integral / own.time : 0.0; };
    const auto add = [&](const char* quantity, double value) {
      measures.push_back({quantity, static_cast<int>(i), value});
    };
    double energy = 0.0;
    for (const double joules : own.absolute) energy += joules;

    add("path_length_m", own.path_length);
    add("displacement_m", (own.last - own.start).norm());
    add("rms_surge_power_w", std::sqrt(mean(own.surge_square)));
    add("rms_sway_power_w", std::sqrt(mean(own.sway_square)));
    add("rms_yaw_power_w", std::sqrt(mean(own.yaw_square)));
    add("mean_surge_power_w", mean(own.absolute[surge]));
    add("mean_sway_power_w", mean(own.absolute[sway]));
    add("mean_yaw_power_w", mean(own.absolute[yaw]));
    add("body_energy_j", energy);
    add("rms_thruster_power_w", std::sqrt(mean(own.thruster_square)));
    add("mean_thruster_power_w", mean(own.thruster_energy));
  }
}

}  // namespace fairway
