// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/avoider_node.hpp"
#include "ros/ros2/program.hpp"

namespace {

using namespace fairway;

constexpr const char* name = "fairway_avoider_ros2";

int run(ros2::RosArguments& arguments, const std::atomic<bool>& stop) {
  std::string& space = arguments.graph.space;
  if (space == "/") {  // of the vehicle, which a file for nodes of any namespace may name too
    const auto first = bridge::avoider_node_settings(settings_of(arguments), "");
    space = "/" + bridge::topic_name(first.vehicle);
  }
  const auto settings = bridge::avoider_node_settings(settings_of(arguments, ros2::warns_as(name)),
                                                      space.substr(space.rfind('/') + 1));
  ros2::AvoiderNode node{settings, arguments.graph};
  node.run([&stop] { return !stop; });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return ros2::run_program(argc, argv, name,
                           "The avoider of one vehicle. Settings, and all of the avoider's: algorithm, "
                           "params.NAME, policy.NAME, team ...\n\n" +
                               bridge::avoider_node_words(),
                           run);
}
