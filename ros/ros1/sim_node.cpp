// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/sim_node.hpp"

#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <iostream>

namespace fairway::ros1 {
namespace {

constexpr const char* world = "world";
constexpr double goal_head_start_s = 0.02;

}  // namespace

SimNode::SimNode(const bridge::FleetNodeSettings& settings)
    : duty_{settings}, marks_{duty_.fleet()}, ports_(duty_.fleet().size()) {
  node_.setCallbackQueue(&queue_);
  advertise();
}

void SimNode::advertise() {
  clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
  transforms_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
  markers_ = node_.advertise<visualization_msgs::MarkerArray>("/fairway/markers", 2);
  state_ = node_.advertise<std_msgs::String>("/fairway/state", 10, true);
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    Port& port = ports_[i];
    const std::string name = "/" + duty_.fleet().vehicle(i).topic;
    port.odometry = node_.advertise<nav_msgs::Odometry>(name + "/odometry", 100);
    port.truth = node_.advertise<nav_msgs::Odometry>(name + "/ground_truth", 100);
    port.goal = node_.advertise<geometry_msgs::PoseStamped>(name + "/goal", 10, true);
    if (duty_.settings().autonomous) continue;
    const auto listen = [this, i](const geometry_msgs::TwistStampedConstPtr& twist) {
      duty_.command(i, body_velocity_of(*twist, duty_.settings().frame),
                    static_cast<std::int64_t>(twist->header.stamp.toNSec()));
    };
    port.command = node_.subscribe<geometry_msgs::TwistStamped>(name + "/velocity_command", 100, listen,
                                                                nullptr, ros::TransportHints().tcpNoDelay());
  }
  offer_service("pause", &SimNode::pause);
  offer_service("resume", &SimNode::resume);
  offer_service("step", &SimNode::step_once);
  // a new master has forgotten that time is the simulation's
  const auto set_time = [] { ros::param::set("/use_sim_time", true); };
  set_time();
  std::vector<std::string> services;
  for (const ros::ServiceServer& service : services_) services.push_back(service.getService());
  watch_ = std::make_unique<MasterWatch>(services, set_time);
}

void SimNode::offer_service(const std::string& name, bool (SimNode::*answer)(std_srvs::Trigger::Response&)) {
  using Trigger = std_srvs::Trigger;
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> call =
      [this, answer](Trigger::Request&, Trigger::Response& response) { return (this->*answer)(response); };
  services_.push_back(node_.advertiseService("/fairway/" + name, call));
}

bool SimNode::pause(std_srvs::Trigger::Response& response) {
  response.success = static_cast<std::uint8_t>(duty_.pause());
  response.message = "paused";
  return true;
}

bool SimNode::resume(std_srvs::Trigger::Response& response) {
  const bool goes = duty_.resume();
  response.success = static_cast<std::uint8_t>(goes);
  response.message = goes ? "resumed" : "the run is over";
  return true;
}

bool SimNode::step_once(std_srvs::Trigger::Response& response) {
  const bool steps = duty_.step_once();
  response.success = static_cast<std::uint8_t>(steps);
  response.message = duty_.fleet().is_done() ? "the run is over" : steps ? "stepped" : "it is not paused";
  return true;
}

int SimNode::run() { return duty_.run(*this); }

void SimNode::show_clock(double time) {
  rosgraph_msgs::Clock clock;
  clock.clock = stamp_of(time);
  clock_.publish(clock);
}

void SimNode::show_goal(std::size_t vehicle, const Triple& goal, double time) {
  ports_[vehicle].goal.publish(goal_of(goal, time, duty_.settings().frame, world));
}

/// A goal and the odometry travel by different connections: who answers this very instant should know both.
void SimNode::deliver_goals() {
  if (duty_.settings().lockstep) ros::WallDuration(goal_head_start_s).sleep();
}

void SimNode::show_navigation() {
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const bridge::FleetVehicle& vehicle = duty_.fleet().vehicle(i);
    ports_[i].odometry.publish(odometry_of(vehicle.estimate, duty_.settings().frame, world, vehicle.topic));
  }
}

void SimNode::show_truth() {
  const Frame frame = duty_.settings().frame;
  tf2_msgs::TFMessage transforms;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const bridge::FleetVehicle& vehicle = duty_.fleet().vehicle(i);
    ports_[i].truth.publish(odometry_of(vehicle.truth, frame, world, vehicle.topic));
    transforms.transforms.push_back(transform_of(vehicle.truth, frame, world, vehicle.topic));
  }
  transforms_.publish(transforms);
  marks_.see(duty_.fleet());
}

void SimNode::show_state(const std::string& json) {
  std_msgs::String state;
  state.data = json;
  state_.publish(state);
}

void SimNode::show_picture() {
  if (markers_.getNumSubscribers() == 0) return;
  markers_.publish(
      markers_of(marks_.draw(duty_.fleet()), duty_.fleet().time(), duty_.settings().frame, world));
}

std::size_t SimNode::listeners(std::size_t vehicle) { return ports_[vehicle].odometry.getNumSubscribers(); }

bool SimNode::is_steered(std::size_t vehicle) { return ports_[vehicle].command.getNumPublishers() > 0; }

void SimNode::handle(double longest) { queue_.callAvailable(ros::WallDuration(longest)); }

bool SimNode::goes_on() { return ros::ok(); }

void SimNode::warn(const std::string& words) {
  if (ros::ok()) {
    ROS_WARN_STREAM(words);
  } else {
    std::cerr << "fairway_sim: " << words << "\n";
  }
}

}  // namespace fairway::ros1
