// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/figures.hpp"

#include <cmath>

#include "fairway/experiment/measure_run.hpp"
#include "fairway/planning/path_planner.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/study_runs.hpp"
#include "fairway/studies/transport/field.hpp"
#include "fairway/studies/transport/plan.hpp"
#include "fairway/studies/transport/voyage_log.hpp"

namespace fairway::transport {
namespace {

using nlohmann::json;

constexpr double centimetres = 100.0;

double rounded(double value) { return page::rounded(value, centimetres); }

/// Where the first vehicle is, and what is commanded of it, once a second.
class Curve final : public FrameSink {
 public:
  explicit Curve(double period) : stride_{std::llround(1.0 / period)} {}

  void write(const Frame& frame) override {
    if (count(frame.tick) % stride_ != 0) return;
    const VehicleFrame& vehicle = frame.vehicles.front();
    const Wrench wrench = vehicle.command.wrench.value_or(vehicle.wrench);
    way_.add(frame.time, {vehicle.state.p_n.x(), vehicle.state.p_n.y(), 0.0});
    surge_.push_back(rounded(wrench[0]));
    sway_.push_back(rounded(wrench[1]));
    yaw_.push_back(rounded(wrench[5]));
  }

  json track(std::string_view label) const { return way_.track(label); }

  json forces() const {
    const std::vector<double>& t = way_.t();
    return page::lines(
        "Forces commanded", "time [s]", "surge, sway [N]; yaw [N m]",
        {page::series("surge", t, surge_), page::series("sway", t, sway_), page::series("yaw", t, yaw_)});
  }

  /// North and east over time beside what should be followed.
  json responses(const Trajectory& reference) const {
    const std::vector<double>& t = way_.t();
    std::vector<double> north, east;
    for (const double time : t) {
      const Vec2 p = reference.sample(time).position;
      north.push_back(rounded(p.x()));
      east.push_back(rounded(p.y()));
    }
    return page::lines("Response and trajectory", "time [s]", "position [m]",
                       {page::series("north", t, way_.n()), page::series("north, desired", t, north),
                        page::series("east", t, way_.e()), page::series("east, desired", t, east)});
  }

 private:
  std::int64_t stride_;
  page::Way way_{centimetres};
  std::vector<double> surge_, sway_, yaw_;
};

Curve followed(const Scenario& scenario) {
  Curve curve{scenario.step_s};
  run_into(scenario, builtin_catalogs(), sinks_of({&curve}, {}), nullptr);
  return curve;
}

json polyline(std::string_view label, std::span<const Vec2> points) {
  std::vector<double> n, e;
  for (const Vec2& p : points) {
    n.push_back(rounded(p.x()));
    e.push_back(rounded(p.y()));
  }
  return {{"label", label}, {"n", n}, {"e", e}, {"d", std::vector<double>(n.size(), 0.0)}};
}

}  // namespace

std::vector<json> redrawn(const PublishedRun& run, const std::string& title, const Overrides& overrides,
                          const RunIndex& runs) {
  const Scenario scenario = under(overrides, scenario_of(run, Plant::paper_compat));
  const Curve compat = followed(scenario);
  const Curve physical = followed(under(overrides, scenario_of(run, Plant::physical)));
  const auto made = [&](json block, Plant plant) {
    const Labels cell = cell_labels(name_of(run.which), run.method.name, name_of(plant), published_part);
    return page::linked(std::move(block), runs.run_of(cell, 1), {});
  };
  std::vector<json> blocks{page::scene(title,
                                       {made(compat.track("paper_compat"), Plant::paper_compat),
                                        made(physical.track("physical"), Plant::physical)},
                                       obstacles_of(run.which), goal_of(run.which)),
                           made(compat.forces(), Plant::paper_compat)};
  if (const auto reference = printed_reference(scenario.vehicles.front()))
    blocks.push_back(made(compat.responses(*reference), Plant::paper_compat));
  return blocks;
}

json ways(Case which, std::span<const Method> methods, const Overrides& overrides, const RunIndex& runs) {
  json vehicles = json::array();
  for (const Method& method : methods) {
    const Labels cell = cell_labels(name_of(which), method.name, name_of(Plant::physical));
    json track = followed(under(overrides, case_voyage(which, method))).track(method.name);
    vehicles.push_back(page::linked(std::move(track), runs.run_of(cell, 1), {}));
  }
  return page::scene(std::string(name_of(which)), std::move(vehicles), obstacles_of(which), goal_of(which));
}

json planned_paths() {
  const std::vector<ObstacleSpec> specs = obstacles_of(Case::four_obstacles);
  std::vector<Obstacle> obstacles;
  for (const ObstacleSpec& spec : specs) obstacles.push_back(spec.view());
  const PlanarMap map{obstacles, footprint_radius};
  const Vec3 goal = goal_of(Case::four_obstacles);
  const PathResult path = plan_path(map, {.goal = goal.head<2>(), .seed = 1});

  std::vector<Vec2> table_7;
  const auto reference =
      printed_reference(scenario_of(published_runs().back(), Plant::paper_compat).vehicles.front());
  for (std::size_t i = 0; i < reference->segments().size(); ++i)
    table_7.push_back(reference->derivative(i, 0, 0.0));
  table_7.push_back(reference->sample(reference->duration()).position);
  return page::scene("Figure 8: the path of Table 7 and one planned here, discs inflated to 4.2 m",
                     {polyline("Table 7", table_7), polyline("rrt_star", path.waypoints)}, specs, goal);
}

}  // namespace fairway::transport
