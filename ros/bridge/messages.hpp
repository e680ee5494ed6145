// SPDX-License-Identifier: Apache-2.0
// C++17. Messages, whose members have the same names in ROS 1 and ROS 2, from the bridge's plain values and
// back.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ros/bridge/avoider_host.hpp"
#include "ros/bridge/frames.hpp"

namespace fairway::bridge {

/// Which messages of a topic are kept for a listener that is slow or late.
enum class Keep {
  few,      ///< the last ten
  newest,   ///< the last alone is of use
  many,     ///< the last hundred: each of them counts
  latched,  ///< the last one, for those who begin to listen later too
};

/// To the nearest nanosecond, as in a stamp.
inline std::int64_t nanoseconds_of(double seconds) {
  const double whole = std::floor(seconds);
  return static_cast<std::int64_t>(whole) * 1000000000 + std::llround((seconds - whole) * 1e9);
}

/// [s]
inline double seconds_of(std::int64_t nanoseconds) {
  const std::int64_t whole = nanoseconds / 1000000000;
  return static_cast<double>(whole) + static_cast<double>(nanoseconds % 1000000000) / 1e9;
}

/// The numbers of a Point or a Vector3.
template <class Message>
Triple triple_in(const Message& v) {
  return {v.x, v.y, v.z};
}

template <class Message>
void put(Message& to, const Triple& v) {
  to.x = v[0], to.y = v[1], to.z = v[2];
}

template <class Message>
void put(Message& to, const Quaternion& q) {
  to.w = q[0], to.x = q[1], to.y = q[2], to.z = q[3];
}

/// A place of the graph. [m, NED]
template <class Point>
Triple place_of(const Point& point, Frame frame) {
  return world_in(frame, triple_in(point));
}

/// The greatest standard deviation that a covariance of pose gives a horizontal position, to any side; 0
/// where it gives none, as where all is zero or the first is negative. [m]
template <class Covariance>
double position_sigma_of(const Covariance& rows) {
  const double mean = 0.5 * (rows[0] + rows[7]), difference = 0.5 * (rows[0] - rows[7]);
  const double variance = mean + std::sqrt(difference * difference + rows[1] * rows[1]);
  return rows[0] >= 0.0 && rows[7] >= 0.0 && std::isfinite(variance) ? std::sqrt(variance) : 0.0;
}

/// Pose in the world, twist in the body's axes. Of how sure it is, the position north and east alone is told.
template <class Odometry>
void put_motion(Odometry& odometry, const Motion& motion, Frame frame) {
  const Motion shown = motion_in(frame, motion);
  put(odometry.pose.pose.position, shown.position_n);
  put(odometry.pose.pose.orientation, shown.q_nb);
  put(odometry.twist.twist.linear, shown.v_b);
  put(odometry.twist.twist.angular, shown.omega_b);
  odometry.pose.covariance[0] = odometry.pose.covariance[7] = motion.position_sigma * motion.position_sigma;
}

/// Its numbers as they are, usable or not: whoever takes them judges. `time` [s].
template <class Odometry>
Motion motion_of(const Odometry& odometry, double time, Frame frame) {
  const auto& q = odometry.pose.pose.orientation;
  return motion_in(frame, {time,
                           triple_in(odometry.pose.pose.position),
                           {q.w, q.x, q.y, q.z},
                           triple_in(odometry.twist.twist.linear),
                           triple_in(odometry.twist.twist.angular),
                           position_sigma_of(odometry.pose.covariance)});
}

template <class Transform>
void put_transform(Transform& transform, const Motion& motion, Frame frame) {
  const Motion shown = motion_in(frame, motion);
  put(transform.translation, shown.position_n);
  put(transform.rotation, shown.q_nb);
}

/// A velocity for the vehicle's own controller, in body axes: forward-left-up with `enu`,
/// forward-starboard-down with `ned`.
template <class Twist>
void put_velocity(Twist& twist, const BodyVelocity& request, Frame frame) {
  put(twist.linear, body_in(frame, {request.surge_mps, request.sway_mps, request.heave_mps}));
  put(twist.angular, body_in(frame, {0.0, 0.0, request.yaw_rate_radps}));
}

/// The velocity of a twist; its roll and pitch rates are not used.
template <class Twist>
BodyVelocity velocity_of(const Twist& twist, Frame frame) {
  const Triple linear = body_in(frame, triple_in(twist.linear));
  return {linear[0], linear[1], linear[2], body_in(frame, triple_in(twist.angular))[2]};
}

/// A marker's name space, of what `space` shows; `space` may be empty.
inline std::string name_space(const std::string& space, const Mark& mark) {
  return space.empty() || mark.meaning.empty() ? space + mark.meaning : space + "/" + mark.meaning;
}

inline constexpr int delete_all_markers = 3;  ///< of visualization_msgs/Marker, before those that are shown

/// All of a marker but its header, texts and, where it has them, points.
template <class Marker>
void put_mark(Marker& marker, const Mark& mark, int id, Frame frame) {
  using Kind = Mark::Kind;
  marker.id = id;
  marker.type = static_cast<int>(mark.kind);
  marker.color.r = mark.colour[0], marker.color.g = mark.colour[1];
  marker.color.b = mark.colour[2], marker.color.a = mark.colour[3];
  marker.pose.orientation.w = 1.0;
  const double diameter = 2.0 * mark.radius;
  put(marker.scale, mark.kind == Kind::sphere  ? Triple{diameter, diameter, diameter}
                    : mark.kind == Kind::line  ? Triple{mark.width, 0.0, 0.0}
                    : mark.kind == Kind::words ? Triple{0.0, 0.0, mark.width}
                                               : Triple{1.0, 1.0, 1.0});
  if (mark.kind == Kind::sphere || mark.kind == Kind::words)
    put(marker.pose.position, world_in(frame, mark.points.front()));
}

/// Whether the marker of a mark has its points; the others have one place.
inline bool has_points(const Mark& mark) {
  return mark.kind == Mark::Kind::line || mark.kind == Mark::Kind::triangles;
}

/// Messages of a middleware in a graph's frame. `Middleware` names the types of messages, makes stamps of
/// nanoseconds and the other way round, and has a `Memory` that makes texts and lists of messages. What is
/// written may point into its writer.
template <class Middleware>
class Writer {
 public:
  /// `world` is the name of the frame that positions are in.
  explicit Writer(Frame frame, std::string world = "world") : frame_{frame}, world_{std::move(world)} {}

