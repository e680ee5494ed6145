// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "fairway/metrics/measure.hpp"
#include "fairway/planning/minimum_snap/trajectory.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::transport {

/// What the publication says of a run and no general metric does: forces commanded at the beginning, at their
/// greatest and as each obstacle is detected, when the goal is reached, how well a trajectory is followed.
/// The log of the first vehicle. Quantities are those of transport_case.cpp; one that did not happen is not
/// reported.
class VoyageLog final : public FrameSink {
 public:
  /// `reference` is what the vehicle should follow from time 0; it outlives this.
  VoyageLog(const Scenario& scenario, const Trajectory* reference);

  void write(const Frame& frame) override;
  void report(std::vector<Measure>& measures) const;

 private:
  struct Detection {
    double surge_force{};
    double sway_force{};
  };

  void see_forces(const Frame& frame);
  void see_detection(const VehicleFrame& vehicle);
  void see_progress(const Frame& frame);
  void see_danger(const Frame& frame);

  std::vector<ObstacleSpec> specs_;
  std::vector<Obstacle> obstacles_;
  double sight_;  ///< at which what is not charted is perceived [m]
  std::vector<bool> in_sight_;
  Vec3 surprised_at_ = Vec3::Zero();  ///< where it was when something last came into sight
  double surprise_time_{};
  std::optional<bool> touched_with_a_way_out_;
  Vec3 goal_;
  const Trajectory* reference_;

  std::optional<Wrench> first_;
  Wrench greatest_ = Wrench::Zero();
  std::vector<std::optional<Detection>> detections_;  ///< by obstacle
  std::optional<double> switch_distance_;
  bool avoiding_{false};
  std::optional<double> goal_time_;
  Vec3 square_error_ = Vec3::Zero();
  double followed_time_{};
};

/// The trajectory through the method's `waypoints` with its `segment_time_s`, if it has both.
std::optional<Trajectory> printed_reference(const VehicleSpec& vehicle);

/// Runs a scenario under every metric and the log; `net_power_w` is the sum of the rms powers along surge,
/// sway and yaw, as the publication adds them; `more` sinks see the same frames. Throws RunAbandoned once
/// `stop` is true.
std::vector<Measure> measure_voyage(const Scenario& scenario, const Catalogs& catalogs,
                                    const std::atomic<bool>* stop, std::span<FrameSink* const> more = {});

}  // namespace fairway::transport
