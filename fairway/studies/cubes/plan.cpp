// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/plan.hpp"

#include <algorithm>
#include <numeric>

#include "fairway/core/text.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/scenario/load.hpp"

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

std::string label_of(const ParamValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? number_text(*number) : "true";
}

/// Over the vehicles of a run, and how many they are.
std::pair<double, int> sum_of(const std::vector<Measure>& run, std::string_view quantity) {
  double sum = 0.0;
  int count = 0;
  for (const Measure& measure : run) {
    if (measure.quantity != quantity) continue;
    sum += measure.value;
    ++count;
  }
  return {sum, count};
}

}  // namespace

ParamValues Cell::varied() const {
  if (code == Code::corrected_told) return {{"told_m", told_m}};
  if (part != Part::tuning) return heard;
  ParamValues values{{"crit_dist_m", tuning.crit_dist_m}, {"ori_error_rad", tuning.ori_error_rad}};
  if (method->orca) {
    values.emplace_back("time_step_s", tuning.time_step_s);
    values.emplace_back("time_horizon_s", tuning.time_horizon_s);
  } else {
    values.emplace_back("w2_ratio", tuning.w2_ratio);
  }
  return values;
}

Labels Cell::labels() const {
  Labels labels{
      {"case", name()}, {"method", std::string(method->name)}, {"mode", std::string(name_of(code))}};
  for (const auto& [name, value] : varied()) labels.emplace_back(name, label_of(value));
  return labels;
}

std::vector<Cell> tuning_cells() {
  std::vector<Cell> cells;
  const CubeCase& cube = comparison_cases()[0];
  const auto add = [&](const Method& method, const Tuning& tuning) {
    cells.push_back({Part::tuning, &cube, &method, Code::as_coded, tuning, published_runs});
  };
  for (const double crit_dist : crit_dists) {
    for (const double ori_error : ori_errors) {
      for (const double w2 : w2s) {
        add(methods()[0], {.crit_dist_m = crit_dist, .ori_error_rad = ori_error, .w2_ratio = w2});
      }
      for (const double time_step : time_steps) {
        for (const double horizon : time_horizons) {
          add(methods()[1], {.crit_dist_m = crit_dist,
                             .ori_error_rad = ori_error,
                             .time_step_s = time_step,
                             .time_horizon_s = horizon});
        }
      }
    }
  }
  return cells;
}

std::vector<Cell> comparison_cells(Code code, int runs) {
  std::vector<Cell> cells;
  for (const CubeCase& cube : comparison_cases()) {
    for (const Method& method : methods()) {
      cells.push_back({Part::comparison, &cube, &method, code, comparison_tuning(cube, method),
                       is_as_coded(code) ? published_runs : runs});
    }
  }
  return cells;
}

std::vector<Cell> heading_cells() {
  std::vector<Cell> cells = comparison_cells(Code::as_coded_north, published_runs);
  std::erase_if(cells, [](const Cell& cell) {
    return cell.method->orca || cell.cube->team != 8 || cell.cube->half_edge_m < 30;
  });
  return cells;
}

std::vector<Cell> replica_cells(Code code, int replicas) {
  std::vector<Cell> cells = comparison_cells(code, 0);
  for (Cell& cell : cells) {
    cell.runs = published_runs * replicas;
    cell.first_seed = published_runs + 1;
  }
  return cells;
}

std::vector<Cell> timing_cells(int runs) {
  std::vector<Cell> cells;
  for (const Code code : {Code::as_coded_timing, Code::as_coded_starts_timing}) {
    for (const ParamValues& heard : hearings()) {
      for (const CubeCase& cube : comparison_cases()) {
        const Method& apf = methods()[0];
        cells.push_back({Part::comparison, &cube, &apf, code, comparison_tuning(cube, apf), runs, 1, heard});
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
        Tuning tuning = comparison_tuning(cube, method);
        (method.orca ? tuning.radius_m : tuning.crit_dist_m) = method.orca ? told / 2 : 2 * told;
        cells.push_back({Part::comparison, &cube, &method, Code::corrected_told, tuning, runs, 1, {}, told});
      }
    }
  }
  return cells;
}

std::vector<RunSpec> specs_of(const Cell& cell) {
  // the seed stands in the scenario in one place, so one digest serves the cell
  const std::string scenario = Digest::of(to_yaml(cell.scenario(0)));
  std::vector<RunSpec> specs;
  for (int run = 0; run < cell.runs; ++run) {
    const std::uint64_t seed = cell.first_seed + static_cast<std::uint64_t>(run);
    std::string key = "cubes/" + cell.name() + "/" + std::string(cell.method->name) + "/" +
                      std::string(name_of(cell.code)) + "/" + scenario + "/" + std::to_string(results_epoch) +
                      "/" + std::to_string(seed);
    specs.push_back({std::move(key), cell.labels(), seed, {}});
  }
  return specs;
}

std::vector<double> CellResults::values(std::string_view quantity, std::optional<int> vehicle) const {
  std::vector<double> found;
  for (const auto& run : runs) {
    for (const Measure& measure : run) {
      if (measure.quantity == quantity && (!vehicle || measure.vehicle == *vehicle))
        found.push_back(measure.value);
    }
  }
  return found;
}

std::vector<double> CellResults::run_means(std::string_view quantity) const {
  std::vector<double> means;
  for (const auto& run : runs) {
    const auto [sum, count] = sum_of(run, quantity);
    if (count > 0) means.push_back(sum / count);
  }
  return means;
}

std::vector<double> CellResults::run_totals(std::string_view quantity) const {
  std::vector<double> totals;
  for (const auto& run : runs) totals.push_back(sum_of(run, quantity).first);
  return totals;
}

std::size_t CellResults::colliding_runs() const {
  const std::vector<double> collisions = run_totals("collision_count");
  return static_cast<std::size_t>(
      std::ranges::count_if(collisions, [](double count) { return count > 0.0; }));
}

double CellResults::total(std::string_view quantity) const {
  const std::vector<double> totals = run_totals(quantity);
  return std::accumulate(totals.begin(), totals.end(), 0.0);
}

}  // namespace fairway::cubes
