// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_node.hpp"

#include <fairway_ros/GoTo.h>
#include <fairway_ros/Section.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Trigger.h>

#include <algorithm>

#include "ros/ros1/master_watch.hpp"

namespace fairway::ros1 {

AvoiderNode::AvoiderNode(const bridge::AvoiderNodeSettings& settings)
    : bridge::AvoiderNode<Middleware>{settings, settings.lockstep || ros::Time::isSimTime()} {
  offer_services();
  hear_orders();
  hear_fleet();
  if (settings.test_hooks)
    graph_.subscribe<std_msgs::Float64>("test_hang", Keep::newest, [](const std_msgs::Float64& m) {
      ros::WallDuration{std::clamp(m.data, 0.0, 60.0)}.sleep();
    });
}

void AvoiderNode::offer_services() {
  const auto place = [frame = settings_.frame](const geometry_msgs::Point& point) {
    return bridge::place_of(point, frame);
  };
  graph_.offer<fairway_ros::GoTo>("go_to", [this, place](const auto& request, auto& response) {
    response.message = duty_.go_to(place(request.position), "", 0.0, request.speed_mps);
    response.ok = response.message.empty();
  });
  graph_.offer<fairway_ros::Section>("section", [this, place](const auto& request, auto& response) {
    response.message = duty_.follow_section(place(request.start), place(request.end), request.speed_mps);
    response.ok = response.message.empty();
  });
  graph_.offer<std_srvs::Trigger>("keep_position", [this](const auto&, auto& response) {
    duty_.keep_position();
    response.success = true;
    response.message = "keeping the position where it is";
  });
  graph_.offer<std_srvs::Trigger>("stand_by", [this](const auto&, auto& response) {
    duty_.stand_by();
    response.success = true;
    response.message = "standing by: the vehicle is left to others";
  });
}

void AvoiderNode::run() {
  const MasterWatch master{graph_.services()};
  bridge::AvoiderNode<Middleware>::run([] { return ros::ok(); });
}

std::optional<double> AvoiderNode::now() const {
  return bridge::seconds_of(Middleware::nanoseconds(ros::Time::now()));
}

void AvoiderNode::warn(const std::string& words) { ROS_WARN_STREAM(words); }

}  // namespace fairway::ros1
