// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "fairway/core/crew.hpp"
#include "fairway/core/limits.hpp"
#include "fairway/core/obstacle_index.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/core/shared.hpp"
#include "fairway/metrics/metric.hpp"
#include "fairway/metrics/neighbours.hpp"

namespace fairway {

/// What the frames of a run do not say, and its metrics need.
struct Surroundings {
  std::vector<DriftingObstacle> obstacles;  ///< whoever owns their vertices outlives the metrics
  std::vector<double> radii;                ///< of the vehicles' spheres, by index [m]; 0 where not given
  std::vector<Shared<Limits>> limits;  ///< of the vehicles, by index; able to do anything where not given
  std::vector<bool> keeps_pace;        ///< likewise: who goes no faster over ground than on its legs
};

/// What raja2024 does not measure: pair events, separation, makespan, arrivals, energy, holding, what
/// was commanded in vain. Each vehicle counts from when it has set out: from its first tick under way, or
/// from when it has arrived; then everybody whom it meets counts, those who still wait or deploy as well. Two
/// who have both not set out do not.
class FleetMetric final : public Metric {
 public:
  static const std::vector<QuantityInfo>& quantities();

  explicit FleetMetric(double safety_distance_m, Surroundings surroundings = {})
      : FleetMetric{safety_distance_m, std::make_shared<const Surroundings>(std::move(surroundings))} {}
  FleetMetric(double safety_distance_m, std::shared_ptr<const Surroundings> surroundings)
      : safety_distance_{safety_distance_m},
        surroundings_{std::move(surroundings)},
        neighbours_{safety_distance_m} {
    sort_obstacles();
  }
  void see(const Frame& frame) override;
  void begin(const Frame& frame, std::size_t hands);
  double reach(const Neighbours& near, std::size_t index) const;
  void see(const Frame& frame, std::span<const Neighbour> near, std::size_t index, std::size_t hand);
  void finish(const Frame& frame);
  void report(std::vector<Measure>& measures) const override;

 private:
  static constexpr double never = std::numeric_limits<double>::quiet_NaN();

  struct Own {
    double energy{};
    double hold_time{};
    double unattainable_time{};
    double nearest2{std::numeric_limits<double>::infinity()};
    double clearance{std::numeric_limits<double>::infinity()};
    int infeasible{};
    bool arrived{};
    bool takes_part{};                      ///< it has set out
    int nearest_other{Occasion::none};      ///< with whom `nearest2` was so
    int nearest_obstacle{Occasion::none};   ///< likewise `clearance`
    double nearest_time{never};             ///< when
    double clearance_time{never};           ///< likewise
    double first_infeasible_time{never};    ///< the first of `infeasible`
    double first_unattainable_time{never};  ///< likewise of `unattainable_time`

    Occasion nearest_at() const { return {.other = nearest_other, .time = nearest_time}; }
    Occasion clearance_at() const { return {.obstacle = nearest_obstacle, .time = clearance_time}; }
  };

  bool is_beyond(const VehicleFrame& vehicle, std::size_t index) const;

  /// Two vehicles within the safety distance, the one of the lesser index first.
  struct Pair {
    std::uint32_t one;
    std::uint32_t other;
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };

  /// What one hand has found in a frame.
  struct Hand {
    std::vector<Pair> touch;
    bool somebody_goes{};  // or has just arrived
  };

  void sort_obstacles();
  bool see_vehicle(const Frame& frame, std::size_t index);
  void see_obstacles(const Frame& frame, std::size_t index);
  void see_others(const Frame& frame, std::span<const Neighbour> near, std::size_t index,
                  std::vector<Pair>& touch);
  void see_pairs(const Frame& frame);
  double makespan() const;
  Occasion not_arrived() const;  ///< the first vehicle that did not arrive

  double safety_distance_;
  std::shared_ptr<const Surroundings> surroundings_;
  ObstacleIndex standing_;                 ///< obstacles that stand still, where they are many
  std::vector<std::uint32_t> one_by_one_;  ///< the others
  std::size_t taking_part_{0};             ///< so many have set out
  bool somebody_went_{false};
  double start_time_{};
  double last_arrival_{};
  double last_time_{};
  int pair_events_{};
  Occasion first_pair_event_;
  std::vector<Own> own_;
  Neighbours neighbours_;
  std::vector<Pair> touching_;          ///< as of the last frame, ascending
  std::vector<OfOneHand<Hand>> hands_;  ///< of this one
  std::vector<Neighbour> near_;         ///< memory to work in
};

}  // namespace fairway
