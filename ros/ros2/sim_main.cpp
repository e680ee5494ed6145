// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/program.hpp"
#include "ros/ros2/sim_node.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  return ros2::run_program(
      argc, argv, "fairway_sim_ros2",
      "A scenario as a live fleet. Settings, and override.PATH for values of the scenario:\n\n" +
          bridge::fleet_node_words(),
      [](ros2::RosArguments& arguments, const std::atomic<bool>& stop) {
        const bridge::Settings settings = settings_of(arguments, ros2::warns_as("fairway_sim_ros2"));
        ros2::SimNode node{bridge::fleet_node_settings(settings), arguments.graph};
        return node.run([&stop] { return !stop; });
      });
}
