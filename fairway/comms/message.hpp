// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "fairway/core/ids.hpp"
#include "fairway/core/speech.hpp"
#include "fairway/core/tick.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// What a vehicle tells the team about itself.
struct Message {
  VehicleId from{};
  Tick sent{};
  Vec3 position = Vec3::Zero();     ///< as the sender estimated it when sending [m, NED]
  Vec3 velocity = Vec3::Zero();     ///< over ground [m/s, NED]
  double yaw{};                     ///< [rad]
  double radius{};                  ///< [m]
  std::int32_t priority{};          ///< the smaller number has the right of way
  std::optional<Vec3> destination;  ///< [m, NED]
  bool told{true};                  ///< false: the vehicle keeps silent, and nothing of this is known
  Speech speech{};                  ///< what its method says instead of all that, if anything

  /// False of whoever keeps silent, or says something else.
  bool tells_place() const { return told && speech.empty(); }
};

/// What every vehicle would say at one instant, by vehicle index.
using Mailbox = std::vector<Message>;

}  // namespace fairway
