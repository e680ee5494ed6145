// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/plan.hpp"

namespace fairway::transport {

std::vector<Cell> published_cells() {
  std::vector<Cell> cells;
  for (const PublishedRun& run : published_runs()) {
    for (const Plant plant : plants) {
      Cell cell{.place = std::string(name_of(run.which)),
                .method = std::string(run.method.name),
                .mode = std::string(name_of(plant)),
                .part = std::string(published_part)};
      cell.add_runs("transport", 1, [&run, plant](std::uint64_t) { return scenario_of(run, plant); });
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

std::span<const Method> compared_methods() {
  static const ParamValues corrected{{"form", std::string("corrected")}};
  static const ParamValues roomy{{"clearance_m", 0.5}};  // what the filter keeps
  static const std::array methods{
      Method{"direct+filter", "direct+safety_filter", {}},
      Method{"hard_switching", "hard_switching", {}},
      Method{"hard_switching+filter", "hard_switching+safety_filter", {}},
      Method{"wall_following", "wall_following", {}},
      Method{"wall_following+filter", "wall_following+safety_filter", {}},
      Method{"corrected", "wall_following", corrected},
      Method{"corrected+filter", "wall_following+safety_filter", corrected},
      Method{"rrt_star", "rrt_star", roomy},
      Method{"rrt_star+filter", "rrt_star+safety_filter", roomy},
      Method{"blend", "blend", {}},
      Method{"orca3d", "orca3d", {{"time_horizon_s", 20.0}, {"obstacle_time_horizon_s", 20.0}}},
      Method{"orca3d+filter",
             "orca3d+safety_filter",
             {{"time_horizon_s", 20.0}, {"obstacle_time_horizon_s", 20.0}}},
  };
  return methods;
}

std::vector<Cell> case_cells() {
  std::vector<Cell> cells;
  for (const Case which : {Case::one_obstacle, Case::four_obstacles, Case::unknown_obstacle}) {
    for (const Method& method : compared_methods()) {
      const auto scenario = [which, &method](std::uint64_t) { return case_voyage(which, method); };
      cells.push_back(
          planned_cell("transport", name_of(which), method.name, name_of(Plant::physical), 1, scenario));
    }
  }
  return cells;
}

std::vector<Cell> field_cells(int seeds) {
  std::vector<Cell> cells;
  for (const FieldKind kind : field_kinds) {
    for (const Method& method : compared_methods()) {
      const auto scenario = [kind, &method](std::uint64_t seed) {
        Field field = random_field(kind, seed);
        return voyage(name_of(kind), method, std::move(field.obstacles), field.goal, voyage_duration, seed);
      };
      cells.push_back(
          planned_cell("transport", name_of(kind), method.name, name_of(Plant::physical), seeds, scenario));
    }
  }
  return cells;
}

}  // namespace fairway::transport
