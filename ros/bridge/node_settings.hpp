// SPDX-License-Identifier: Apache-2.0
// C++17. The settings of the nodes by name and text, whatever middleware they came by.
#pragma once

#include <cstdint>
#include <string>

#include "ros/bridge/avoider_host.hpp"
#include "ros/bridge/fleet_host.hpp"
#include "ros/bridge/frames.hpp"

namespace fairway::bridge {

/// Where an avoider hears of the others.
enum class AvoiderInput { odometry, team_record, both };

/// The node of an avoider: its own settings, and those of its host.
struct AvoiderNodeSettings : AvoiderOptions {
  Frame frame{Frame::enu};
  AvoiderInput input{AvoiderInput::odometry};
  double rate_hz{10.0};        ///< it answers at least so often, with or without new navigation
  double record_rate_hz{1.0};  ///< how often it tells the team of itself; 0: never
  double speed_mps{0.5};       ///< towards goals, which say nothing of speed
  bool advisory{false};        ///< advises only: it sends no command
  bool lockstep{false};        ///< decides when everyone's navigation of the same instant is there
  bool draw{false};            ///< publishes what the method draws
  bool use_sim_time{false};    ///< goes by the graph's clock; lockstep always does. ROS 1 has its own
  bool test_hooks{false};      ///< lets a test make the node hang; ROS 1 alone
};

/// The node of a simulated fleet.
struct FleetNodeSettings : FleetOptions {
  Frame frame{Frame::enu};
  double speed{1.0};                      ///< seconds of the run per second; 0: as fast as it can
  double lockstep_timeout_s{1.0};         ///< of wall time
  double marker_rate_hz{10.0};            ///< of wall time; 0: none are drawn
  std::uint64_t wait_for_subscribers{0};  ///< it begins when every odometry has so many
  bool lockstep{false};
  bool paused{false};
  bool until_done{false};
};

/// The node's settings, by name. `vehicle` is taken where they name none. What is not the node's own goes to
/// the host, which knows all names. Throws std::runtime_error, in one line, for a value that cannot be read.
AvoiderNodeSettings avoider_node_settings(const Settings& settings, const std::string& vehicle);
/// Likewise. Also throws for names that it does not know, with the nearest that it does. `override.PATH` is a
/// value of the scenario, as of `fairway run --set PATH=`.
FleetNodeSettings fleet_node_settings(const Settings& settings);

/// A vehicle's name as topics and frames have it: every character but letters, digits and `_` replaced by
/// `_`.
std::string topic_name(const std::string& vehicle);

/// The names, for a program's help: one per line, with what they are.
std::string avoider_node_words();
std::string fleet_node_words();

}  // namespace fairway::bridge
