// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/run_metrics.hpp"

namespace fairway {

void RunMetrics::write(const Frame& frame) {
  const std::size_t hands = frame.crew != nullptr ? frame.crew->hands() : 1;
  encounters_.begin(frame, hands);
  progress_.begin(frame, hands);
  fleet_.begin(frame, hands);
  effort_.begin(frame);
  smoothness_.begin(frame);

  // all that is asked of one vehicle at a time, so that its frame is looked at once
  const Neighbours& all = neighbours_.of(frame);
  vehicles_ = frame.vehicles.size();
  while (near_.size() < hands) near_.emplace_back().reserve(Neighbours::usual_room(vehicles_));
  for_each(frame.crew, vehicles_, [&](std::size_t i, std::size_t hand) {
    std::vector<Neighbour>& near = near_[hand];
    all.find(i, math::fmax(fleet_.reach(all, i), encounters_.reach(frame, i)), near);
    fleet_.see(frame, near, i, hand);
    progress_.see(frame, i, hand);
    encounters_.see(frame, near, i, hand);
    effort_.see(frame, i);
    smoothness_.see(frame, i);
  });
  fleet_.finish(frame);
  progress_.finish(frame, all);
}

std::vector<Measure> RunMetrics::measures() const {
  std::vector<Measure> all;
  std::size_t count = 0;
  for (const QuantityInfo& quantity : all_quantities()) count += quantity.per_vehicle ? vehicles_ : 1;
  all.reserve(count);
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
