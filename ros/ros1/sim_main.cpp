// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/program.hpp"
#include "ros/ros1/sim_node.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  const std::string help =
      "A scenario as a live fleet. Parameters, and overrides, PATH=VALUE of the scenario:\n\n" +
      bridge::fleet_node_words();
  return ros1::run_program(argc, argv, "fairway_sim", help, [](const bridge::Settings& settings) {
    ros1::SimNode node{bridge::fleet_node_settings(settings)};
    return node.run();
  });
}
