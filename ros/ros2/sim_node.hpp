// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "ros/bridge/fleet_duty.hpp"
#include "ros/bridge/fleet_marks.hpp"
#include "ros/ros2/convert.hpp"
#include "ros/ros2/graph.hpp"

namespace fairway::ros2 {

/// `fairway_sim_ros2`: a scenario as a live fleet in a ROS 2 graph. Topics and settings are on docs/ros2.md.
class SimNode final : public bridge::FleetOutlet {
 public:
  /// Throws std::runtime_error, in one line, for a scenario that cannot be used.
  SimNode(const bridge::FleetNodeSettings& settings, const GraphOptions& options);

  /// As FleetDuty::run(), or until `stop`.
  int run(const std::atomic<bool>& stop);

  void show_clock(double time) override;
  void show_goal(std::size_t vehicle, const Triple& goal, double time) override;
  void deliver_goals() override;
  void show_navigation() override;
  void show_truth() override;
  void show_state(const std::string& json) override;
  void show_picture() override;
  std::size_t listeners(std::size_t vehicle) override;
  bool is_steered(std::size_t vehicle) override;
  void handle(double longest) override;
  bool goes_on() override;
  void warn(const std::string& words) override;

 private:
  struct Port {
    std::string name;
    Publisher<Odometry> odometry, truth;
    Publisher<PoseStamped> goal;
  };

  void advertise();
  void subscribe();

  bridge::FleetDuty duty_;
  bridge::FleetMarks marks_;
  Graph graph_;
  std::vector<Port> ports_;  // by vehicle
  Publisher<Clock> clock_;
  Publisher<TFMessage> transforms_;
  Publisher<MarkerArray> markers_;
  Publisher<String> state_;
  const std::atomic<bool>* stop_{};
};

}  // namespace fairway::ros2
