// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "fairway/avoidance/pledge/agreement.hpp"
#include "fairway/core/limits.hpp"

namespace fairway::pledge {

/// What a member wants of a round of its group.
struct Aim {
  enum class Kind {
    goal,   ///< to go where its mission leads
    aside,  ///< to go out of somebody's destination, since its own is taken by somebody of another group
    none,   ///< to stay, since its own is taken and it is in nobody's
  };
  Kind kind{};
  Vec3 place = Vec3::Zero();  ///< to which it goes [m, NED]
};

/// The aim of own ship, which lies at its anchor and is to go to `goal` [m, NED]. Who is `stuck`, since in
/// some rounds no plan led it there, goes aside too, near its anchor, each time to another side: it may be in
/// the only way of another, or where no way begins. `stuck` is how often it has done so.
/// Where it goes aside, that is to a free place near its goal, or else near its anchor, within the depths of
/// `limits`; to stay where there is none. Two groups that have each other's places so get to them in three
/// rounds. O(vehicles + obstacles).
Aim aim_of(const Agreement& agreement, const Vec3& goal, const Chart& chart, const Limits& limits,
           std::optional<std::size_t> stuck = {}) noexcept;

}  // namespace fairway::pledge
