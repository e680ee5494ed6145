// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/scenario/scenario.hpp"
#include "fairway/studies/cell.hpp"
#include "fairway/studies/uuv/encounter.hpp"

namespace fairway::uuv {

/// How many vehicles come together.
enum class Pattern {
  swap,     ///< on a circle, everyone to the opposite side
  streams,  ///< two columns, two abreast, cross at a right angle
  crowd,    ///< from anywhere in a square to anywhere else in it
};
std::string_view name_of(Pattern pattern);

/// One kind of meeting of many.
struct Gathering {
  Pattern pattern{};
  std::size_t count{};  ///< vehicles; of `streams` a multiple of 4

  std::string name() const;  ///< "swap_16"
};
std::span<const Gathering> gatherings();

/// What everyone knows of everyone else, and what sails. Acoustic messages are sent in turns, by each at most
/// once a second.
struct Awareness {
  std::string_view name;        ///< "sonar+acoustic"
  std::string_view perception;  ///< kinds of the scenario
  std::string_view exchange;
  Hull hull{Hull::point};
};
std::span<const Awareness> awarenesses();

inline constexpr double kept_radius = 1.0;   ///< of the sphere that methods keep clear [m]
inline constexpr double body_radius = 0.75;  ///< of what collides [m]

/// From where to where each vehicle goes [m, NED].
struct Voyage {
  Vec3 start = Vec3::Zero();
  Vec3 goal = Vec3::Zero();
};

/// Drawn from the seed, the same for every method: `swap` within 0.25 m of the regular circle, `streams`
/// within 0.5 m of the regular columns, along north and east; `crowd` with starts and goals at least five
/// radii apart and everyone's way at least half the square.
std::vector<Voyage> voyages_of(const Gathering& gathering, std::uint64_t seed);

/// Everyone at 1 m/s, decisions five times a second, deadlocked after four times the straight way's
/// time.
Scenario gathering_scenario(const Gathering& gathering, const Awareness& awareness, const Method& method,
                            std::uint64_t seed);

/// Those that are compared in gatherings.
std::span<const Method> gathering_methods();

}  // namespace fairway::uuv
