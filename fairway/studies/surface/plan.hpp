// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fairway/studies/cell.hpp"
#include "fairway/studies/surface/course.hpp"

namespace fairway::surface {

/// The published value of a quantity on a course, or nothing. `avoa` stands for all its forms, `teb` for all
/// its settings, since the paper does not say which it had.
std::optional<double> published(Course course, std::string_view method, std::string_view quantity);

/// AVOA as published, by exhaustive search, improved; TEB in its six settings.
std::span<const Method> compared_methods();

/// Those, the improvements one at a time, and what else of the catalog works in the plane.
std::span<const Method> all_methods();

/// What sails a course.
enum class Vessel {
  zarco,    ///< the boat, behind its velocity controller
  at_once,  ///< limits alone: what is asked for is there within a tenth of a second, as the methods take it
};
inline constexpr std::array vessels{Vessel::zarco, Vessel::at_once};
std::string_view name_of(Vessel vessel);

/// One vessel on a course, within the published limits, 1.2 m/s wanted, decisions five times a second,
/// up to `duration_s`, done 1 m from the goal.
Scenario passage(Course course, const Layout& layout, Vessel vessel, const Method& method,
                 std::uint64_t seed);

/// Every course, eight seeds each, of the swarm and of what TEB explores: `zarco` in the waves of Table I,
/// `at_once` in calm water.
std::vector<Cell> published_cells();

/// Every course in `seeds` variations with Zarco, for every method.
std::vector<Cell> varied_cells(int seeds);

}  // namespace fairway::surface
