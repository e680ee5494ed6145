// SPDX-License-Identifier: Apache-2.0
#include "bindings/web/layout.hpp"

#include <fmt/format.h>

#include <span>

#include "fairway/scenario/overrides.hpp"

namespace fairway::web {
namespace {

using nlohmann::json;
using yaml::Tree;

constexpr std::size_t most_vehicles = 64, most_vertices = 64;

json handle(const std::string& path, const char* what, const std::string& name, const json& vehicle,
            const Vec3& at, std::size_t coordinates = 3) {
  json position = json::array();
  for (std::size_t k = 0; k < coordinates; ++k) position.push_back(at[static_cast<Eigen::Index>(k)]);
  return {{"path", path}, {"what", what}, {"name", name}, {"vehicle", vehicle}, {"position_m", position}};
}

/// The legs that lead to a place, where those of the document are those of the vehicle.
void add_goals(const Tree* mission, const VehicleSpec& vehicle, std::size_t index, json& handles) {
  if (mission == nullptr || !mission->is_list() || mission->items.size() != vehicle.mission.size()) return;
  for (std::size_t k = 0; k < mission->items.size(); ++k) {
    const Tree& leg = mission->items[k];
    if (!leg.is_map() || leg.keys.size() != 1) continue;
    const LegKind kind = vehicle.mission[k].kind;
    if (leg.keys[0] == "run" || (kind != LegKind::transit && kind != LegKind::go_to)) continue;
    handles.push_back(handle(fmt::format("vehicles[{}].mission[{}].{}.position_m", index, k, leg.keys[0]),
                             "goal", vehicle.name, index, vehicle.mission[k].position));
  }
}

void add_obstacle(const Tree& shape, const ObstacleSpec& obstacle, std::size_t index, json& handles) {
  const std::string name = fmt::format("obstacles[{}]", index);
  const std::string within = name + "." + enum_name(obstacle.kind) + ".";
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      handles.push_back(handle(within + "position_m", "obstacle", name, nullptr, obstacle.position));
      return;
    case Obstacle::Kind::segment:
      handles.push_back(handle(within + "from_m", "obstacle", name, nullptr, obstacle.from));
      handles.push_back(handle(within + "to_m", "obstacle", name, nullptr, obstacle.to));
      return;
    case Obstacle::Kind::polygon:
      const Tree* vertices = shape.items.front().find("vertices_m");
      for (std::size_t k = 0; k < std::min(obstacle.vertices.size(), most_vertices); ++k) {
        handles.push_back(handle(fmt::format("{}vertices_m[{}]", within, k), "obstacle", name, nullptr,
                                 obstacle.vertices[k], vertices->items[k].items.size()));
      }
  }
}

}  // namespace

json layout(const std::string& yaml, const std::string& file, const Overrides& set,
            std::optional<std::uint64_t> seed, const Scenario& scenario) {
  Tree document = yaml::parse_tree(yaml, file);
  const bool has_fleet = document.find("fleet") != nullptr;
  const std::size_t listed =
      document.find("vehicles") != nullptr ? document.find("vehicles")->items.size() : 0;
  yaml::apply(document, set, seed);

  json all{{"handles", json::array()},
           {"fleet_count", has_fleet ? json(scenario.vehicles.size() - listed) : json()}};
  if (scenario.vehicles.size() > most_vehicles) return all;
  const std::vector<Tree>& vehicles = document.find("vehicles")->items;
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    const VehicleSpec& vehicle = scenario.vehicles[i];
    all["handles"].push_back(
        handle(fmt::format("vehicles[{}].start.position_m", i), "start", vehicle.name, i, vehicle.position));
    add_goals(vehicles[i].find("mission"), vehicle, i, all["handles"]);
  }
  const Tree* obstacles = document.find("obstacles");
  for (std::size_t i = 0; i < scenario.obstacles.size(); ++i)
    add_obstacle(obstacles->items[i], scenario.obstacles[i], i, all["handles"]);
  return all;
}

}  // namespace fairway::web
