// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/angles.hpp"
#include "fairway/perception/sonar/sonar_params.hpp"
#include "fairway/view/film_water.hpp"
#include "fairway/view/playback.hpp"
#include "fairway/view/scene_hull.hpp"

namespace fairway {
namespace {

using nlohmann::json;

json scene_point(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

json vehicle_scene(const VehicleSpec& spec) {
  const Hull hull = hull_of(spec);
  json parts = json::array();
  for (const HullPart& part : hull.parts)
    parts.push_back({{"x_m", part.x}, {"y_m", part.y}, {"z_m", part.z}, {"yaw_rad", part.yaw}});
  return {{"id", spec.id},
          {"name", spec.name},
          {"model", spec.model->name},
          {"avoider", spec.avoider->name},
          {"shape", hull.shape},
          {"length_m", hull.length},
          {"beam_m", hull.beam},
          {"radius_m", spec.radius_m},
          {"cooperative", spec.cooperative},
          {"parts", parts}};
}

json obstacle_scene(const ObstacleSpec& spec) {
  json vertices = json::array();
  for (const Vec3& vertex : spec.vertices) vertices.push_back(scene_point(vertex));
  return {{"kind", enum_name(spec.kind)},
          {"charted", spec.charted},
          {"position", scene_point(spec.position)},
          {"radius", spec.radius},
          {"velocity", scene_point(spec.velocity)},
          {"from", scene_point(spec.from)},
          {"to", scene_point(spec.to)},
          {"vertices", vertices}};
}

json waves_scene(const Scenario& scenario) {
  const Sea sea{scenario.water, Rng{scenario.seed}};
  json waves = json::array();
  for (const WaveComponent& wave : sea.waves()) {
    waves.push_back({{"amplitude_m", wave.amplitude},
                     {"frequency_radps", wave.frequency},
                     {"number_radpm", wave.number},
                     {"phase_rad", wave.phase},
                     {"direction", {wave.direction.x(), wave.direction.y()}}});
  }
  return waves;
}

json sonar_scene(const PerceptionSpec& perception) {
  if (perception.kind.name != "sonar") return nullptr;
  // its other parameters are the tracker's
  const auto sonar = params_of<SonarParams>(perception.kind.params, {}, true);
  return {{"min_range_m", sonar.min_range_m},
          {"max_range_m", sonar.max_range_m},
          {"half_field_rad", radians(0.5 * sonar.field_of_view_deg)},
          {"half_aperture_rad", radians(0.5 * sonar.vertical_aperture_deg)}};
}

}  // namespace

json scene_of(const Scenario& scenario) {
  json vehicles = json::array(), obstacles = json::array();
  for (const VehicleSpec& spec : scenario.vehicles) vehicles.push_back(vehicle_scene(spec));
  for (const ObstacleSpec& spec : scenario.obstacles) obstacles.push_back(obstacle_scene(spec));
  return {
      {"vehicles", vehicles},
      {"obstacles", obstacles},
      {"exam",
       {{"crit_dist_m", scenario.exam.crit_dist_m}, {"safety_distance_m", scenario.exam.safety_distance_m}}},
      {"waves", waves_scene(scenario)},
      {"current_depths_m", current_depths(scenario.water)},
      {"sonar", sonar_scene(scenario.perception)}};
}

}  // namespace fairway
