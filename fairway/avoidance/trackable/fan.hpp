// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/avoidance/trackable/roll.hpp"

namespace fairway::trackable {

inline constexpr std::size_t most_steps = 48;
inline constexpr std::size_t most_hazards = 64;
inline constexpr std::size_t most_courses = 88;

/// Plans of one vehicle at one instant: each a direction turned, and a speed. Beyond the last plan the last
/// is repeated, as many times as there are lanes.
struct Courses {
  double north{}, east{};  ///< the direction, unit, to be made good [NED]
  double side{};           ///< 1: turned as said; -1: to the other side
  const double* cosines{};
  const double* sines{};
  double quickest{};                        ///< of the speeds [m/s]
  alignas(64) double speeds[most_courses];  ///< [m/s]
};

/// Several plans side by side, in columns of as many numbers as there are lanes, rolled out among hazards
/// until each has come too near to one, or to the end.
struct Fan {
  static constexpr std::size_t motion_columns = 8;
  using Column = double[lanes::most_lanes];

  /// What they begin with.
  enum class Plans {
    courses,  ///< each of its own, from `first` on, from where the vehicle is
    stop,     ///< the bow up into the drift, or as it is, from `motion`
    circle,   ///< keep their speed, and turn as fast as they can to their `side`, from `motion`
  };

  const Response* response{};
  const Hazard* hazards{};
  const double* near2{};             ///< of each hazard: this near is too near, squared [m2]
  const std::size_t* first_steps{};  ///< of each hazard: none can be too near to it before so many are over
  const double* within2{};           ///< of each hazard: nor this near within a step; null: none is so quick
  std::size_t hazard_count{};
  std::size_t begin{};       ///< steps that are over
  std::size_t steps{};       ///< all
  std::size_t hold_steps{};  ///< where they have been made the motions are kept in `held`
  bool asks_room{};

  Plans plans{};
  const Courses* courses{};
  const Motion<double>* now{};  ///< of courses
  std::size_t first{};

  alignas(64) Column motion[motion_columns];  ///< the members of Motion, in their order
  alignas(64) Column side;

  alignas(64) Column held[motion_columns];
  alignas(64) Column clear_steps;  ///< until it comes too near, or `steps`
  alignas(64) Column room;  ///< least distance beyond contact, of who never comes too near, if asked for [m]
  alignas(64) Column last_room;  ///< likewise, that after the last step [m]
};

}  // namespace fairway::trackable
