// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/chosen_run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/cubes/cubes.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/study_runs.hpp"

namespace fairway::cubes {
namespace {

using nlohmann::json;

constexpr double centimetres = 100.0;

/// Gathers every vehicle's path and separation from the first tick under way.
class Curves final : public FrameSink {
 public:
  explicit Curves(std::size_t vehicles) : paths_(vehicles) {}

  void write(const Frame& frame) override {
    if (frame.vehicles[0].phase == Phase::deploying || frame.vehicles[0].phase == Phase::waiting) return;
    if (start_ < 0) start_ = count(frame.tick);
    const std::int64_t elapsed = count(frame.tick) - start_;
    if (elapsed % stride != 0) return;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      const Vec3& p = frame.vehicles[i].state.p_n;
      Path& path = paths_[i];
      if (path.separation.empty())
        path.goal = {frame.vehicles[i].goal.x(), frame.vehicles[i].goal.y(), frame.vehicles[i].goal.z()};
      path.way.add(static_cast<double>(elapsed) * frame.period, p);
      path.separation.push_back(page::rounded(separation(frame, i), centimetres));
    }
  }

  json trajectories(const std::string& title) const {
    json vehicles = json::array(), goals = json::array();
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      const Path& path = paths_[i];
      vehicles.push_back(path.way.track(fmt::format("robot{}", i)));
      goals.push_back(path.goal);
    }
    return {{"kind", "trajectories"}, {"title", title}, {"vehicles", vehicles}, {"goals", goals}};
  }

  json separations(const std::string& title) const {
    json curves = json::array();
    for (std::size_t i = 0; i < paths_.size(); ++i)
      curves.push_back(page::series(fmt::format("robot{}", i), paths_[i].way.t(), paths_[i].separation));
    json chart =
        page::lines(title, "time under way [s]", "distance to the nearest vehicle [m]", std::move(curves));
    chart["lines"] = {{{"label", "collision"}, {"value", 3.0}}};
    return chart;
  }

 private:
  static constexpr std::int64_t stride = 20;  // once a second

  struct Path {
    page::Way way{centimetres};
    std::vector<double> separation;
    std::array<double, 3> goal{};
  };

  static double separation(const Frame& frame, std::size_t index) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < frame.vehicles.size(); ++j) {
      if (j == index) continue;
      nearest = math::fmin(nearest, (frame.vehicles[j].state.p_n - frame.vehicles[index].state.p_n).norm());
    }
    return nearest;
  }

  std::vector<Path> paths_;
  std::int64_t start_{-1};
};

}  // namespace

const Cell& chosen_cell(const std::vector<Cell>& cells) {
  return find_cell(cells, "cube20_8", "orca3d", name_of(Code::corrected));
}

std::vector<json> chosen_run_blocks(const Overrides& overrides, const RunIndex& runs) {
  const std::vector<Cell> cells = comparison_cells(Code::corrected, 1);
  const Cell& cell = chosen_cell(cells);
  const StudyRun& chosen = cell.runs.front();
  const Scenario scenario = under(overrides, chosen.scenario());
  Curves curves{scenario.vehicles.size()};
  run_into(scenario, cube_catalogs(), sinks_of({&curves}, {}), nullptr);
  const std::string title =
      fmt::format("{}, {}, {}, seed {}", cell.place, cell.method, cell.mode, chosen.spec.seed);
  const json run = runs.run_of(cell.labels(), chosen.spec.seed);
  return {page::linked(curves.trajectories(title), run, {}),
          page::linked(curves.separations("Separation: " + title), run, {})};
}

}  // namespace fairway::cubes
