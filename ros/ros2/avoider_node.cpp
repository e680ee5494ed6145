// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/avoider_node.hpp"

#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>

namespace fairway::ros2 {

AvoiderNode::AvoiderNode(const bridge::AvoiderNodeSettings& settings, const GraphOptions& options)
    : bridge::AvoiderNode<Middleware>{settings, settings.use_sim_time || settings.lockstep, options},
      simulated_{settings.use_sim_time || settings.lockstep},
      simulated_now_{std::numeric_limits<double>::quiet_NaN()} {
  if (simulated_)
    graph_.subscribe<Clock>("/clock", Keep::newest, [this](const Clock& m) {
      simulated_now_ = bridge::seconds_of(Middleware::nanoseconds(m.clock));
    });
  hear_orders();
  graph_.subscribe<Bool>("keep_position", Keep::few, [this](const Bool& m) {
    if (m.data) duty_.keep_position();
  });
  graph_.subscribe<Bool>("stand_by", Keep::few, [this](const Bool& m) {
    if (m.data) duty_.stand_by();
  });
  hear_fleet();
  graph_.announce();
}

std::optional<double> AvoiderNode::now() const {
  if (!simulated_)
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  const double now = simulated_now_;
  return std::isnan(now) ? std::nullopt : std::optional{now};
}

void AvoiderNode::warn(const std::string& words) {
  std::cerr << "fairway_avoider_ros2 " << duty_.vehicle() << ": " << words << '\n';
}

}  // namespace fairway::ros2
