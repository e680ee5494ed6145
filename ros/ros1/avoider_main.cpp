// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_node.hpp"
#include "ros/ros1/program.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  const std::string help =
      "The avoider of one vehicle. Parameters, and all of the avoider's: algorithm, params/NAME, "
      "policy/NAME, "
      "team ...\n\n" +
      bridge::avoider_node_words();
  return ros1::run_program(argc, argv, "fairway_avoider", help, [](const bridge::Settings& settings) {
    const std::string& space = ros::this_node::getNamespace();  // "/fleet/robot3"
    ros1::AvoiderNode node{bridge::avoider_node_settings(settings, space.substr(space.rfind('/') + 1))};
    node.run();
    return 0;
  });
}
