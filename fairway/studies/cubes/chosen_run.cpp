// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/chosen_run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fairway/sim/simulation.hpp"
#include "fairway/studies/cubes/cubes.hpp"
#include "fairway/studies/study_runs.hpp"

namespace fairway::cubes {
namespace {

using nlohmann::json;

double rounded(double value) { return std::round(value * 100.0) / 100.0; }

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
      if (path.t.empty())
        path.goal = {frame.vehicles[i].goal.x(), frame.vehicles[i].goal.y(), frame.vehicles[i].goal.z()};
      path.t.push_back(rounded(static_cast<double>(elapsed) * frame.period));
      path.n.push_back(rounded(p.x()));
      path.e.push_back(rounded(p.y()));
      path.d.push_back(rounded(p.z()));
      path.separation.push_back(rounded(separation(frame, i)));
    }
  }

  json trajectories(const std::string& title) const {
    json vehicles = json::array(), goals = json::array();
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      const Path& path = paths_[i];
      vehicles.push_back(
          {{"label", fmt::format("robot{}", i)}, {"n", path.n}, {"e", path.e}, {"d", path.d}, {"t", path.t}});
      goals.push_back(path.goal);
    }
    return {{"kind", "trajectories"}, {"title", title}, {"vehicles", vehicles}, {"goals", goals}};
  }

  json separations(const std::string& title) const {
    json series = json::array();
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      series.push_back(
          {{"label", fmt::format("robot{}", i)}, {"x", paths_[i].t}, {"y", paths_[i].separation}});
    }
    return {{"kind", "lines"},
            {"title", title},
            {"x_label", "time under way [s]"},
            {"y_label", "distance to the nearest vehicle [m]"},
            {"series", series},
            {"lines", {{{"label", "collision"}, {"value", 3.0}}}}};
  }

 private:
  static constexpr std::int64_t stride = 20;  // once a second

  struct Path {
    std::vector<double> t, n, e, d, separation;
    std::array<double, 3> goal{};
  };

  static double separation(const Frame& frame, std::size_t index) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < frame.vehicles.size(); ++j) {
      if (j == index) continue;
      nearest = std::fmin(nearest, (frame.vehicles[j].state.p_n - frame.vehicles[index].state.p_n).norm());
    }
    return nearest;
  }

  std::vector<Path> paths_;
  std::int64_t start_{-1};
};

}  // namespace

std::vector<json> chosen_run_blocks(const CubeCase& cube, const Method& method, Code code, std::uint64_t seed,
                                    const Overrides& overrides) {
  const Scenario scenario =
      under(overrides, cube_scenario(cube, method, code, comparison_tuning(cube, method), seed));
  Curves curves{scenario.vehicles.size()};
  const std::array<FrameSink*, 1> sinks{&curves};
  Simulation{scenario, cube_catalogs()}.run(sinks);
  const std::string title = fmt::format("{}, {}, {}, seed {}", cube.name, method.name, name_of(code), seed);
  return {curves.trajectories(title), curves.separations("Separation: " + title)};
}

}  // namespace fairway::cubes
