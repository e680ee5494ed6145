// SPDX-License-Identifier: Apache-2.0
#include <ros/ros.h>

#include <exception>
#include <iostream>

#include "ros/ros1/sim_node.hpp"
#include "ros/ros1/sim_settings.hpp"

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "fairway_sim");
    const ros::NodeHandle first;  // ROS runs from here on, whatever is wrong with the parameters
    XmlRpc::XmlRpcValue parameters;
    ros::param::get(ros::this_node::getName(), parameters);
    fairway::ros1::SimNode node{fairway::ros1::read_sim_settings(parameters)};
    return node.run();
  } catch (const std::exception& error) {
    std::cerr << "fairway_sim: " << error.what() << "\n";
    return 2;
  }
}
