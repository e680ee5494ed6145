// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/run_metrics.hpp"

namespace fairway {

void RunMetrics::write(const Frame& frame) {
  const Neighbours& near = neighbours_.of(frame);
  const auto see = [&](std::size_t metric, std::size_t /*hand*/) {
    switch (metric) {  // the longest first
      case 0:
        return fleet_.see(frame, near);
      case 1:
        return progress_.see(frame, near);
      case 2:
        return encounters_.see(frame, near);
      case 3:
        return effort_.see(frame);
      default:
        return smoothness_.see(frame);
    }
  };
  constexpr std::size_t metrics = 5;
  if (crew_) return crew_->go_through(metrics, see);
  for (std::size_t i = 0; i < metrics; ++i) see(i, 0);
}

std::vector<Measure> RunMetrics::measures() const {
  std::vector<Measure> all;
  encounters_.report(all);
  fleet_.report(all);
  effort_.report(all);
  smoothness_.report(all);
  progress_.report(all);
  return all;
}

std::vector<QuantityInfo> all_quantities() {
  std::vector<QuantityInfo> all = EncounterMetric::quantities();
  all.insert(all.end(), FleetMetric::quantities().begin(), FleetMetric::quantities().end());
  all.insert(all.end(), EffortMetric::quantities().begin(), EffortMetric::quantities().end());
  all.insert(all.end(), SmoothnessMetric::quantities().begin(), SmoothnessMetric::quantities().end());
  all.insert(all.end(), ProgressMetric::quantities().begin(), ProgressMetric::quantities().end());
  return all;
}

}  // namespace fairway
