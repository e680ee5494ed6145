// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/avoidance/algorithm.hpp"

namespace fairway {

/// By which rule a conflict that is alike on both sides is given a side. VO, RVO, HRVO and ORCA are functions
/// of the scene: where it is its own mirror image their answer is on its axis, so they brake in front of what
/// lies exactly ahead, and a symmetric crowd stands for ever. The papers leave open what breaks that
/// (van den Berg, Guy, Lin, Manocha 2011, section 5, and RVO2's examples add noise to the preferred
/// velocity).
enum class Symmetry {
  none,       ///< nothing does: as published
  starboard,  ///< everyone leans to starboard
  drawn,      ///< a side and an angle, drawn once from the avoider's own stream
  by_id,  ///< of two that react the one of the larger id leans to starboard; alone for what does not react
};

template <>
struct EnumNames<Symmetry> {
  static constexpr std::array names{"none", "starboard", "drawn", "by_id"};
};

/// What `symmetry` means wherever it is a parameter.
inline constexpr std::string_view symmetry_meaning =
    "what gives a side to a conflict that is alike on both: nothing, starboard, one drawn once, or the "
    "larger id gives way";

/// `s.preferred_velocity()`, turned about the vertical by 10 degrees (`drawn`: by 5 to 15 to either side)
/// while a conflict within `range` [m], centre to centre or to the surface of an obstacle, is symmetric:
/// while it would lead, all others as they move, past somebody's middle by less than a quarter of the sum of
/// the radii. A velocity that is vertical is left as it is. O(tracks + vertices).
Vec3 preferred_velocity(const Situation& s, Symmetry symmetry, const Context& context, double range) noexcept;

}  // namespace fairway
