// SPDX-License-Identifier: Apache-2.0
// What people and missions ask of an avoider: goals, paths and services.
#include <cmath>

#include "ros/ros1/avoider_node.hpp"
#include "ros/ros1/conversions.hpp"

namespace fairway::ros1 {
namespace {

bool is_a_place(const bridge::Triple& position) {
  return std::isfinite(position[0]) && std::isfinite(position[1]) && std::isfinite(position[2]);
}

std::string bare(const std::string& frame_id) {
  return !frame_id.empty() && frame_id.front() == '/' ? frame_id.substr(1) : frame_id;
}

/// Why an order was not accepted, in words; empty if it was.
std::string refusal(bool accepted, const std::vector<bridge::Triple>& places, double speed) {
  if (accepted) return "";
  for (const bridge::Triple& place : places) {
    if (!is_a_place(place)) return "refused: a position is not a number";
  }
  if (!(speed > 0.0) || !std::isfinite(speed)) {
    return "refused: a speed of " + std::to_string(speed) + " m/s; expected more than 0";
  }
  return places.empty() ? "refused: no position is given" : "refused: out of what the avoider accepts";
}

}  // namespace

double AvoiderNode::speed_or_default(double speed) const {
  return speed == 0.0 ? settings_.speed_mps : speed;
}

/// A place in another frame than that of the own navigation is not what it seems to be.
bool AvoiderNode::is_told_here(const std::string& frame_id, const std::string& what) {
  if (frame_id.empty() || own_frame_.empty() || bare(frame_id) == bare(own_frame_)) return true;
  ROS_WARN_STREAM("a " << what << " in the frame '" << frame_id << "' is refused; own odometry is in '"
                       << own_frame_ << "'");
  return false;
}

/// In lockstep the instant is answered again, for the order may be what it waits for; unless it is over.
void AvoiderNode::order_changed() {
  if (!settings_.lockstep || !gate_.is_open() || ros::Time::now() > own_stamp_) return;
  answer(clock_.now(), own_stamp_);
}

void AvoiderNode::on_goal(const geometry_msgs::PoseStamped& goal) {
  if (!is_told_here(goal.header.frame_id, "goal")) return;
  const bridge::Triple position = place_of(goal.pose.position, settings_.frame);
  const std::string words =
      refusal(host_.go_to(position, settings_.speed_mps), {position}, settings_.speed_mps);
  if (!words.empty()) ROS_WARN_STREAM("goal: " << words);
  order_changed();
}

void AvoiderNode::on_path(const nav_msgs::Path& path) {
  if (!is_told_here(path.header.frame_id, "path")) return;
  std::vector<bridge::Triple> points;
  for (const geometry_msgs::PoseStamped& pose : path.poses) {
    points.push_back(place_of(pose.pose.position, settings_.frame));
  }
  const std::string words =
      refusal(host_.follow_path(points, settings_.speed_mps), points, settings_.speed_mps);
  if (!words.empty()) ROS_WARN_STREAM("path: " << words);
  order_changed();
}

bool AvoiderNode::go_to(fairway_ros::GoTo::Request& request, fairway_ros::GoTo::Response& response) {
  const bridge::Triple position = place_of(request.position, settings_.frame);
  const double speed = speed_or_default(request.speed_mps);
  response.message = refusal(host_.go_to(position, speed), {position}, speed);
  response.ok = response.message.empty();
  order_changed();
  return true;
}

bool AvoiderNode::follow_section(fairway_ros::Section::Request& request,
                                 fairway_ros::Section::Response& response) {
  const bridge::Triple start = place_of(request.start, settings_.frame);
  const bridge::Triple end = place_of(request.end, settings_.frame);
  const double speed = speed_or_default(request.speed_mps);
  response.message = refusal(host_.follow(start, end, speed), {start, end}, speed);
  response.ok = response.message.empty();
  order_changed();
  return true;
}

bool AvoiderNode::keep_position(std_srvs::Trigger::Request& /*request*/,
                                std_srvs::Trigger::Response& response) {
  host_.keep_position();
  response.success = true;
  response.message = "keeping the position where it is";
  order_changed();
  return true;
}

bool AvoiderNode::stand_by(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  host_.stand_by();
  response.success = true;
  response.message = "standing by: the vehicle is left to others";
  order_changed();
  return true;
}

}  // namespace fairway::ros1
