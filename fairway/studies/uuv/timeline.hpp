// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "fairway/metrics/measure.hpp"
#include "fairway/record/frame.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway::uuv {

/// What one vehicle did when. docs/studies/uuv.md has the definitions at length.
struct Events {
  std::optional<double> aside;      ///< first more than 3 degrees off the straight way to the goal [s]
  std::optional<double> slow_down;  ///< first below 97 % of the greatest speed it had had [s]
  double pass{};                    ///< nearest to the other vehicle [s]
  double slowest{};                 ///< of least speed from `slow_down`, or `aside`, to `resume` [s]
  double least_speed{};             ///< then [m/s]
  std::optional<double> turn_back;  ///< farthest from the straight line from start to goal [s]
  std::optional<double>
      resume;  ///< from here on for good at 97 % of the wanted speed and within 3 degrees [s]
  std::optional<double> arrive;  ///< [s]
  bool keeps_right{};            ///< the other is to port as they pass
};

/// Follows a run of two or more vehicles and drifting spheres, and finds the events of each. Its memory grows
/// with the run.
class Timeline final : public FrameSink {
 public:
  /// Takes radii and drifting spheres from the scenario.
  explicit Timeline(const Scenario& scenario);

  void write(const Frame& frame) override;

  /// The events of vehicle `index`, complete when the run has ended.
  Events events(std::size_t index) const;

  /// The events of all vehicles as measures: "slow_down_time_s" and so on, of what happened; for the fleet
  /// `vehicle_gap_m`, `ship_gap_m` (where there are ships), `contact_count`, `keeps_right_ratio`.
  void report(std::vector<Measure>& measures) const;

 private:
  struct Sample {
    double time{};
    Vec2 position{0.0, 0.0};
    Vec2 velocity{0.0, 0.0};
    Vec2 goal{0.0, 0.0};
    double wanted_speed{};
    double nearest{};        ///< distance to the nearest other vehicle [m]
    Vec2 towards{0.0, 0.0};  ///< from here to it
    bool arrived{};
  };
  using Way = std::vector<Sample>;

  void see_vehicle(const Frame& frame, std::size_t index);
  void see_ships(const Frame& frame, std::size_t index);

  std::vector<double> radii_;
  std::vector<ObstacleSpec> ships_;
  std::vector<Way> ways_;
  // least distance between the spheres of any two vehicles, and of a vehicle and a ship; negative once they
  // touched [m]
  double vehicle_gap_;
  double ship_gap_;
};

}  // namespace fairway::uuv
