// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "ros/ros2/ros_args.hpp"

namespace fairway::ros2 {

/// What every node's main() does: help, the command line, the end by SIGINT and SIGTERM, and errors in one
/// line with exit code 2. `work` gets the arguments and what tells it to end, and returns the exit code.
int run_program(int argc, char** argv, const std::string& name, const std::string& help,
                const std::function<int(RosArguments&, const std::atomic<bool>& stop)>& work);

/// A line on standard error, for settings_of().
std::function<void(const std::string&)> warns_as(const std::string& name);

}  // namespace fairway::ros2
