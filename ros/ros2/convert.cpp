// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/convert.hpp"

namespace fairway::ros2 {
namespace {

Header header_of(double time, const std::string& frame_id, Memory& memory) {
  return {stamp_of(time), memory.text(frame_id)};
}

}  // namespace

Time stamp_of(double seconds) { return bridge::stamp_before<Time>(2147483647.0, seconds); }

double seconds_of(const Time& stamp) {
  return static_cast<double>(stamp.sec) + static_cast<double>(stamp.nanosec) / 1e9;
}

Odometry odometry_of(const Motion& motion, Frame frame, const std::string& world, const std::string& child,
                     Memory& memory) {
  Odometry odometry{};
  odometry.header = header_of(motion.time, world, memory);
  odometry.child_frame_id = memory.text(child);
  put_motion(odometry, motion, frame);
  return odometry;
}

Motion motion_of(const Odometry& odometry, Frame frame) {
  return bridge::motion_of(odometry, seconds_of(odometry.header.stamp), frame);
}

TransformStamped transform_of(const Motion& motion, Frame frame, const std::string& world,
                              const std::string& child, Memory& memory) {
  TransformStamped transform{header_of(motion.time, world, memory), memory.text(child), {}};
  put_transform(transform.transform, motion, frame);
  return transform;
}

TwistStamped twist_of(const BodyVelocity& request, double time, Frame frame, const std::string& child,
                      Memory& memory) {
  TwistStamped twist{header_of(time, child, memory), {}};
  put_velocity(twist.twist, request, frame);
  return twist;
}

BodyVelocity body_velocity_of(const TwistStamped& twist, Frame frame) {
  return bridge::velocity_of(twist.twist, frame);
}

PoseStamped goal_of(const Triple& position_n, double time, Frame frame, const std::string& world,
                    Memory& memory) {
  PoseStamped goal{header_of(time, world, memory), {{}, {0, 0, 0, 1}}};
  bridge::put(goal.pose.position, world_in(frame, position_n));
  return goal;
}

MarkerArray markers_of(const std::vector<Mark>& marks, double time, Frame frame, const std::string& world,
                       const std::string& space, Memory& memory) {
  MarkerArray array{};
  const auto markers = memory.room(array.markers, marks.size() + 1);
  markers[0].header = header_of(time, world, memory);
  markers[0].ns = memory.text(space);
  markers[0].action = bridge::delete_all_markers;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Mark& mark = marks[i];
    Marker& marker = markers[i + 1];
    marker.header = markers[0].header;
    marker.ns = memory.text(bridge::name_space(space, mark));
    marker.text = memory.text(mark.words);
    put_mark(marker, mark, static_cast<int>(i), frame);
    if (!has_points(mark)) continue;
    const auto places = memory.room(marker.points, mark.points.size());
    for (std::size_t k = 0; k < places.size(); ++k) bridge::put(places[k], world_in(frame, mark.points[k]));
  }
  return array;
}

}  // namespace fairway::ros2
