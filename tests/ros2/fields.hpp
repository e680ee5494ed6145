// SPDX-License-Identifier: Apache-2.0
// The members of each message by name, so that a test can fill, print and compare them all. The names are
// written out here and not taken from the IDL: what is compared with the official definitions is where each
// named member really lies.
#pragma once

#include <tuple>

#include "ros/ros2/messages.hpp"

namespace fairway::ros2 {

#define FIELDS(Message, ...)      \
  template <class V>              \
  void visit(Message& m, V&& v) { \
    v __VA_ARGS__;                \
  }
#define F(name) (#name, m.name)

FIELDS(Time, F(sec) F(nanosec))
FIELDS(Duration, F(sec) F(nanosec))
FIELDS(Header, F(stamp) F(frame_id))
FIELDS(String, F(data))
FIELDS(Bool, F(data))
FIELDS(ColorRGBA, F(r) F(g) F(b) F(a))
FIELDS(MultiArrayDimension, F(label) F(size) F(stride))
FIELDS(MultiArrayLayout, F(dim) F(data_offset))
FIELDS(UInt8MultiArray, F(layout) F(data))
FIELDS(Point, F(x) F(y) F(z))
FIELDS(Vector3, F(x) F(y) F(z))
FIELDS(Quaternion, F(x) F(y) F(z) F(w))
FIELDS(Pose, F(position) F(orientation))
FIELDS(PoseStamped, F(header) F(pose))
FIELDS(PoseWithCovariance, F(pose) F(covariance))
FIELDS(Twist, F(linear) F(angular))
FIELDS(TwistStamped, F(header) F(twist))
FIELDS(TwistWithCovariance, F(twist) F(covariance))
FIELDS(Transform, F(translation) F(rotation))
FIELDS(TransformStamped, F(header) F(child_frame_id) F(transform))
FIELDS(Odometry, F(header) F(child_frame_id) F(pose) F(twist))
FIELDS(Path, F(header) F(poses))
FIELDS(TFMessage, F(transforms))
FIELDS(Clock, F(clock))
FIELDS(KeyValue, F(key) F(value))
FIELDS(DiagnosticStatus, F(level) F(name) F(message) F(hardware_id) F(values))
FIELDS(DiagnosticArray, F(header) F(status))
FIELDS(CompressedImage, F(header) F(format) F(data))
FIELDS(UVCoordinate, F(u) F(v))
FIELDS(MeshFile, F(filename) F(data))
FIELDS(Marker, F(header) F(ns) F(id) F(type) F(action) F(pose) F(scale) F(color) F(lifetime) F(frame_locked)
                   F(points) F(colors) F(texture_resource) F(texture) F(uv_coordinates) F(text)
                       F(mesh_resource) F(mesh_file) F(mesh_use_embedded_materials))
FIELDS(MarkerArray, F(markers))
FIELDS(Gid, F(data))
FIELDS(NodeEntitiesInfo, F(node_namespace) F(node_name) F(reader_gid_seq) F(writer_gid_seq))
FIELDS(ParticipantEntitiesInfo, F(gid) F(node_entities_info_seq))
#undef F
#undef FIELDS

/// Calls `use` with an empty message of every type.
template <class Use>
void for_each_message(Use&& use) {
  [&]<class... Message>(std::tuple<Message...>*) {
    (use(Message{}), ...);
  }(static_cast<
      std::tuple<Time, Duration, Header, String, Bool, ColorRGBA, MultiArrayDimension, MultiArrayLayout,
                 UInt8MultiArray, Point, Vector3, Quaternion, Pose, PoseStamped, PoseWithCovariance, Twist,
                 TwistStamped, TwistWithCovariance, Transform, TransformStamped, Odometry, Path, TFMessage,
                 Clock, KeyValue, DiagnosticStatus, DiagnosticArray, CompressedImage, UVCoordinate, MeshFile,
                 Marker, MarkerArray, Gid, NodeEntitiesInfo, ParticipantEntitiesInfo>*>(nullptr));
}

}  // namespace fairway::ros2
