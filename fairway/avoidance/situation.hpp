// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "fairway/core/ids.hpp"
#include "fairway/core/limits.hpp"
#include "fairway/core/onboard_model.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// Own state as estimated on board. Never the simulator's truth.
struct Ownship {
  VehicleId id{};
  Vec3 position = Vec3::Zero();  ///< [m, NED]
  Vec3 velocity = Vec3::Zero();  ///< over ground [m/s, NED]
  double yaw{};                  ///< [rad], 0 north, positive to starboard
  double yaw_rate{};             ///< [rad/s]
  double radius{1.0};            ///< of the enclosing sphere [m]
  std::int32_t priority{};       ///< the smaller number has the right of way
};

/// Another vehicle, or anything else that moves, as perceived: possibly late, noisy, or no longer there.
struct Track {
  TrackId id{};
  Vec3 position = Vec3::Zero();     ///< extrapolated to the situation's time [m, NED]
  Vec3 velocity = Vec3::Zero();     ///< over ground [m/s, NED]
  double yaw{};                     ///< as reported [rad]
  double radius{1.0};               ///< of the enclosing sphere [m]
  double age{};                     ///< since the last measurement or message [s]
  std::int32_t priority{};          ///< the smaller number has the right of way
  std::optional<Vec3> destination;  ///< where it says it is going [m, NED]
  bool reacts{true};                ///< false: it keeps its course whatever comes, as a drifting object does
  Mat3 position_covariance = Mat3::Zero();  ///< of the error of `position` [m2, NED]
  Mat3 velocity_covariance = Mat3::Zero();  ///< of the error of `velocity` [m2/s2, NED]
};

/// Where the mission wants to be, and how fast.
struct Goal {
  Vec3 position = Vec3::Zero();  ///< [m, NED]
  double cruise_speed{};         ///< [m/s]
  std::optional<Vec3> velocity;  ///< wanted instead of heading straight for the position [m/s, NED]
};

/// All that an avoider may know at one instant. Immutable; the spans are valid only during the call
/// to decide().
struct Situation {
  double time{};    ///< since the start of the mission [s]
  double period{};  ///< until the next decision [s], > 0
  Ownship own;
  Goal goal;
  Limits limits;                        ///< `Avoider` holds every command to these
  const OnboardModel* model{nullptr};   ///< null where nothing is known of forces
  std::span<const Track> tracks;        ///< nearest first; equal ranges by id
  std::span<const Obstacle> obstacles;  ///< what does not move

  /// The velocity that ignores everyone: as the mission wants it, or straight to the goal, slowing
  /// down to stop on it; never above the speed limit. [m/s, NED]
  Vec3 preferred_velocity() const {
    if (goal.velocity) return clamp_norm(*goal.velocity, limits.max_speed);
    const Vec3 to_goal = goal.position - own.position;
    const double distance = to_goal.norm();
    const double wanted = std::min({goal.cruise_speed, limits.max_speed, distance / period});
    return distance > 0.0 ? Vec3{(wanted / distance) * to_goal} : Vec3{Vec3::Zero()};
  }
};

/// What of the situation cannot be decided on, in a few words: a number that is NaN or infinite where it
/// must not be, a period that is not positive, a negative radius. Empty if it is usable. `Avoider` answers
/// anything else with `Mode::infeasible` and these words as its note. O(tracks + vertices of obstacles).
std::string_view why_unusable(const Situation& situation) noexcept;

inline bool is_usable(const Situation& situation) noexcept { return why_unusable(situation).empty(); }

}  // namespace fairway
