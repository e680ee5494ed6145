// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fairway/avoidance/ability.hpp"
#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"

namespace fairway {

/// When and how near two come to each other if neither changes its velocity.
struct ClosestApproach {
  double time{};      ///< from now [s]; 0 if they draw apart already
  double distance{};  ///< of centres [m]
};

/// The closest approach of something at `position` that moves with `velocity`, both relative to oneself [m,
/// m/s]. O(1).
ClosestApproach closest_approach(const Vec3& position, const Vec3& velocity) noexcept;

/// A direction from the bow in the horizontal plane, for words: [rad], positive to starboard.
double bearing_from_bow(const Vec3& offset, double yaw) noexcept;

enum class Precedence : std::uint8_t { own, theirs, equal };
template <>
struct EnumNames<Precedence> {
  static constexpr std::array names{"own", "theirs", "equal"};
};

/// A neighbour as a decision saw it.
struct NeighbourFacts {
  Track track;
  double range{};                ///< between centres [m]
  double bearing{};              ///< from the bow [rad], positive to starboard
  double below{};                ///< how much deeper it is [m]
  double closing{};              ///< speed at which the range shrinks [m/s]
  double radii{};                ///< sum of both [m]
  ClosestApproach at_present{};  ///< both keep their velocities
  ClosestApproach preferred{};   ///< own is the preferred velocity, at once
  ClosestApproach commanded{};   ///< own is the commanded velocity, at once
  Precedence precedence{};       ///< who has the right of way, by priority
};

/// Something solid as a decision saw it.
struct ObstacleFacts {
  Obstacle::Kind kind{};
  Vec3 nearest = Vec3::Zero();  ///< point of its surface [m, NED]
  double distance{};            ///< to that point, negative inside [m]
  double bearing{};             ///< from the bow [rad], positive to starboard
};

/// How a command departs from the preferred velocity.
struct Deviation {
  double size{};               ///< length of the difference [m/s]
  double speed{};              ///< faster [m/s]
  double climb{};              ///< upwards [m/s]
  std::optional<double> turn;  ///< to starboard [rad]; none if either has no course
  bool astern{};               ///< commanded stern first, of who cannot go sideways
};

/// What follows from a situation and the command that it was answered with.
struct DecisionFacts {
  Vec3 preferred = Vec3::Zero();  ///< [m/s, NED]
  Deviation deviation;
  double goal_distance{};                  ///< [m]
  double goal_bearing{};                   ///< from the bow [rad], positive to starboard
  std::vector<NeighbourFacts> neighbours;  ///< nearest first, as in the situation
  std::vector<ObstacleFacts> obstacles;    ///< nearest first
  std::vector<std::string> binding;        ///< limits that the command is at, in words
  Shortfall shortfall{};                   ///< of the vehicle, against the command
};

/// O(neighbours + obstacles).
DecisionFacts facts_of(const Situation& situation, const Command& command);

}  // namespace fairway
