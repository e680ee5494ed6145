// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/plan.hpp"

#include "fairway/core/text.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway::cubes {
namespace {

constexpr std::array crit_dists{6.0, 7.0, 10.0, 20.0};
constexpr std::array ori_errors{0.4, 0.6, 0.8};
constexpr std::array w2s{0.5, 2.5, 500.0};
constexpr std::array time_steps{0.1, 0.5, 1.0};
constexpr std::array time_horizons{5.0, 10.0, 20.0};

}  // namespace

ParamValues Cell::varied() const {
  if (part != Part::tuning) return {};
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
  for (const auto& [name, value] : varied()) labels.emplace_back(name, number_text(std::get<double>(value)));
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

std::vector<RunSpec> specs_of(const Cell& cell) {
  // the seed stands in the scenario in one place, so one digest serves the cell
  const std::string scenario =
      Digest::of(to_yaml(cube_scenario(*cell.cube, *cell.method, cell.code, cell.tuning, 0)));
  std::vector<RunSpec> specs;
  for (int run = 1; run <= cell.runs; ++run) {
    const auto seed = static_cast<std::uint64_t>(run);
    std::string key = "cubes/" + cell.name() + "/" + std::string(cell.method->name) + "/" +
                      std::string(name_of(cell.code)) + "/" + scenario + "/" + std::to_string(results_epoch) +
                      "/" + std::to_string(seed);
    specs.push_back({std::move(key), cell.labels(), seed, {}});
  }
  return specs;
}

std::vector<PlannedRun> plan_of(const std::vector<Cell>& cells) {
  std::vector<PlannedRun> plan;
  for (const Cell& cell : cells) {
    for (RunSpec& spec : specs_of(cell)) plan.push_back({&cell, std::move(spec)});
  }
  return plan;
}

std::vector<double> CellResults::values(std::string_view quantity, int vehicle) const {
  std::vector<double> found;
  for (const auto& run : runs) {
    for (const Measure& measure : run) {
      if (measure.quantity == quantity && (vehicle == -2 || measure.vehicle == vehicle))
        found.push_back(measure.value);
    }
  }
  return found;
}

std::vector<double> CellResults::run_means(std::string_view quantity) const {
  std::vector<double> means;
  for (const auto& run : runs) {
    double sum = 0.0;
    int count = 0;
    for (const Measure& measure : run) {
      if (measure.quantity != quantity) continue;
      sum += measure.value;
      ++count;
    }
    if (count > 0) means.push_back(sum / count);
  }
  return means;
}

double CellResults::total(std::string_view quantity) const {
  double sum = 0.0;
  for (const double value : values(quantity)) sum += value;
  return sum;
}

}  // namespace fairway::cubes
