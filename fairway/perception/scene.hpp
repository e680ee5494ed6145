// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "fairway/comms/message.hpp"
#include "fairway/core/ids.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/core/state.hpp"
#include "fairway/core/vicinity.hpp"
#include "fairway/world/obstacle_field.hpp"

namespace fairway {

/// Something that moves, as it truly is: a vehicle, or an obstacle that drifts.
struct Mover {
  TrackId id{};                                              ///< of a vehicle its own number
  Vec3 position = Vec3::Zero();                              ///< [m, NED]
  Vec3 velocity = Vec3::Zero();                              ///< over ground [m/s, NED]
  Eigen::Quaterniond q_nb = Eigen::Quaterniond::Identity();  ///< body to NED
  double radius{};                                           ///< of its sphere [m]
  std::int32_t priority{};                                   ///< the smaller number has the right of way
  bool reacts{true};                                         ///< false: it keeps its course whatever comes
  bool silent{false};                                        ///< it tells nobody where it is
  bool is_vehicle{true};
};

/// What is round a vehicle at one instant: the truth, at which sensors alone may look, and what the vehicle
/// was told.
struct Scene {
  double time{};                        ///< [s]
  double period{};                      ///< of the ticks that messages are stamped with [s]
  std::size_t own_index{};              ///< of the vehicle
  std::span<const Mover> movers;        ///< all vehicles by index, unless all are heard, then what drifts
  std::span<const Obstacle> obstacles;  ///< all that do not move
  std::span<const Message> heard;       ///< the last message of each vehicle, as far as there is one

  /// The vehicles, each where perfect perception finds it: a silent one where it is, and, if everyone hears
  /// at once (`heard_at_once`), one that tells where it says to be; the others nowhere. Null: nobody has
  /// sorted them, and all are looked through.
  const Vicinity* places{nullptr};
  bool heard_at_once{false};         ///< `heard` is by index of the vehicles, sent now, the same for everyone
  double unforeseen_acceleration{};  ///< of those who sent them [m/s2]

  const FixedIndexes* indexes{nullptr};  ///< of `obstacles`; null: they are gone through one by one
};

/// The vehicle that looks.
struct Viewpoint {
  const VehicleState& truth;     ///< where its sensors are
  const VehicleState& estimate;  ///< where it believes to be
  double radius{};               ///< of its sphere [m]

  /// Of the tracks the method looks at no more than these, the nearest.
  std::size_t most_tracks{std::numeric_limits<std::size_t>::max()};
  /// Of the obstacles at none that is farther, to its surface [m].
  double farthest_obstacle{std::numeric_limits<double>::infinity()};
};

/// How far perception reaches.
struct Reach {
  double vehicles{};   ///< between centres [m]
  double obstacles{};  ///< from the vehicle's sphere to the surface of what is not charted [m]
};

}  // namespace fairway
