// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>

#include "ros/bridge/avoider_host.hpp"
#include "ros/bridge/frames.hpp"

namespace fairway::ros1 {

/// Where an avoider hears of the others.
enum class AvoiderInput { odometry, team_record, both };

/// How the node is set up: its own private parameters, and those that it hands on to the avoider.
struct AvoiderSettings {
  bridge::AvoiderOptions host;
  bridge::Frame frame{bridge::Frame::enu};
  AvoiderInput input{AvoiderInput::odometry};
  double rate_hz{10.0};        ///< it answers at least so often, with or without new navigation
  double record_rate_hz{1.0};  ///< how often it tells the team of itself; 0: never
  double speed_mps{0.5};       ///< towards goals that say nothing of speed
  bool advisory{false};        ///< advises only: it sends no command
  bool lockstep{false};        ///< decides when everyone's navigation of the same instant is there
  bool draw{false};            ///< publishes what the method draws
  bool test_hooks{false};      ///< lets a test make it hang
};

/// The settings in a node's private parameters; `vehicle` is taken where they name none. Throws
/// std::runtime_error, in one line, for a value that cannot be read.
AvoiderSettings read_avoider_settings(const XmlRpc::XmlRpcValue& parameters, const std::string& vehicle);

}  // namespace fairway::ros1
