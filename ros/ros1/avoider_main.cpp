// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_node.hpp"
#include "ros/ros1/program.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  return ros1::run_program(argc, argv, "fairway_avoider", [](const bridge::Settings& settings) {
    const std::string& space = ros::this_node::getNamespace();  // "/fleet/robot3"
    ros1::AvoiderNode node{bridge::avoider_node_settings(settings, space.substr(space.rfind('/') + 1))};
    node.run();
    return 0;
  });
}
