// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/avoidance/trackable/roll.hpp"

namespace fairway::trackable {

inline constexpr std::size_t foresight_steps = 48;
inline constexpr std::size_t most_hazards = 64;

/// Several plans side by side, in columns of as many numbers as there are lanes, rolled out among hazards
/// until each has come too near to one, or to the end.
struct Fan {
  static constexpr std::size_t motion_columns = 8;
  using Column = double[lanes::most_lanes];

  const Response* response{};
  const Hazard* hazards{};
  const double* near2{};             ///< of each hazard: this near is too near, squared [m2]
  const std::size_t* first_steps{};  ///< of each hazard: none can be too near to it before so many are over
  std::size_t hazard_count{};
  std::size_t begin{};       ///< steps that are over
  std::size_t hold_steps{};  ///< where they have been made the motions are kept in `held`
  bool circles{};  ///< keeps speed and turn rate, which stands in the column of headings to the north
  bool asks_room{};

  alignas(64) Column motion[motion_columns];  ///< the members of Motion, in their order
  alignas(64) Column heading_north, heading_east, speed;

  alignas(64) Column held[motion_columns];
  alignas(64) Column clear_steps;  ///< until it comes too near, or foresight_steps
  alignas(64) Column room;  ///< least distance beyond contact, of who never comes too near, if asked for [m]
};

}  // namespace fairway::trackable
