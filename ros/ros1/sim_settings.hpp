// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include "ros/bridge/node_settings.hpp"

namespace fairway::ros1 {

/// The private parameters of `fairway_sim`: docs/ros.md has them in words.
/// Throws std::runtime_error, in one line, for a parameter that does not exist, with the nearest that does,
/// and for a value that cannot be used.
bridge::FleetNodeSettings read_sim_settings(const XmlRpc::XmlRpcValue& parameters);

}  // namespace fairway::ros1
