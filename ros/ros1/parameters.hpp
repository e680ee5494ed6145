// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include "ros/bridge/plain.hpp"

namespace fairway::ros1 {

/// A node's parameters as they are on the parameter server, as settings: `params/time_horizon_s` is
/// `params.time_horizon_s`, lists are words with blanks between, the names in the folder `team` are `team`,
/// and `overrides`, a list or between semicolons, are `override.PATH` each. Throws std::runtime_error, in one
/// line, for what has no text.
bridge::Settings settings_of(const XmlRpc::XmlRpcValue& parameters);

}  // namespace fairway::ros1
