// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "ros/bridge/avoider_duty.hpp"
#include "ros/ros2/convert.hpp"
#include "ros/ros2/graph.hpp"

namespace fairway::ros2 {

/// `fairway_avoider_ros2`: the avoider of one vehicle in a ROS 2 graph. Topics and settings are on
/// docs/ros2.md.
class AvoiderNode final : public bridge::AvoiderOutlet {
 public:
  /// In the vehicle's namespace. Throws std::runtime_error, in one line, for settings that cannot be used.
  AvoiderNode(const bridge::AvoiderNodeSettings& settings, const GraphOptions& options);

  /// Until `stop`.
  void run(const std::atomic<bool>& stop);

  void send_command(const BodyVelocity& velocity, double time) override;
  void send_record(const std::vector<std::uint8_t>& bytes) override;
  void send_status(const std::string& json) override;
  void send_diagnosis(const bridge::Diagnosis& diagnosis, double time) override;
  void send_marks(const std::vector<Mark>& marks, double time) override;
  void warn(const std::string& words) override;

 private:
  void advertise();
  void subscribe();
  void hear_mate(std::size_t mate);
  /// The graph's now [s]; nothing before the first of a simulation's clock.
  std::optional<double> clock() const;

  bridge::AvoiderNodeSettings settings_;
  bool simulated_;
  std::string world_{"world"};         // of the own odometry, as soon as it is known
  std::atomic<double> simulated_now_;  // of /clock [s]; NaN before the first
  bridge::AvoiderDuty duty_;
  Graph graph_;
  Publisher<TwistStamped> command_;
  Publisher<DiagnosticArray> diagnostics_;
  Publisher<String> status_;
  Publisher<UInt8MultiArray> record_;
  Publisher<MarkerArray> sketch_;
};

}  // namespace fairway::ros2
