// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/plan.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/experiment/compare.hpp"

namespace fairway::cubes {
namespace {

using namespace parameter_phase;

/// What may have happened to messages and odometry, one thing at a time and then together.
const std::vector<ParamValues>& hearings() {
  static const std::vector<ParamValues> all{
      {{"late_s", 0.5}},
      {{"jitter_s", 0.2}},
      {{"out_of_step", true}},
      {{"own_period_s", 0.5}},
      {{"command_late_s", 0.2}},
      {{"noise_m", 0.3}},
      {{"lost_ratio", 0.5}},
      {{"lost_ratio", 0.6}},
      {{"late_s", 0.1},
       {"jitter_s", 0.1},
       {"out_of_step", true},
       {"own_period_s", 0.1},
       {"command_late_s", 0.1},
       {"noise_m", 0.05}},
  };
  return all;
}

/// What the runs of a cell have in common.
struct Crossing {
  const CubeCase& cube;
  const Method& method;
  Code code;
  Tuning tuning = comparison_tuning(cube, method);
  ParamValues heard{};
};

Cell cell_of(std::string_view place, const Crossing& crossing, const ParamValues& params, int runs,
             std::uint64_t first_seed = 1) {
  Cell cell{.place = std::string(place),
            .method = std::string(crossing.method.name),
            .mode = std::string(name_of(crossing.code)),
            .params = params};
  const auto scenario = [crossing](std::uint64_t seed) {
    const auto& [cube, method, code, tuning, heard] = crossing;
    return cube_scenario(cube, method, code, tuning, seed, heard);
  };
  cell.add_runs("cubes", runs, scenario, first_seed, true);
  return cell;
}

}  // namespace

std::vector<Cell> tuning_cells() {
  std::vector<Cell> cells;
  const CubeCase& cube = comparison_cases()[0];
  const auto add = [&](const Method& method, const Tuning& values, const ParamValues& params) {
    cells.push_back(
        cell_of(tuning_place, {cube, method, Code::as_coded, values, {}}, params, published_runs));
  };
  for (const double crit_dist : crit_dists) {
    for (const double ori_error : ori_errors) {
      const ParamValues both{{"crit_dist_m", crit_dist}, {"ori_error_rad", ori_error}};
      for (const double w2 : w2s) {
        add(methods()[0], {.crit_dist_m = crit_dist, .ori_error_rad = ori_error, .w2_ratio = w2},
            merged(both, {{"w2_ratio", w2}}));
      }
      for (const double time_step : time_steps) {
        for (const double horizon : time_horizons) {
          add(methods()[1],
              {.crit_dist_m = crit_dist,
               .ori_error_rad = ori_error,
               .time_step_s = time_step,
               .time_horizon_s = horizon},
              merged(both, {{"time_step_s", time_step}, {"time_horizon_s", horizon}}));
        }
      }
    }
  }
  return cells;
}

std::vector<Cell> comparison_cells(Code code, int runs, std::uint64_t first_seed) {
  std::vector<Cell> cells;
  for (const CubeCase& cube : comparison_cases()) {
    for (const Method& method : methods())
      cells.push_back(cell_of(cube.name, {cube, method, code}, {}, runs, first_seed));
  }
  return cells;
}

std::vector<Cell> heading_cells() {
  std::vector<Cell> cells = comparison_cells(Code::as_coded_north, published_runs);
  std::erase_if(cells,
                [](const Cell& cell) { return is_orca(cell.method) || !cell.place.starts_with("cube60_8"); });
  return cells;
}

std::vector<Cell> replica_cells(Code code, int replicas) {
  return comparison_cells(code, published_runs * replicas, published_runs + 1);
}

std::vector<Cell> timing_cells(int runs) {
  std::vector<Cell> cells;
  for (const Code code : {Code::as_coded_timing, Code::as_coded_starts_timing}) {
    for (const ParamValues& heard : hearings()) {
      for (const CubeCase& cube : comparison_cases()) {
        Crossing crossing{cube, methods()[0], code};
        crossing.heard = heard;
        cells.push_back(cell_of(cube.name, crossing, heard, runs));
      }
    }
  }
  return cells;
}

std::vector<Cell> told_cells(int runs) {
  std::vector<Cell> cells;
  for (const CubeCase& cube : comparison_cases()) {
    if (cube.retuned) continue;
    for (const Method& method : methods()) {
      for (const double told : {3.0, 6.0}) {
        Crossing crossing{cube, method, Code::corrected_told};
        if (is_orca(method.name)) crossing.tuning.radius_m = told / 2;
        if (!is_orca(method.name)) crossing.tuning.crit_dist_m = 2 * told;
        cells.push_back(cell_of(cube.name, crossing, {{"told_m", told}}, runs));
      }
    }
  }
  return cells;
}

std::vector<double> values_of(const Cell& cell, std::string_view quantity, std::optional<int> vehicle) {
  std::vector<double> found;
  for (const auto& run : cell.results) {
    for (const Measure& measure : run) {
      if (measure.quantity == quantity && (!vehicle || measure.vehicle == *vehicle))
        found.push_back(measure.value);
    }
  }
  return found;
}

std::vector<double> run_means(const Cell& cell, std::string_view quantity) {
  std::vector<double> means;
  for (const auto& run : cell.results) {
    const double mean = run_value(run, quantity);
    if (!std::isnan(mean)) means.push_back(mean);
  }
  return means;
}

std::vector<double> run_totals(const Cell& cell, std::string_view quantity) {
  std::vector<double> totals;
  for (const auto& run : cell.results) {
    double& total = totals.emplace_back();
    for (const Measure& measure : run) total += measure.quantity == quantity ? measure.value : 0.0;
  }
  return totals;
}

std::size_t colliding_runs(const Cell& cell) {
  const std::vector<double> collisions = run_totals(cell, "collision_count");
  return static_cast<std::size_t>(
      std::ranges::count_if(collisions, [](double count) { return count > 0.0; }));
}

}  // namespace fairway::cubes
