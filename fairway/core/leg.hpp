// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/core/params.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// What a leg of a mission asks for.
enum class LegKind {
  go_to,          ///< drive to `position` by line of sight, nobody avoided
  keep_position,  ///< hold where the leg began for `duration_s`
  section,        ///< follow the line from `from` to `position`
  rendezvous,     ///< hold until every vehicle has come to its own rendezvous
  transit,        ///< go to `position` under the vehicle's avoider
};

template <>
struct EnumNames<LegKind> {
  static constexpr std::array names{"go_to", "keep_position", "section", "rendezvous", "transit"};
};

/// Where a vehicle is in its mission. Metrics count from the first tick under way.
enum class Phase {
  deploying,  ///< on its way to its rendezvous, or on a leg without avoidance
  waiting,    ///< at the rendezvous, for the others
  under_way,  ///< on a transit, avoiding
  stuck,      ///< under way for longer than the exam allows, and still trying
  arrived,    ///< mission done; holds its position and stays in the others' way
};

template <>
struct EnumNames<Phase> {
  static constexpr std::array names{"deploying", "waiting", "under_way", "stuck", "arrived"};
};

/// True while a vehicle avoids others.
constexpr bool is_avoiding(Phase phase) { return phase == Phase::under_way || phase == Phase::stuck; }

/// True of a vehicle that avoids others, or has been led to its end.
constexpr bool has_set_out(Phase phase) { return is_avoiding(phase) || phase == Phase::arrived; }

/// One leg of a mission, as plain data. After the last leg a vehicle holds its position.
struct Leg {
  LegKind kind{};
  bool agreed{false};            ///< rendezvous: waits for the vehicle's method too
  Vec3 position = Vec3::Zero();  ///< of the goal [m, NED]
  Vec3 from = Vec3::Zero();      ///< of a section's start [m, NED]
  double speed_mps{0.5};         ///< along the leg
  Vec3 box_m = Vec3::Zero();     ///< arrival when |error| <= box on every axis (go_to, section)
  double arrival_m{1.0};         ///< arrival when the distance is at most this (transit; others if no box)
  double duration_s{0.0};        ///< keep_position

  friend bool operator==(const Leg&, const Leg&) = default;
};

}  // namespace fairway