  /// Zero for what a stamp cannot hold: NaN, what is before 0 or after the middleware's end of time. [s]
  static auto stamp(double seconds) {
    const bool is_held = seconds >= 0.0 && seconds < Middleware::end_of_time;
    return Middleware::stamp(is_held ? nanoseconds_of(seconds) : 0);
  }

  /// Pose in the world, twist in `child`'s body axes.
  auto odometry(const Motion& motion, const std::string& child) {
    typename Middleware::Odometry odometry{};
    put_header(odometry.header, motion.time, world_);
    odometry.child_frame_id = memory_.text(child);
    put_motion(odometry, motion, frame_);
    return odometry;
  }

  auto transform(const Motion& motion, const std::string& child) {
    typename Middleware::TransformStamped transform{};
    put_header(transform.header, motion.time, world_);
    transform.child_frame_id = memory_.text(child);
    put_transform(transform.transform, motion, frame_);
    return transform;
  }

  /// Stamped with the time of the navigation that it answers.
  auto twist(const BodyVelocity& request, double time, const std::string& child) {
    typename Middleware::TwistStamped twist{};
    put_header(twist.header, time, child);
    put_velocity(twist.twist, request, frame_);
    return twist;
  }

  /// A place to go to; its attitude says nothing.
  auto goal(const Triple& position_n, double time) {
    typename Middleware::PoseStamped goal{};
    put_header(goal.header, time, world_);
    put(goal.pose.position, world_in(frame_, position_n));
    goal.pose.orientation.w = 1.0;
    return goal;
  }

  /// What was drawn, after a marker that clears what `space` showed before. Name spaces are the meanings, in
  /// ROS 2 below `space`.
  auto markers(const std::vector<Mark>& marks, double time, const std::string& space) {
    typename Middleware::MarkerArray array{};
    const std::string shown = Middleware::name_space(space);
    auto&& markers = memory_.room(array.markers, marks.size() + 1);
    put_header(markers[0].header, time, world_);
    markers[0].ns = memory_.text(shown);
    markers[0].action = delete_all_markers;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const Mark& mark = marks[i];
      auto& marker = markers[i + 1];
      marker.header = markers[0].header;
      marker.ns = memory_.text(name_space(shown, mark));
      marker.text = memory_.text(mark.words);
      put_mark(marker, mark, static_cast<int>(i), frame_);
      if (!has_points(mark)) continue;
      auto&& points = memory_.room(marker.points, mark.points.size());
      for (std::size_t k = 0; k < mark.points.size(); ++k) put(points[k], world_in(frame_, mark.points[k]));
    }
    return array;
  }

  auto diagnosis(const Diagnosis& diagnosis, const std::string& vehicle, double time) {
    typename Middleware::DiagnosticArray array{};
    array.header.stamp = stamp(time);
    auto& status = memory_.room(array.status, 1)[0];
    status.level = static_cast<decltype(status.level)>(diagnosis.level);
    status.name = memory_.text("fairway: " + vehicle);
    status.message = memory_.text(diagnosis.summary);
    status.hardware_id = memory_.text(vehicle);
    auto&& values = memory_.room(status.values, diagnosis.values.size());
    for (std::size_t i = 0; i < diagnosis.values.size(); ++i) {
      values[i].key = memory_.text(diagnosis.values[i].first);
      values[i].value = memory_.text(diagnosis.values[i].second);
    }
    return array;
  }

  auto text(const std::string& words) {
    typename Middleware::String text{};
    text.data = memory_.text(words);
    return text;
  }

  auto record(const std::vector<std::uint8_t>& bytes) {
    typename Middleware::UInt8MultiArray record{};
    auto&& room = memory_.room(record.data, bytes.size());
    std::copy(bytes.begin(), bytes.end(), room.begin());
    return record;
  }

  /// Room for `count` elements in the list of a message.
  template <class List>
  decltype(auto) room(List& list, std::size_t count) {
    return memory_.room(list, count);
  }

 private:
  template <class Header>
  void put_header(Header& header, double time, const std::string& frame_id) {
    header.stamp = stamp(time);
    header.frame_id = memory_.text(frame_id);
  }

  Frame frame_;
  std::string world_;
  typename Middleware::Memory memory_;
};

/// As motion_of() above, at the time of its stamp.
template <class Middleware>
Motion motion_of(const typename Middleware::Odometry& odometry, Frame frame) {
  return motion_of(odometry, seconds_of(Middleware::nanoseconds(odometry.header.stamp)), frame);
}

}  // namespace fairway::bridge
