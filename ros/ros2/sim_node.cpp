// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/sim_node.hpp"

#include <iostream>

namespace fairway::ros2 {

SimNode::SimNode(const bridge::FleetNodeSettings& settings, const GraphOptions& options)
    : bridge::FleetNode<Middleware>{settings, options} {
  const auto when = [this](const std::string& topic, auto act) {
    graph_.subscribe<Bool>("/fairway/" + topic, Keep::few, [act](const Bool& m) {
      if (m.data) act();
    });
  };
  when("pause", [this] { duty_.pause(); });
  when("resume", [this] { duty_.resume(); });
  when("step", [this] { duty_.step_once(); });
  hear_commands();
  graph_.announce();
}

void SimNode::deliver_goals() {
  for (const Port& port : ports_) port.goal.wait_until_delivered(std::chrono::milliseconds{200});
}

void SimNode::warn(const std::string& words) { std::cerr << "fairway_sim_ros2: " << words << '\n'; }

}  // namespace fairway::ros2
