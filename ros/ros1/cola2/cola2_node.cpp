// SPDX-License-Identifier: Apache-2.0
// fairway_cola2: between a vehicle under COLA2 and its fairway_avoider. Built where cola2_msgs is installed.
#include <cola2_msgs/BodyVelocityReq.h>
#include <cola2_msgs/NavSts.h>
#include <ros/ros.h>

#include <cstdio>
#include <stdexcept>

#include "ros/ros1/cola2/adapter.hpp"

namespace {

using namespace fairway;
using ros1::cola2::CommandKeeper;
using ros1::cola2::SteeredAxes;

SteeredAxes steered_axes(const ros::NodeHandle& settings) {
  const std::string words = settings.param<std::string>("axes", "surge sway heave yaw");
  if (const auto axes = ros1::cola2::axes_of(words)) return *axes;
  throw std::runtime_error("~axes: '" + words + "'; expected some of surge, sway, heave, yaw");
}

int priority_of(const ros::NodeHandle& settings) {
  int priority{};
  if (!settings.getParam("priority", priority)) {
    throw std::runtime_error("~priority is missing: above that of missions, below that of the operator");
  }
  return priority;
}

void run() {
  ros::NodeHandle vehicle;
  const ros::NodeHandle settings{"~"};
  const int priority = priority_of(settings);
  const SteeredAxes axes = steered_axes(settings);
  const bridge::Frame frame = bridge::frame_of(settings.param<std::string>("frame", "ned"));
  const std::string requester = settings.param<std::string>("requester", "fairway_avoider");
  const std::string world = settings.param<std::string>("world", "world");
  const std::string name = settings.param<std::string>("vehicle", "vehicle");
  CommandKeeper keeper{settings.param("timeout_s", 0.5)};

  ros::Publisher odometry = vehicle.advertise<nav_msgs::Odometry>("odometry", 1);
  ros::Publisher requests = vehicle.advertise<cola2_msgs::BodyVelocityReq>(
      settings.param<std::string>("request_topic", "controller/body_velocity_req"), 1);
  const ros::TransportHints at_once = ros::TransportHints().tcpNoDelay();
  const auto ask = [&] {
    const ros::Time now = ros::Time::now();
    if (const auto command = keeper.at(now.toSec())) {
      requests.publish(
          ros1::cola2::request_of<cola2_msgs::BodyVelocityReq>(*command, axes, requester, priority, now));
    }
  };
  const boost::function<void(const cola2_msgs::NavStsConstPtr&)> on_navigation =
      [&](const cola2_msgs::NavStsConstPtr& message) {
        odometry.publish(ros1::Writer{frame, world}.odometry(ros1::cola2::motion_from(*message), name));
      };
  const boost::function<void(const geometry_msgs::TwistStampedConstPtr&)> on_command =
      [&](const geometry_msgs::TwistStampedConstPtr& message) {
        keeper.hear(bridge::velocity_of(message->twist, frame), ros::Time::now().toSec());
        ask();
      };
  const ros::Subscriber navigation = vehicle.subscribe<cola2_msgs::NavSts>(
      settings.param<std::string>("navigation_topic", "navigator/navigation"), 1, on_navigation,
      ros::VoidConstPtr{}, at_once);
  const ros::Subscriber command = vehicle.subscribe<geometry_msgs::TwistStamped>(
      "velocity_command", 1, on_command, ros::VoidConstPtr{}, at_once);
  const ros::Timer refresh = vehicle.createTimer(ros::Duration{1.0 / settings.param("rate_hz", 10.0)},
                                                 [&](const ros::TimerEvent&) { ask(); });
  ros::spin();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "fairway_cola2");
    run();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fairway_cola2: %s\n", error.what());
    return 2;
  }
}
