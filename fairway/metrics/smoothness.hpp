// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/metrics/metric.hpp"

namespace fairway {

/// How much a vehicle turned and changed its speed while it was under way: the less, the smoother. Waves that
/// rock it count too.
class SmoothnessMetric final : public Metric {
 public:
  static const std::vector<QuantityInfo>& quantities();

  void see(const Frame& frame) override;
  void begin(const Frame& frame) { own_.resize(frame.vehicles.size()); }
  void see(const Frame& frame, std::size_t index);
  void report(std::vector<Measure>& measures) const override;

 private:
  struct Own {
    bool started{};
    double last_yaw{};
    double last_speed{};
    double heading_change{};  ///< integral of |d(yaw)| [rad]
    double speed_change{};    ///< integral of |d(surge)| [m/s]
  };

  std::vector<Own> own_;
};

}  // namespace fairway
