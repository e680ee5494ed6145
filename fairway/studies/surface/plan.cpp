// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/plan.hpp"

#include <algorithm>

namespace fairway::surface {
namespace {

constexpr int published_seeds = 8;
constexpr double duration = 90.0;     // [s]
constexpr double wanted_speed = 1.2;  // [m/s]; not published, 25 m in 22 s is 1.14 m/s

struct PublishedOutcome {
  Course course{};
  std::string_view method;
  std::optional<double> time_s;
  bool arrived{};
  bool touched{};
};

/// campos2019, section IV-B.
constexpr std::array outcomes{
    PublishedOutcome{Course::u_wall, "avoa", 33.0, true, false},
    PublishedOutcome{Course::cluttered, "avoa", 25.0, true, false},
    PublishedOutcome{Course::head_on, "avoa", 35.0, true, false},
    PublishedOutcome{Course::orthogonal, "avoa", 27.0, true, false},
    PublishedOutcome{Course::diagonal, "avoa", 22.0, true, false},
    PublishedOutcome{Course::u_wall, "teb", {}, false, false},
    PublishedOutcome{Course::cluttered, "teb", 71.0, true, false},
    PublishedOutcome{Course::head_on, "teb", {}, false, true},
    PublishedOutcome{Course::orthogonal, "teb", 64.0, true, false},
    PublishedOutcome{Course::diagonal, "teb", 70.0, true, false},
};

/// The package's default limits, 0.4 m/s and 0.3 rad/s, or those that the paper states, each without and with
/// moving obstacles, and under a global planner that knows of the buoys.
std::array<Method, 6> teb_settings() {
  const auto setting = [](std::string_view name, double speed, double turn_rate, bool dynamic, bool planned) {
    Method method{name,
                  "teb",
                  {{"max_vel_x_mps", speed},
                   {"max_vel_theta_radps", turn_rate},
                   {"include_dynamic_obstacles", dynamic}}};
    if (planned) method.params.emplace_back("global_plan", std::string("rrt_star"));
    return method;
  };
  return {setting("teb_0.4", 0.4, 0.3, false, false),
          setting("teb_0.4_dynamic", 0.4, 0.3, true, false),
          setting("teb_1.5", 1.5, 0.3751, false, false),
          setting("teb_1.5_dynamic", 1.5, 0.3751, true, false),
          setting("teb_0.4_planned", 0.4, 0.3, false, true),
          setting("teb_1.5_planned", 1.5, 0.3751, false, true)};
}

std::vector<Method> with_others() {
  std::vector<Method> methods{compared_methods().begin(), compared_methods().end()};
  const auto improved = [](std::string_view name, bool turn_aware, bool memory) {
    return Method{name, "avoa_improved", {{"turn_aware", turn_aware}, {"memory", memory}}};
  };
  methods.push_back(improved("improved_turn_only", true, false));
  methods.push_back(improved("improved_memory_only", false, true));
  methods.push_back(improved("improved_neither", false, false));
  methods.push_back({"apf", "apf", {}});
  methods.push_back({"orca3d", "orca3d", {{"time_horizon_s", 8.0}, {"obstacle_time_horizon_s", 8.0}}});
  methods.push_back({"direct+filter", "direct+safety_filter", {}});
  methods.push_back({"wall_following", "wall_following", {{"form", std::string("corrected")}}});
  methods.push_back({"rrt_star", "rrt_star", {{"clearance_m", 0.5}}});
  methods.push_back({"blend", "blend", {}});
  return methods;
}

/// AVOA's velocity is a speed and a heading to be turned to at that speed; TEB commands a turn rate itself;
/// the others expect to go where their velocity points, so they slow down while they turn.
Choice steering_of(const Method& method) {
  const bool keeps_speed = method.algorithm.starts_with("avoa");
  return {.name = keeps_speed ? "speed_and_course" : "proportional",
          .params = {{"turn_gain_hz", 1.0}, {"max_turn_rate_radps", 0.3751}},
          .path = "vehicles[0].steering"};
}

Choice model_of(Vessel vessel) {
  Choice model{.name = "zarco", .path = "vehicles[0].model"};
  if (vessel == Vessel::zarco) return model;
  model.name = "kinematic";
  model.params = {{"max_speed_mps", 1.5},           {"max_reverse_mps", 0.5},
                  {"max_heave_mps", 0.0},           {"max_turn_rate_radps", 0.3751},
                  {"max_acceleration_mps2", 100.0}, {"max_turn_acceleration_radps2", 10.0},
                  {"time_constant_s", 0.05}};
  return model;
}

Cell cell_of(Course course, Vessel vessel, const Method& method, std::string_view mode, int seeds,
             const std::function<Layout(std::uint64_t)>& layout) {
  const auto scenario = [course, vessel, &method, layout](std::uint64_t seed) {
    return passage(course, layout(seed), vessel, method, seed);
  };
  return planned_cell("surface", name_of(course), method.name, mode, seeds, scenario);
}

}  // namespace

std::string_view name_of(Vessel vessel) { return vessel == Vessel::zarco ? "zarco" : "at_once"; }

std::optional<double> published(Course course, std::string_view method, std::string_view quantity) {
  for (const PublishedOutcome& outcome : outcomes) {
    if (outcome.course != course || !method.starts_with(outcome.method) || method == "avoa_improved")
      continue;
    if (quantity == "navigation_time_s") return outcome.time_s;
    if (quantity == "success_ratio") return outcome.arrived ? 1.0 : 0.0;
    if (quantity == "touched_ratio") return outcome.touched ? 1.0 : 0.0;
  }
  return {};
}

std::span<const Method> compared_methods() {
  static const std::vector<Method> methods = [] {
    std::vector<Method> list{{"avoa", "avoa", {}},
                             {"avoa_exhaustive", "avoa", {{"search", std::string("exhaustive")}}},
                             {"avoa_improved", "avoa_improved", {}}};
    std::ranges::copy(teb_settings(), std::back_inserter(list));
    return list;
  }();
  return methods;
}

std::span<const Method> all_methods() {
  static const std::vector<Method> methods = with_others();
  return methods;
}

Scenario passage(Course course, const Layout& layout, Vessel vessel, const Method& method,
                 std::uint64_t seed) {
  Scenario scenario{.name = std::string(name_of(course)), .duration_s = duration, .seed = seed};
  scenario.steps_per_decision = 4;
  scenario.exam.time_coefficient_ratio = 1e6;
  scenario.water = layout.water;
  scenario.obstacles = layout.obstacles();

  VehicleSpec own{.name = std::string(name_of(vessel))};
  own.model = model_of(vessel);
  own.avoider =
      Choice{.name = std::string(method.algorithm), .params = method.params, .path = "vehicles[0].avoider"};
  own.steering = steering_of(method);
  own.position = layout.start;
  own.yaw = layout.heading;
  own.radius_m = vessel_radius;
  own.limits = {.max_speed = 1.5, .max_climb_rate = 0.0, .max_acceleration = 0.5, .max_turn_rate = 0.3751};
  own.mission = {
      {.kind = LegKind::transit, .position = layout.goal, .speed_mps = wanted_speed, .arrival_m = 1.0}};
  scenario.vehicles = {own};
  return scenario;
}

std::vector<Cell> published_cells() {
  std::vector<Cell> cells;
  for (const Course course : courses) {
    for (const Vessel vessel : vessels) {
      const auto layout = [course, vessel](std::uint64_t) {
        Layout drawn = layout_of(course);
        if (vessel == Vessel::at_once) drawn.water = {};
        return drawn;
      };
      for (const Method& method : compared_methods())
        cells.push_back(cell_of(course, vessel, method, name_of(vessel), published_seeds, layout));
    }
  }
  return cells;
}

std::vector<Cell> varied_cells(int seeds) {
  std::vector<Cell> cells;
  for (const Course course : courses) {
    const auto layout = [course](std::uint64_t seed) { return varied(course, seed); };
    for (const Method& method : all_methods())
      cells.push_back(cell_of(course, Vessel::zarco, method, "varied", seeds, layout));
  }
  return cells;
}

}  // namespace fairway::surface
