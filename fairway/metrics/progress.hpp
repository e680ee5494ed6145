// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/avoidance/progress.hpp"
#include "fairway/core/crew.hpp"
#include "fairway/metrics/fleet.hpp"
#include "fairway/metrics/neighbours.hpp"

namespace fairway {

/// How long vehicles under way made no progress, and for how much of that they stood before each other
/// (fairway/avoidance/progress.hpp), from where they truly were. A bystander clears the way unless it has
/// arrived; a drifting obstacle always moves on.
class ProgressMetric final : public Metric {
 public:
  static const std::vector<QuantityInfo>& quantities();

  /// `window` [s].
  explicit ProgressMetric(double window, Surroundings surroundings = {})
      : ProgressMetric{window, std::make_shared<const Surroundings>(std::move(surroundings))} {}
  ProgressMetric(double window, std::shared_ptr<const Surroundings> surroundings);
  void see(const Frame& frame) override;
  void begin(const Frame& frame, std::size_t hands);
  void see(const Frame& frame, std::size_t index, std::size_t hand);
  void finish(const Frame& frame, const Neighbours& near);
  void report(std::vector<Measure>& measures) const override;

  /// How a vehicle got on, as of the last frame; only after one. `with` is the index of a vehicle or, from
  /// the number of vehicles on, of an obstacle. O(1).
  const ProgressReport& state(std::size_t index) const { return own_[index].report; }

  /// Whom `state(index)` is about: its vehicle, the other or the obstacle, and since when.
  Occasion occasion(std::size_t index) const;

 private:
  struct Own {
    ProgressWatch watch;
    ProgressReport report;
    double no_progress_time{};
    double deadlock_time{};
    double counted_until{};  ///< of `deadlock_time`
    Occasion last_without;   ///< the last stretch of `no_progress_time`
    Occasion last_deadlock;  ///< likewise
  };

  Goal goal_of(const Frame& frame, std::size_t index) const;
  double radius_of(std::size_t index) const;
  void find_bystanders(const Frame& frame, std::size_t index, const Neighbours& near);
  void count(const Frame& frame, std::size_t index);

  double window_;
  std::shared_ptr<const Surroundings> surroundings_;
  double largest_radius_{};  // of a vehicle [m]
  Neighbours neighbours_;
  std::vector<Own> own_;
  std::vector<OfOneHand<std::vector<std::uint32_t>>>
      late_;                           // of this frame, found by each hand: whom it matters who is near
  std::vector<Bystander> bystanders_;  // of whoever is judged
};

/// "no progress since 43.2 s: deadlocked with robot2", `with` being what `report.with` is called; empty of a
/// vehicle that makes progress, or is not meant to.
std::string text_of(const ProgressReport& report, std::string_view with);

}  // namespace fairway
