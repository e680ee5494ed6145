// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "fairway/scenario/scenario.hpp"
#include "fairway/studies/cell.hpp"

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

/// Which code decides, under what circumstances. Of the published runs neither how the vehicles headed at the
/// origin is known nor exactly where their crossings began.
enum class Code {
  as_coded,           ///< what made the published data; headings at the origin drawn
  as_coded_north,     ///< all head north at the origin, as a simulator does that is told nothing
  as_coded_replicas,  ///< as_coded again and again, with other seeds than the published part
  as_coded_starts,    ///< begins as far from the goals as the result files say, instead of with a deployment
  as_coded_timing,    ///< as_coded, with messages and odometry as AsHeard makes them
  as_coded_starts_timing,  ///< as_coded_starts, likewise
  corrected,               ///< the printed equations in the right frames
  corrected_told,          ///< those, told another distance to keep
};
constexpr bool is_as_coded(Code code) { return code < Code::corrected; }
constexpr bool is_from_recorded_starts(Code code) {
  return code == Code::as_coded_starts || code == Code::as_coded_starts_timing;
}
std::string_view name_of(Code code);

/// The tunable numbers of the published experiment. The names are those of the thesis in the spelling of
/// this project.
struct Tuning {
  double crit_dist_m = 6.0;
  double ori_error_rad = 0.8;
  double w2_ratio = 0.5;        ///< APF
  double time_step_s = 1.0;     ///< ORCA as coded
  double time_horizon_s = 5.0;  ///< ORCA
  double radius_m = 3.0;        ///< of a vehicle; ORCA keeps two of them apart
};

/// The ways of getting across the cube: "apf", "orca3d", "apf+saw", "orca3d+saw".
std::span<const Method> methods();
constexpr bool is_orca(std::string_view method) { return method.starts_with("orca3d"); }

/// The parameters of the comparison phase (raja2024, sections V-A and V-B).
Tuning comparison_tuning(const CubeCase& cube, const Method& method);

/// The whole experiment as a scenario: everyone from the NED origin to its vertex, wait for all, cross to the
/// opposite vertex, hold there. What the published runs left to chance (heading at the origin, when
/// each starts, the order of messages) is drawn from the seed. The method's algorithm and parameters go
/// before those of the comparison; `heard` are parameters of AsHeard.
Scenario cube_scenario(const CubeCase& cube, const Method& method, Code code, const Tuning& tuning,
                       std::uint64_t seed, const ParamValues& heard = {});

}  // namespace fairway::cubes
