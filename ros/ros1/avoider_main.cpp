// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>

#include "ros/ros1/avoider_node.hpp"
#include "ros/ros1/master_watch.hpp"

namespace {

/// "robot3" of "/fleet/robot3".
std::string last_name(const std::string& name_space) { return name_space.substr(name_space.rfind('/') + 1); }

}  // namespace

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "fairway_avoider");
    const ros::NodeHandle vehicle;
    XmlRpc::XmlRpcValue parameters;
    ros::param::get(ros::this_node::getName(), parameters);
    fairway::ros1::AvoiderNode node{
        vehicle, fairway::ros1::read_avoider_settings(parameters, last_name(vehicle.getNamespace()))};
    const fairway::ros1::MasterWatch master{node.services()};
    node.run();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fairway_avoider: %s\n", error.what());
    return 2;
  }
}
