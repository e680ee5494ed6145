// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "fairway/core/crew.hpp"
#include "fairway/core/math.hpp"
#include "fairway/metrics/effort.hpp"
#include "fairway/metrics/encounters.hpp"
#include "fairway/metrics/fleet.hpp"
#include "fairway/metrics/neighbours.hpp"
#include "fairway/metrics/progress.hpp"
#include "fairway/metrics/smoothness.hpp"

namespace fairway {

/// Every metric of a run, as one sink of frames.
class RunMetrics final : public FrameSink {
 public:
  /// `progress_window` [s], as `ProgressMetric`.
  explicit RunMetrics(EncounterRules rules, Surroundings surroundings = {}, double progress_window = 30.0)
      : RunMetrics{rules, std::make_shared<const Surroundings>(std::move(surroundings)), progress_window} {}

  /// By the frame's crew, if it has one, some vehicles each. The numbers are the same.
  void write(const Frame& frame) override;

  bool wants_tracks() const override { return false; }

  /// All quantities, in a fixed order. Infinite where nothing was seen (no pair: no separation).
  std::vector<Measure> measures() const;

  /// How each vehicle got on at the end.
  const ProgressMetric& progress() const { return progress_; }

 private:
  RunMetrics(EncounterRules rules, const std::shared_ptr<const Surroundings>& surroundings,
             double progress_window)
      : neighbours_{math::fmax(rules.crit_dist_m, rules.safety_distance_m)},
        encounters_{rules},
        progress_{progress_window, surroundings},
        fleet_{rules.safety_distance_m, surroundings} {}

  std::size_t vehicles_{0};
  Neighbours neighbours_;
  std::vector<OfOneHand<std::vector<Neighbour>>> near_;  // of the vehicle that each hand is at
  EncounterMetric encounters_;
  ProgressMetric progress_;
  FleetMetric fleet_;
  EffortMetric effort_;
  SmoothnessMetric smoothness_;
};

/// Every quantity that RunMetrics reports.
std::vector<QuantityInfo> all_quantities();

}  // namespace fairway
