// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include "ros/bridge/fleet_host.hpp"
#include "ros/bridge/frames.hpp"

namespace fairway::ros1 {

/// The private parameters of `fairway_sim`: docs/ros.md has them in words.
struct SimSettings {
  bridge::FleetOptions fleet;
  bridge::Frame frame{bridge::Frame::enu};
  double speed{1.0};               ///< seconds of the run per second; 0: as fast as it can
  double lockstep_timeout_s{1.0};  ///< of wall time
  double marker_rate_hz{10.0};     ///< of wall time; 0: none are drawn
  std::uint64_t wait_for_subscribers{0};
  bool lockstep{false};
  bool paused{false};
  bool until_done{false};
};

/// Throws std::runtime_error, in one line, for a parameter that does not exist, with the nearest that does,
/// and for a value that cannot be used.
SimSettings read_sim_settings(const XmlRpc::XmlRpcValue& parameters);

}  // namespace fairway::ros1
