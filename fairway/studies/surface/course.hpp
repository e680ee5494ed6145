// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "fairway/scenario/scenario.hpp"

namespace fairway::surface {

/// The five courses of campos2019 and two more U-shaped walls. The paper shows its courses in figures without
/// scale, which are not at hand: the layouts are proposals that fit its descriptions, its travel times and
/// the speed of its vessel.
enum class Course {
  u_wall,      ///< buoys around a dead end ahead (Figure 7a)
  u_narrow,    ///< another, four metres wide; not published
  u_deep,      ///< another, four metres deep and eight wide; not published
  cluttered,   ///< buoys everywhere (Figure 7b)
  head_on,     ///< scenario A: a vessel comes down a lane of buoys (Figure 10a)
  orthogonal,  ///< scenario B: a vessel crosses at a right angle (Figure 10b)
  diagonal,    ///< scenario C: a vessel crosses at 135 degrees (Figure 10c)
};
inline constexpr std::array courses{Course::u_wall,  Course::u_narrow,   Course::u_deep,  Course::cluttered,
                                    Course::head_on, Course::orthogonal, Course::diagonal};
std::string_view name_of(Course course);

inline constexpr double buoy_radius = 0.3;     // [m]
inline constexpr double vessel_radius = 0.75;  // [m], of the own and of the other

inline constexpr double proposed_length = 25.0;  ///< from the start to the goal [m]

/// What is on a course, where the own vessel begins and is to go, and how the water moves.
struct Layout {
  Vec3 start = Vec3::Zero();
  Vec3 goal{proposed_length, 0.0, 0.0};
  double heading{};  ///< [rad]
  std::vector<Vec2> buoys;
  std::optional<Vec2> vessel;      ///< where the other one is at the start
  Vec2 vessel_velocity{0.0, 0.0};  ///< kept whatever comes [m/s]
  WaterSpec water;

  std::vector<ObstacleSpec> obstacles() const;
};

/// The course as proposed, in the waves of Table I.
Layout layout_of(Course course);

/// The same picture at another scale, which the paper does not give: goal, buoys and the start of the other
/// vessel at `length` / 25 m times their places; their sizes and the speed of the other vessel as they are.
Layout scaled(Course course, double length);

/// The course with everything a little elsewhere: start by up to 1 m and 0.3 rad, buoys by 0.3 m, the other
/// vessel by 1 m, 20 % of its speed and 0.2 rad, each along north and east; in a JONSWAP sea of up to 0.3 m
/// and 3 to 8 s and a current of up to 0.2 m/s, both from anywhere. The variations of one seed are the same
/// for every method.
Layout varied(Course course, std::uint64_t seed);

}  // namespace fairway::surface
