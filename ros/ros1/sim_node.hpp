// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <geometry_msgs/TwistStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <string>
#include <vector>

#include "ros/bridge/fleet_duty.hpp"
#include "ros/bridge/fleet_marks.hpp"
#include "ros/ros1/conversions.hpp"
#include "ros/ros1/master_watch.hpp"

namespace fairway::ros1 {

/// `fairway_sim`: a scenario as a live fleet in a ROS graph. Topics, services and parameters are on
/// docs/ros.md. One thread: what comes in is handled between the steps.
class SimNode final : bridge::FleetOutlet {
 public:
  /// Throws std::runtime_error, in one line, for a scenario that cannot be used.
  explicit SimNode(const bridge::FleetNodeSettings& settings);

  /// Until the run is done, if it is to end with it, or until ROS is shut down. The exit code of the program:
  /// as of FleetDuty::run().
  int run();

 private:
  struct Port {
    ros::Publisher odometry, truth, goal;
    ros::Subscriber command;
  };

  void advertise();
  void offer_service(const std::string& name, bool (SimNode::*answer)(std_srvs::Trigger::Response&));
  bool pause(std_srvs::Trigger::Response& response);
  bool resume(std_srvs::Trigger::Response& response);
  bool step_once(std_srvs::Trigger::Response& response);

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

  bridge::FleetDuty duty_;
  bridge::FleetMarks marks_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::vector<Port> ports_;  // by vehicle
  std::vector<ros::ServiceServer> services_;
  ros::Publisher clock_, transforms_, markers_, state_;
  std::unique_ptr<MasterWatch> watch_;
};

}  // namespace fairway::ros1
