// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/avoidance/pledge/reference.hpp"

namespace fairway::pledge {

/// How own ship goes, as a member that lies where it is and is to go to its goal: with all of it at once
/// within its greatest speed, what is left of that beside climbing. That is a speed over ground; a hull that
/// reaches no more by itself has what the current leaves of it. `speed_ratio` is of its greatest speed.
Member member_of(const Situation& s, double speed_ratio) noexcept;

/// The same held at `anchor` and with another destination [m, NED], with the speeds that it tells. Where its
/// floor leaves no room for all levels below its way it tells that it dives no faster than who keeps to its
/// own (has_levels).
Member member_of(const Situation& s, double speed_ratio, const Vec3& anchor,
                 const Vec3& destination) noexcept;

/// What own sphere has to be larger by where its navigation states an error, since the tube has to hold that
/// beside half a metre by which members are off their ways, and does not [m].
double beyond_tube(const Ownship& own, double tube) noexcept;

/// Where it lies once it has stopped, not above the surface [m, NED].
Vec3 resting_place(const Situation& s) noexcept;

inline constexpr double stopping = 2.0;  ///< from a member's speed, with its lag [s]

inline constexpr double noticed_current = 0.02;  ///< one that is less is none [m/s]

bool is_in_current(const Situation& s) noexcept;

/// What of a velocity over ground the vehicle may and can go, the vertical part of it first [m/s, NED].
Vec3 within_limits(const Situation& s, const Vec3& v) noexcept;

/// The course on which the reference goes at a time [rad], if it goes along then.
std::optional<double> course_at(const Situation& s, const Reference& way, double time) noexcept;

/// The course on which the reference will go next [rad], once it is time to turn to it. In a current that is
/// no sooner than it has to be, since nobody who has turned aside stays where it is. `turn` is how long it
/// takes to turn round [s].
std::optional<double> next_course(const Situation& s, const Reference& way, double turn) noexcept;

/// Goes `wanted` over ground [m/s, NED] by surge, heave and turn rate of its own, whatever the steering of
/// its scenario: ahead through the water, on the course that makes good what the current sets it aside.
/// `course` [rad] goes before that; who neither has one nor is to go through the water keeps its heading. It
/// goes astern no faster than `astern` [m/s].
Command driven(const Situation& s, const Vec3& wanted, std::optional<double> course, Mode mode,
               std::string_view note, double astern = 0.0) noexcept;

/// Back to the anchor: who only stops where it is drifts sideways for long. A little way it goes back ahead
/// or astern, if it can, else ahead. In a current it lies with its bow against it. On `course`, if there is
/// one, and astern, if need be, so that it stays where it is though the current comes from behind.
Command held(const Situation& s, const Vec3& anchor, std::string_view why,
             std::optional<double> course = {}) noexcept;

struct Following {
  double gain{};        ///< speed by which it returns to its reference, for each metre off it [1/s]
  double tube{};        ///< farther off than this it says so [m]
  double stops{never};  ///< when it will stop, if it hears of nothing that lets it go on [s]
};

/// The command that keeps to the reference of a member that takes so long to turn round [s].
Command followed(const Situation& s, const Reference& way, double turn, const Following& following) noexcept;

void draw(const Reference& way, double time, double tube, Sketch& sketch) noexcept;

}  // namespace fairway::pledge
