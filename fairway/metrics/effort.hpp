// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "fairway/core/wrench.hpp"
#include "fairway/metrics/metric.hpp"

namespace fairway {

/// What a vehicle's way cost: its length, and the power that its actuators put into the body along each axis
/// and draw themselves. From the first tick under way to the end of the run, arrived or not, so that methods
/// that never arrive can be compared.
///
/// The power of an axis is force times velocity over ground, X u, Y v or N r: positive when it drives,
/// negative when it brakes. "rms" is the root of the mean of its square over time; "mean" the mean of its
/// absolute value; energy the integral of the absolute values of all six axes. What a thruster draws is never
/// negative.
class EffortMetric final : public Metric {
 public:
  static const std::vector<QuantityInfo>& quantities();

  void see(const Frame& frame) override;
  void begin(const Frame& frame) { own_.resize(frame.vehicles.size()); }
  void see(const Frame& frame, std::size_t index);
  void report(std::vector<Measure>& measures) const override;

 private:
  struct Own {
    bool started{};
    Vec3 start = Vec3::Zero();
    Vec3 last = Vec3::Zero();
    double path_length{};
    double time{};
    std::array<double, 6> absolute{};  ///< integral of |P| [J] by axis
    double surge_square{};             ///< integral of P^2 [W2 s]
    double sway_square{};
    double yaw_square{};
    double thruster_square{};  ///< likewise of the actuators' power
    double thruster_energy{};
  };

  static void see(const VehicleFrame& vehicle, double period, Own& own);

  std::vector<Own> own_;
};

}  // namespace fairway
