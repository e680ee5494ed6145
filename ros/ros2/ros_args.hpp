// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ros/bridge/plain.hpp"
#include "ros/ros2/graph.hpp"

namespace fairway::ros2 {

/// What a program of ROS 2 is told on its command line.
struct RosArguments {
  GraphOptions graph;
  bridge::Settings settings;       ///< parameters, in order, those of files before those by name
  std::vector<std::string> words;  ///< what is not of ROS
};

/// Reads `--ros-args [-p NAME:=VALUE] [-r FROM:=TO] [-r __node:=N] [-r __ns:=/N] [--params-file FILE] [--] `,
/// as ROS 2's launch files give it, and `--set NAME=VALUE`, `--NAME VALUE` and `--NAME=VALUE` for people.
/// What else ROS 2 has there (log levels, enclaves) is passed over. The domain and the interface come of
/// ROS_DOMAIN_ID and ROS_LOCALHOST_ONLY. Throws std::runtime_error, in one line, for what cannot be read.
RosArguments ros_arguments(const std::vector<std::string>& arguments, const std::string& node);

}  // namespace fairway::ros2
