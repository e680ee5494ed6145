// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace fairway {

/// A message type as MCAP's schema encoding "ros2msg" wants it: its definition, then, behind separators,
/// that of every type it uses. Fields and their order are those of ROS 2 (common_interfaces, geometry2);
/// tests/mcap compares them with published copies.
struct MessageSchema {
  std::string_view name;  ///< "nav_msgs/msg/Odometry"
  std::string text;
};

MessageSchema odometry_schema();
MessageSchema transforms_schema();
/// What an Odometry lacks of a vehicle's frame.
MessageSchema vehicle_status_schema();
/// What the vehicles of a frame have in common, and the frame's hash.
MessageSchema frame_schema();

// Where perception is recorded: what a vehicle knows of the others, what its sonar heard, and the hash of
// both.
MessageSchema tracks_schema();
MessageSchema echoes_schema();
MessageSchema perception_schema();

// Where sketches are recorded: what a vehicle drew of its thinking, and the messages under way.
MessageSchema sketch_schema();
MessageSchema flights_schema();

/// Where methods speak: a word.
MessageSchema word_schema();

}  // namespace fairway
