// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/run_metrics.hpp"

namespace fairway {

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
