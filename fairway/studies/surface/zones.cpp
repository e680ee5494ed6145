// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/zones.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/drawing.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/surface/course.hpp"

namespace fairway::surface {
namespace {

using nlohmann::json;

/// What is near the vessel, which lies at the origin, heads north and wants to go there at `wanted` m/s.
struct Scene {
  std::vector<Obstacle> obstacles;
  std::vector<Track> tracks;
  double wanted{1.2};
};

Obstacle buoy(double n, double e) {
  return {.kind = Obstacle::Kind::sphere, .position = {n, e, 0.0}, .radius = buoy_radius};
}

Track vessel(std::uint32_t id, double n, double e, double v_n, double v_e) {
  return {.id = TrackId{id},
          .position = {n, e, 0.0},
          .velocity = {v_n, v_e, 0.0},
          .radius = vessel_radius,
          .reacts = false};
}

json raster_of(const Stroke& image) {
  std::string rgb;
  for (const std::uint32_t pixel : image.rgb) rgb += fmt::format("{:06x}", pixel);
  const double edge = image.size * image.side / (image.side - 1);  // outside of the outermost pixels
  const std::array reach{-edge, edge};
  return {{"kind", "raster"},
          {"x_label", "to starboard [m/s]"},
          {"y_label", "ahead [m/s]"},
          {"x", reach},
          {"y", reach},
          {"width", image.side},
          {"height", image.side},
          {"rgb", std::move(rgb)}};
}

/// Where the desired and the chosen velocity are in a picture.
json marks_in(const Drawing& drawing) {
  json marks = json::array();
  for (const Stroke& stroke : drawing.strokes()) {
    if (stroke.meaning != "desired" && stroke.meaning != "chosen") continue;
    const Vec3& v = stroke.points.front();
    marks.push_back({{"label", stroke.meaning}, {"x", v.y()}, {"y", v.x()}});
  }
  return marks;
}

/// What AVOA drew, as a block of the report.
json picture(const Drawing& drawing, std::string_view meaning, const std::string& title) {
  for (const Stroke& stroke : drawing.strokes()) {
    if (stroke.kind != Stroke::Kind::image || stroke.meaning != meaning) continue;
    json block = raster_of(stroke);
    block["title"] = title;
    block["marks"] = marks_in(drawing);
    return block;
  }
  return page::note("warning", fmt::format("AVOA drew no {}", meaning));
}

Drawing drawn(const Scene& scene, const ParamValues& params) {
  Drawing drawing;
  const Situation situation{.time = 0.0,
                            .period = 0.2,
                            .own = {.velocity = {scene.wanted, 0.0, 0.0}, .radius = vessel_radius},
                            .goal = {.position = Layout{}.goal, .cruise_speed = scene.wanted},
                            .limits = {.max_speed = 1.5, .max_turn_rate = 0.3751},
                            .tracks = scene.tracks,
                            .obstacles = scene.obstacles};
  (void)builtin_avoiders().make("avoa", params, Rng{1}).decide(situation, &drawing);
  return drawing;
}

}  // namespace

std::vector<json> zone_figures() {
  const ParamValues no_kinematics{{"thruster_speed_mps", 100.0}, {"least_speed_mps", 0.0}};
  const Scene one{.obstacles = {buoy(5.0, 0.0)}, .tracks = {}};
  const Scene two{.obstacles = {buoy(5.0, 2.0)}, .tracks = {vessel(1, 5.0, -3.0, 0.0, 0.55)}};
  const Scene crossing{.obstacles = {},
                       .tracks = {vessel(1, 6.0, -3.0, 0.0, 0.55), vessel(2, 6.0, 3.5, -0.3, -0.4)}};

  const auto zones = [](const Scene& scene, const ParamValues& params, const std::string& title) {
    return picture(drawn(scene, params), "protective zones", title);
  };
  const auto danger = [](const Scene& scene, const ParamValues& params, const std::string& title) {
    return picture(drawn(scene, params), "cost of danger", title);
  };
  return {page::grid(2, {zones(one, no_kinematics, "Figure 3a: one static obstacle"),
                         danger(one, no_kinematics, "Figure 3a: cost of danger"),
                         zones(two, no_kinematics, "Figure 3b: a static and a moving one"),
                         danger(two, no_kinematics, "Figure 3b: cost of danger")}),
          page::grid(2, {zones(one, {}, "Figure 4a: with the thrusters' limits"),
                         zones(two, {}, "Figure 4b: with the thrusters' limits")}),
          page::grid(2, {zones(crossing, {}, "Figure 5: two moving obstacles"),
                         picture(drawn(crossing, {}), "metric", "Figure 6: the metric, lighter is better")})};
}

}  // namespace fairway::surface
