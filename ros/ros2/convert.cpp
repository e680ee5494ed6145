// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/convert.hpp"

namespace fairway::ros2 {
namespace {

// of visualization_msgs/Marker
constexpr std::int32_t sphere = 2, line_strip = 4, points = 8, triangle_list = 11;
constexpr std::int32_t delete_all = 3;

constexpr double line_width = 0.05, point_width = 0.15;  // [m]

Vector3 vector_of(const Triple& v) { return {v[0], v[1], v[2]}; }
Point point_of(const Triple& v) { return {v[0], v[1], v[2]}; }
Quaternion orientation_of(const bridge::Quaternion& q) { return {q[1], q[2], q[3], q[0]}; }

template <class Message>
Triple triple_of(const Message& v) {
  return {v.x, v.y, v.z};
}

Header header_of(double time, const std::string& frame_id, Memory& memory) {
  return {stamp_of(time), memory.text(frame_id)};
}

std::int32_t type_of(Mark::Kind kind) {
  switch (kind) {
    case Mark::Kind::line:
      return line_strip;
    case Mark::Kind::points:
      return points;
    case Mark::Kind::sphere:
      return sphere;
    case Mark::Kind::triangles:
      return triangle_list;
  }
  return line_strip;
}

Vector3 scale_of(const Mark& mark) {
  switch (mark.kind) {
    case Mark::Kind::line:
      return {line_width, 0, 0};
    case Mark::Kind::points:
      return {point_width, point_width, 0};
    case Mark::Kind::sphere:
      return {2 * mark.radius, 2 * mark.radius, 2 * mark.radius};
    case Mark::Kind::triangles:
      return {1, 1, 1};
  }
  return {1, 1, 1};
}

}  // namespace

Time stamp_of(double seconds) {
  if (!(seconds >= 0.0 && seconds < 2147483647.0)) return {};
  const double whole = std::floor(seconds);
  const auto nanoseconds = static_cast<std::uint32_t>(std::lround((seconds - whole) * 1e9));
  const auto second = static_cast<std::int32_t>(whole);
  return nanoseconds == 1000000000U ? Time{second + 1, 0U} : Time{second, nanoseconds};
}

double seconds_of(const Time& stamp) {
  return static_cast<double>(stamp.sec) + static_cast<double>(stamp.nanosec) / 1e9;
}

Point place_of(const Triple& position_n, Frame frame) { return point_of(world_in(frame, position_n)); }
Triple place_of(const Point& point, Frame frame) { return world_in(frame, triple_of(point)); }

Odometry odometry_of(const Motion& motion, Frame frame, const std::string& world, const std::string& child,
                     Memory& memory) {
  const Motion shown = motion_in(frame, motion);
  Odometry odometry{};
  odometry.header = header_of(motion.time, world, memory);
  odometry.child_frame_id = memory.text(child);
  odometry.pose.pose = {point_of(shown.position_n), orientation_of(shown.q_nb)};
  odometry.twist.twist = {vector_of(shown.v_b), vector_of(shown.omega_b)};
  return odometry;
}

Motion motion_of(const Odometry& odometry, Frame frame) {
  const auto& [position, q] = odometry.pose.pose;
  const auto& [linear, angular] = odometry.twist.twist;
  return motion_in(frame, {seconds_of(odometry.header.stamp),
                           triple_of(position),
                           {q.w, q.x, q.y, q.z},
                           triple_of(linear),
                           triple_of(angular)});
}

TransformStamped transform_of(const Motion& motion, Frame frame, const std::string& world,
                              const std::string& child, Memory& memory) {
  const Motion shown = motion_in(frame, motion);
  return {header_of(motion.time, world, memory),
          memory.text(child),
          {vector_of(shown.position_n), orientation_of(shown.q_nb)}};
}

TwistStamped twist_of(const BodyVelocity& request, double time, Frame frame, const std::string& child,
                      Memory& memory) {
  return {header_of(time, child, memory),
          {vector_of(body_in(frame, {request.surge_mps, request.sway_mps, request.heave_mps})),
           vector_of(body_in(frame, {0.0, 0.0, request.yaw_rate_radps}))}};
}

BodyVelocity body_velocity_of(const TwistStamped& twist, Frame frame) {
  const Triple linear = body_in(frame, triple_of(twist.twist.linear));
  return {linear[0], linear[1], linear[2], body_in(frame, triple_of(twist.twist.angular))[2]};
}

PoseStamped goal_of(const Triple& position_n, double time, Frame frame, const std::string& world,
                    Memory& memory) {
  return {header_of(time, world, memory), {place_of(position_n, frame), {0, 0, 0, 1}}};
}

MarkerArray markers_of(const std::vector<Mark>& marks, double time, Frame frame, const std::string& world,
                       const std::string& space, Memory& memory) {
  MarkerArray array{};
  const auto markers = memory.room(array.markers, marks.size() + 1);
  markers[0].header = header_of(time, world, memory);
  markers[0].ns = memory.text(space);
  markers[0].action = delete_all;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Mark& mark = marks[i];
    Marker& marker = markers[i + 1];
    marker.header = markers[0].header;
    marker.ns = memory.text(mark.meaning.empty() ? space : space + "/" + mark.meaning);
    marker.id = static_cast<std::int32_t>(i);
    marker.type = type_of(mark.kind);
    marker.pose.orientation.w = 1;
    marker.scale = scale_of(mark);
    marker.color = {mark.colour[0], mark.colour[1], mark.colour[2], mark.colour[3]};
    if (mark.kind == Mark::Kind::sphere && !mark.points.empty()) {
      marker.pose.position = place_of(mark.points.front(), frame);
      continue;
    }
    const auto places = memory.room(marker.points, mark.points.size());
    for (std::size_t k = 0; k < places.size(); ++k) places[k] = place_of(mark.points[k], frame);
  }
  return array;
}

}  // namespace fairway::ros2
