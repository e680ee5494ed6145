// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/wall_following/wall_following.hpp"

namespace fairway::wall {

/// The printed form: a wrench per body axis, and the velocity where it leads.
Command decide_printed(const WallFollowing::Params& params, const Situation& s, WallFollowing::Loop& loop,
                       Context& context) noexcept;

/// Whether following stops: the goal lies on the side of the obstacle's centre that the vehicle is on.
inline bool is_clear(const Vec2& away, const Vec2& to_goal) { return away.dot(to_goal) > 0.0; }

/// Equation 17, which the paper calls clockwise. In (north, east) it leads anticlockwise round the obstacle
/// as seen from above: who meets it head on goes to starboard and leaves it to port.
inline Vec2 clockwise(const Vec2& away) { return {away.y(), -away.x()}; }

/// 1 for eq. 17, -1 for eq. 18 if that leads nearer to the goal; 1 if neither does.
double turn_along(const Vec2& away, const Vec2& to_goal) noexcept;

}  // namespace fairway::wall
