// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/avoidance/pledge/rounds.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::pledge {

/// A word in plain words, vehicles by their numbers. It waits for those whose states it has not heard, or,
/// where it has acknowledged a plan that is still to start, for those whose acknowledgements it has not. What
/// is no word, or one by nobody of the team, is said to be that. O(members).
Reading reading_of(const Heard& heard, const Vec2& datum, const Groups& groups);

/// "[1.2, -3, 5] m NED", to a decimetre.
std::string place_words(const Vec3& place);

/// "12.3 s".
std::string instant_words(double time);

}  // namespace fairway::pledge
