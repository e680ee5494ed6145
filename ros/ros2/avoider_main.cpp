// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/avoider_node.hpp"
#include "ros/ros2/program.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  return ros2::run_program(argc, argv, "fairway_avoider_ros2",
                           "The avoider of one vehicle. Settings, and all of the avoider's: algorithm, "
                           "params.NAME, policy.NAME, team ...\n\n" +
                               bridge::avoider_node_words(),
                           [](ros2::RosArguments& arguments, const std::atomic<bool>& stop) {
                             std::string& space = arguments.graph.space;
                             const auto settings = bridge::avoider_node_settings(
                                 arguments.settings, space.substr(space.rfind('/') + 1));
                             if (space == "/") space = "/" + bridge::topic_name(settings.vehicle);
                             ros2::AvoiderNode node{settings, arguments.graph};
                             node.run([&stop] { return !stop; });
                             return 0;
                           });
}
