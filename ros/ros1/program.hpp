// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <ros/ros.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "ros/ros1/listen_queue.hpp"
#include "ros/ros1/parameters.hpp"

namespace fairway::ros1 {

/// What every node's main() does: help, ROS, the private parameters, and errors in one line with exit code 2.
/// `work` gets the parameters and returns the exit code.
template <class Work>
int run_program(int argc, char** argv, const std::string& name, const std::string& help, Work work) {
  const auto asks = [](const std::string& word) { return word == "-h" || word == "--help"; };
  if (std::any_of(argv + 1, argv + argc, asks)) {
    std::cout
        << "usage: " << name << " [__ns:=/SPACE] [__name:=NODE] [FROM:=TO] [_NAME:=VALUE]\n\n"
        << help
        << "\nin the environment: ROS_MASTER_URI, ROS_IP; in words on docs/ros.md and docs/ros_avoider.md\n";
    return 0;
  }
  try {
    ros::init(argc, argv, name);
    const ros::NodeHandle first;  // ROS runs from here on, whatever is wrong with the parameters
    lengthen_listen_queue();
    XmlRpc::XmlRpcValue parameters;
    ros::param::get(ros::this_node::getName(), parameters);
    return work(settings_of(parameters));
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return 2;
  }
}

}  // namespace fairway::ros1
