// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/smoothness.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {

const std::vector<QuantityInfo>& SmoothnessMetric::quantities() {
  static const std::vector<QuantityInfo> all{
      {"heading_change_rad", true, "sum of all changes of heading while under way, either way"},
      {"speed_change_mps", true, "sum of all changes of surge velocity while under way, up and down"},
  };
  return all;
}

void SmoothnessMetric::see(const Frame& frame) {
  begin(frame);
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) see(frame, i);
}

void SmoothnessMetric::see(const Frame& frame, std::size_t index) {
  const VehicleFrame& vehicle = frame.vehicles[index];
  if (!is_avoiding(vehicle.phase)) return;
  Own& own = own_[index];
  const double yaw = yaw_of(vehicle.state.q_nb);
  const double speed = vehicle.state.v_b.x();
  if (own.started) {
    own.heading_change += std::abs(wrap_angle(yaw - own.last_yaw));
    own.speed_change += std::abs(speed - own.last_speed);
  }
  own.started = true;
  own.last_yaw = yaw;
  own.last_speed = speed;
}

void SmoothnessMetric::report(std::vector<Measure>& measures) const {
  for (std::size_t i = 0; i < own_.size(); ++i) {
    measures.push_back({"heading_change_rad", static_cast<int>(i), own_[i].heading_change});
    measures.push_back({"speed_change_mps", static_cast<int>(i), own_[i].speed_change});
  }
}

}  // namespace fairway
