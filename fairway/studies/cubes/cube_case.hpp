// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fairway/scenario/scenario.hpp"

namespace fairway::cubes {

/// A row of the published comparison.
struct CubeCase {
  std::string_view name;  ///< "cube20_8_retuned"
  double half_edge_m;     ///< h of the cube: 10 or 30
  std::size_t team;       ///< 4 or 8
  bool retuned;           ///< CRIT_DIST 7 m for APF, time_step 0.5 s for ORCA
};

/// The six rows (raja2024, section V-B).
std::span<const CubeCase> comparison_cases();

/// Which code decides: what made the published data, or the printed equations in the right frames. How the
/// published runs' vehicles headed at the origin is not known: `as_coded` draws it, `as_coded_north` lets all
/// head north, as a simulator does that is told nothing.
enum class Code { as_coded, as_coded_north, corrected };
constexpr bool is_as_coded(Code code) { return code != Code::corrected; }
std::string_view name_of(Code code);

/// The tunable numbers of the published experiment. The names are those of the thesis in the spelling of
/// this project.
struct Tuning {
  double crit_dist_m = 6.0;
  double ori_error_rad = 0.8;
  double w2_ratio = 0.5;        ///< APF
  double time_step_s = 1.0;     ///< ORCA as coded
  double time_horizon_s = 5.0;  ///< ORCA
};

/// One way of getting across the cube.
struct Method {
  std::string_view name;  ///< "apf", "orca3d", "apf+saw", "orca3d+saw"
  bool orca;
  bool stop_and_wait;
};
std::span<const Method> methods();

/// The parameters of the comparison phase (raja2024, sections V-A and V-B).
Tuning comparison_tuning(const CubeCase& cube, const Method& method);

/// The published mean of a cell over five runs, or nothing if not published. Collisions and stuck robots are
/// totals.
std::optional<double> published(std::string_view cube, std::string_view method, std::string_view quantity);

/// The whole experiment as a scenario: everyone from the NED origin to its vertex, wait for all, cross to the
/// opposite vertex, hold there. What the published runs left to chance (heading at the origin, when
/// each starts, the order of messages) is drawn from the seed.
Scenario cube_scenario(const CubeCase& cube, const Method& method, Code code, const Tuning& tuning,
                       std::uint64_t seed);

}  // namespace fairway::cubes
