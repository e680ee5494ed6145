// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/control/body_request.hpp"
#include "fairway/core/leg.hpp"

namespace fairway {

/// Go to the leg's position by line of sight: its speed along the straight line, in three dimensions,
/// slowing to stop within `period`. [m/s, NED]
Command go_to(const Leg& leg, const Ownship& own, double period) noexcept;

/// Follow the line from `leg.from` to `leg.position`, aiming `lookahead` ahead of the nearest point on
/// it, slow at both ends and at full speed between: speed = leg speed × clamp(distance to the nearer
/// end / lookahead, 0.2, 1). Line-of-sight guidance with lookahead (Fossen 2021, section 12.4).
Command follow_section(const Leg& leg, const Ownship& own, double lookahead = 3.0) noexcept;

/// Where and how a vehicle holds.
struct HoldPoint {
  Vec3 position = Vec3::Zero();  ///< [m, NED]
  double yaw{};                  ///< [rad]
};

/// Hold position, depth and heading: each body axis that can be driven returns in proportion to its
/// error, at most 0.3 m/s and 0.2 rad/s. What lies abeam of a vehicle without sway is left to its heading.
BodyRequest keep_position(const HoldPoint& hold, const Ownship& own) noexcept;

/// The heading to hold by: that of `hold`, but where a current is known, `current_n` [m/s, NED], towards the
/// position held once that lies abeam by more than 2 m and what own position may be off. So who cannot go
/// sideways comes to lie with its bow to the current that sets it aside (weather-optimal positioning: Fossen
/// and Strand 2001). [rad]
double holding_yaw(const HoldPoint& hold, const Ownship& own, const Vec3& current_n) noexcept;

/// Circle over the position, turning to starboard, and return to its depth: what is left to a vehicle that
/// cannot stop. With d the distance from it, towards phi, and rho the radius, the course is
/// phi + pi/2 + atan(2 (d - rho) / rho) (Beard and McLain 2012, section 10.2). [m/s, NED]
Command circle(const HoldPoint& hold, double radius, double speed, const Ownship& own) noexcept;

}  // namespace fairway
