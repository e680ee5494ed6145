// SPDX-License-Identifier: Apache-2.0
// The types of ROS 2's messages as Cyclone DDS has them, by their short names.
#pragma once

#include <builtin_interfaces.h>
#include <dds/dds.h>
#include <diagnostic_msgs.h>
#include <geometry_msgs.h>
#include <nav_msgs.h>
#include <rmw_dds_common.h>
#include <rosgraph_msgs.h>
#include <sensor_msgs.h>
#include <std_msgs.h>
#include <tf2_msgs.h>
#include <visualization_msgs.h>

namespace fairway::ros2 {

/// What Cyclone DDS knows of a message: its name in DDS, and how it is laid out.
template <class Message>
const dds_topic_descriptor_t& descriptor();

// NOLINTBEGIN(bugprone-macro-parentheses): a name is declared
#define FAIRWAY_ROS2_MESSAGE(package, Name)                 \
  using Name = package##_msg_dds__##Name##_;                \
  template <>                                               \
  inline const dds_topic_descriptor_t& descriptor<Name>() { \
    return package##_msg_dds__##Name##__desc;               \
  }

FAIRWAY_ROS2_MESSAGE(builtin_interfaces, Time)
FAIRWAY_ROS2_MESSAGE(builtin_interfaces, Duration)
FAIRWAY_ROS2_MESSAGE(std_msgs, Header)
FAIRWAY_ROS2_MESSAGE(std_msgs, String)
FAIRWAY_ROS2_MESSAGE(std_msgs, Bool)
FAIRWAY_ROS2_MESSAGE(std_msgs, ColorRGBA)
FAIRWAY_ROS2_MESSAGE(std_msgs, MultiArrayDimension)
FAIRWAY_ROS2_MESSAGE(std_msgs, MultiArrayLayout)
FAIRWAY_ROS2_MESSAGE(std_msgs, UInt8MultiArray)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, Point)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, Vector3)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, Quaternion)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, Pose)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, PoseStamped)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, PoseWithCovariance)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, Twist)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, TwistStamped)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, TwistWithCovariance)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, Transform)
FAIRWAY_ROS2_MESSAGE(geometry_msgs, TransformStamped)
FAIRWAY_ROS2_MESSAGE(nav_msgs, Odometry)
FAIRWAY_ROS2_MESSAGE(nav_msgs, Path)
FAIRWAY_ROS2_MESSAGE(tf2_msgs, TFMessage)
FAIRWAY_ROS2_MESSAGE(rosgraph_msgs, Clock)
FAIRWAY_ROS2_MESSAGE(diagnostic_msgs, KeyValue)
FAIRWAY_ROS2_MESSAGE(diagnostic_msgs, DiagnosticStatus)
FAIRWAY_ROS2_MESSAGE(diagnostic_msgs, DiagnosticArray)
FAIRWAY_ROS2_MESSAGE(sensor_msgs, CompressedImage)
FAIRWAY_ROS2_MESSAGE(visualization_msgs, UVCoordinate)
FAIRWAY_ROS2_MESSAGE(visualization_msgs, MeshFile)
FAIRWAY_ROS2_MESSAGE(visualization_msgs, Marker)
FAIRWAY_ROS2_MESSAGE(visualization_msgs, MarkerArray)
FAIRWAY_ROS2_MESSAGE(rmw_dds_common, Gid)
FAIRWAY_ROS2_MESSAGE(rmw_dds_common, NodeEntitiesInfo)
FAIRWAY_ROS2_MESSAGE(rmw_dds_common, ParticipantEntitiesInfo)
#undef FAIRWAY_ROS2_MESSAGE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace fairway::ros2
