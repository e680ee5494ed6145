// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/program.hpp"
#include "ros/ros1/sim_node.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  return ros1::run_program(argc, argv, "fairway_sim", [](const bridge::Settings& settings) {
    ros1::SimNode node{bridge::fleet_node_settings(settings)};
    return node.run();
  });
}
