// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ros/bridge/plain.hpp"
#include "ros/ros2/graph.hpp"

namespace fairway::ros2 {

/// What a program of ROS 2 is told on its command line.
struct RosArguments {
  GraphOptions graph;
  bridge::Settings given;          ///< parameters by name, in order
  std::vector<std::string> files;  ///< of parameters: settings_of() reads them
  std::vector<std::string> words;  ///< what is not of ROS
};

/// Reads `--ros-args [-p NAME:=VALUE] [-r FROM:=TO] [-r __node:=N] [-r __ns:=/N] [--params-file FILE] [--] `,
/// as ROS 2's launch files give it, and `--set NAME=VALUE`, `--NAME VALUE` and `--NAME=VALUE` for people.
/// What else ROS 2 has there (log levels, enclaves) is passed over. The domain and the interface come of
/// ROS_DOMAIN_ID and ROS_LOCALHOST_ONLY. What begins with `NODE:` is of that node alone, and passed over if
/// that is another. VALUE is YAML: a list's items become words with blanks between. Throws
/// std::runtime_error, in one line, for what cannot be read.
RosArguments ros_arguments(const std::vector<std::string>& arguments, const std::string& node);

/// All parameters, in order: those of the files for the node, as its name and namespace are by now, and then
/// those by name. In a file, names and namespaces stand one above the other or with slashes between, as in
/// `/auv_1/pilot`, with `*` for any one and `**` for any number of them; a bare `pilot` is meant in every
/// namespace. `warn` is told of a file that has nothing for the node. Throws as ros_arguments().
bridge::Settings settings_of(const RosArguments& arguments,
                             const std::function<void(const std::string&)>& warn = {});

}  // namespace fairway::ros2
