// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fairway_ros/GoTo.h>
#include <fairway_ros/Section.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_msgs/UInt8MultiArray.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ros/bridge/avoider_host.hpp"
#include "ros/ros1/avoider_clock.hpp"
#include "ros/ros1/avoider_gate.hpp"
#include "ros/ros1/avoider_settings.hpp"
#include "ros/ros1/markers.hpp"

namespace fairway::ros1 {

/// `fairway_avoider`: the avoider of one vehicle in a ROS graph. Topics and parameters are on
/// docs/ros_avoider.md.
class AvoiderNode {
 public:
  /// In the vehicle's namespace. Throws std::runtime_error, in one line, for settings that cannot be used.
  AvoiderNode(const ros::NodeHandle& vehicle, const AvoiderSettings& settings);

  /// Until ROS is shut down.
  void run();

  /// Full names of what it offers: a master that was restarted has to be told of them.
  std::vector<std::string> services() const;

 private:
  void advertise();
  void subscribe();
  void hear_mate(std::size_t mate, const std::string& topics, std::uint32_t kept);
  template <class Message, class Listener>
  void hear(ros::NodeHandle& whose, const std::string& topic, std::uint32_t kept, Listener listener);

  void on_own_odometry(const nav_msgs::Odometry& odometry);
  void on_mate_odometry(std::size_t mate, const nav_msgs::Odometry& odometry);
  void on_record(const std_msgs::UInt8MultiArray& record);
  void on_goal(const geometry_msgs::PoseStamped& goal);
  void on_path(const nav_msgs::Path& path);
  bool go_to(fairway_ros::GoTo::Request& request, fairway_ros::GoTo::Response& response);
  bool follow_section(fairway_ros::Section::Request& request, fairway_ros::Section::Response& response);
  bool keep_position(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool stand_by(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  bool judge_own(const bridge::Motion& motion, double now);
  void judge_mate(std::size_t mate, const bridge::Motion& motion, double now);
  bool judge(const std::string& whose, const std::string& verdict);
  bool is_told_here(const std::string& frame_id, const std::string& what);
  double speed_or_default(double speed) const;
  void order_changed();

  void answer_together();
  void answer_now();
  void answer(double now, const ros::Time& stamp);
  void show_marks();
  void tell_team(double now);
  void report(bool at_once);
  void raise_alarm(double stood_still);

  AvoiderSettings settings_;
  std::string vehicle_;
  bridge::AvoiderHost host_;
  AvoiderClock clock_;
  AvoiderGate gate_;  // vehicle 0 is the own one
  ros::CallbackQueue queue_, mates_queue_;
  ros::NodeHandle vehicle_node_, mates_node_;
  MarkerSet marks_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Publisher command_, diagnostics_, status_, record_, sketch_;

  std::string own_frame_;        // of the own odometry, empty before the first
  ros::Time own_stamp_;          // in lockstep: of the own odometry
  double next_record_{};         // [s]
  std::string reported_;         // state and reason last reported
  bridge::Diagnosis diagnosis_;  // last looked at
  ros::SteadyTime looked_, diagnosed_, drawn_;
  std::atomic<std::int64_t> alarms_{0};
  std::atomic<bool> in_charge_{false};
};

}  // namespace fairway::ros1
