// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/program.hpp"

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>

namespace fairway::ros2 {
namespace {

std::atomic<bool> ended{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

int run_program(int argc, char** argv, const std::string& name, const std::string& help,
                const std::function<int(RosArguments&, const std::atomic<bool>& stop)>& work) {
  const std::vector<std::string> words{argv + 1, argv + argc};
  if (std::find_if(words.begin(), words.end(), [](const auto& w) { return w == "-h" || w == "--help"; }) !=
      words.end()) {
    std::cout << "usage: " << name
              << " [--NAME VALUE] [--ros-args [-p NAME:=VALUE] [-r FROM:=TO] [--params-file FILE]]\n\n"
              << help
              << "\nin the environment: ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY, CYCLONEDDS_URI; in words on "
                 "docs/ros2.md\n";
    return 0;
  }
  std::signal(SIGINT, [](int) { ended = true; });
  std::signal(SIGTERM, [](int) { ended = true; });
  try {
    RosArguments arguments = ros_arguments(words, name);
    if (!arguments.words.empty())
      throw std::runtime_error("'" + arguments.words.front() + "': expected --NAME VALUE; see --help");
    return work(arguments, ended);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 2;
  }
}

std::function<void(const std::string&)> warns_as(const std::string& name) {
  return [name](const std::string& words) { std::cerr << name << ": warning: " << words << '\n'; };
}

}  // namespace fairway::ros2
