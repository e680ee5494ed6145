// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/sim_node.hpp"

#include <std_srvs/Trigger.h>

#include <iostream>

#include "ros/ros1/master_watch.hpp"

namespace fairway::ros1 {

SimNode::SimNode(const bridge::FleetNodeSettings& settings) : bridge::FleetNode<Middleware>{settings} {
  hear_commands();
  offer_services();
}

void SimNode::offer_services() {
  graph_.offer<std_srvs::Trigger>("/fairway/pause", [this](const auto&, auto& response) {
    response.success = duty_.pause();
    response.message = "paused";
  });
  graph_.offer<std_srvs::Trigger>("/fairway/resume", [this](const auto&, auto& response) {
    response.success = duty_.resume();
    response.message = response.success ? "resumed" : "the run is over";
  });
  graph_.offer<std_srvs::Trigger>("/fairway/step", [this](const auto&, auto& response) {
    response.success = duty_.step_once();
    response.message = duty_.fleet().is_done() ? "the run is over"
                       : response.success      ? "stepped"
                                               : "it is not paused";
  });
}

int SimNode::run() {
  // a new master has forgotten that time is the simulation's
  const auto set_time = [] { ros::param::set("/use_sim_time", true); };
  set_time();
  const MasterWatch master{graph_.services(), set_time};
  return bridge::FleetNode<Middleware>::run([] { return ros::ok(); });
}

/// A goal and the odometry travel by different connections: who answers this very instant should know both.
/// No connection says when it has delivered, so the goal gets a head start that a busy machine rarely
/// exceeds.
void SimNode::deliver_goals() {
  constexpr double head_start_s = 0.2;
  if (duty_.settings().lockstep) ros::WallDuration(head_start_s).sleep();
}

void SimNode::warn(const std::string& words) {
  if (ros::ok()) {
    ROS_WARN_STREAM(words);
  } else {
    std::cerr << "fairway_sim: " << words << "\n";
  }
}

}  // namespace fairway::ros1
