// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <geometry_msgs/TwistStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros/bridge/fleet_host.hpp"
#include "ros/ros1/fleet_markers.hpp"
#include "ros/ros1/master_watch.hpp"
#include "ros/ros1/sim_settings.hpp"

namespace fairway::ros1 {

/// `fairway_sim`: a scenario as a live fleet in a ROS graph. Topics, services and parameters are on
/// docs/ros.md. One thread: what comes in is handled between the steps.
class SimNode {
 public:
  /// Throws std::runtime_error, in one line, for a scenario that cannot be used.
  explicit SimNode(SimSettings settings);

  /// Until the run is done, if it is to end with it, or until ROS is shut down. The exit code of the program:
  /// 0 if all that the scenario expects is so, 1 if not, 130 if it was interrupted before its end.
  int run();

 private:
  using Steady = ros::SteadyTime;

  struct Port {
    ros::Publisher odometry, truth, goal;
    ros::Subscriber command;
    std::optional<Triple> shown_goal;   ///< [m, NED]
    std::optional<ros::Time> answered;  ///< stamp of the command last taken
  };

  void advertise();
  void offer_service(const std::string& name, bool (SimNode::*answer)(std_srvs::Trigger::Response&));
  void on_command(std::size_t index, const geometry_msgs::TwistStamped& twist);
  bool pause(std_srvs::Trigger::Response& response);
  bool resume(std_srvs::Trigger::Response& response);
  bool step_once(std_srvs::Trigger::Response& response);

  void await_subscribers();
  void show_instant();
  bool show_goals();
  void await_turn();
  void await_permission();
  void await_commands();
  void await_clock();
  bool all_answered() const;
  std::string missing() const;
  void spin(double seconds);
  void tend();
  void show_state();
  std::string state_json() const;

  SimSettings settings_;
  bridge::FleetHost fleet_;
  FleetMarkers marks_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::vector<Port> ports_;  // by vehicle
  std::vector<ros::ServiceServer> services_;
  ros::Publisher clock_, transforms_, markers_, state_;
  std::unique_ptr<MasterWatch> watch_;

  ros::Time now_;         // of the instant, as in every stamp of it
  std::string shown_;     // what of the state is reported at once when it changes
  Steady begin_;          // of the run, on the wall
  Steady anchor_;         // when the run was at anchor_time_
  double anchor_time_{};  // [s]
  double behind_s_{};     // wall time that it could not keep up with
  Steady tended_, drawn_;
  std::uint64_t missed_{};   // instants of lockstep that went on without a command
  std::uint64_t refused_{};  // commands that were not finite, or of another time
  std::uint64_t steps_{};    // to be made though it is paused
  bool paused_{};
};

}  // namespace fairway::ros1
