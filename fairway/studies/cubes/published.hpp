// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "fairway/core/params.hpp"

namespace fairway::cubes {

struct CubeCase;

/// A cell as published.
inline constexpr int published_runs = 5;

/// The values of the parameter phase (raja2024, section V-A).
namespace parameter_phase {
inline constexpr std::array crit_dists{6.0, 7.0, 10.0, 20.0};
inline constexpr std::array ori_errors{0.4, 0.6, 0.8};
inline constexpr std::array w2s{0.5, 2.5, 500.0};
inline constexpr std::array time_steps{0.1, 0.5, 1.0};
inline constexpr std::array time_horizons{5.0, 10.0, 20.0};
}  // namespace parameter_phase

/// A published quantity of one cell: the mean over robots and five runs, and the standard deviation of the
/// five runs' means.
struct PublishedMean {
  double mean;
  double deviation;
};

/// One cell of the comparison, from the published result files (raja2024, github
/// ToniRaja/collision_avoidance, commit 2a3f99b, simulation_results/*/comparative_*.csv). Collisions and
/// stuck robots are totals.
struct PublishedCell {
  std::string_view cube;
  std::string_view method;
  PublishedMean navigation_time_s, avoidance_time_s, avoided_count, distance_m;
  int collision_count;
  int colliding_run_count;  ///< runs with at least one collision
  int stuck_count;
};

/// Null if not published.
const PublishedCell* published_cell(std::string_view cube, std::string_view method);

/// The published value of a quantity of the comparison, by the name of the quantity.
std::optional<double> published(std::string_view cube, std::string_view method, std::string_view quantity);

/// The mean navigation time of a cell of the parameter phase, by its parameters, over four robots and five
/// runs [s] (simulation_results/high_density/parametrization_results.csv).
std::optional<double> published_tuning_time(const ParamValues& params);

/// Robots that were stuck in such a cell of potential fields, of 20; none was under ORCA.
std::optional<double> published_tuning_stuck(const ParamValues& params);

/// How far a robot was from its goal as the crossing began, over all runs of eight robots in a cube
/// (`optimal_distance_travelled`) [m].
PublishedMean recorded_start(const CubeCase& cube, std::size_t robot);

}  // namespace fairway::cubes
