// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/zones.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "fairway/avoidance/catalog.hpp"
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

/// Keeps what AVOA draws, as blocks of the report.
class Album final : public Sketch {
 public:
  void velocity(const Vec3& v, std::string_view meaning) override {
    if (meaning == "desired" || meaning == "chosen")
      marks_.push_back({{"label", meaning}, {"x", v.y()}, {"y", v.x()}});
  }
  void half_space(const Vec3&, const Vec3&, std::string_view) override {}
  void path(std::span<const Vec3>, std::string_view) override {}
  void sphere(const Vec3&, double, std::string_view) override {}
  void image(const VelocityImage& image, std::string_view meaning) override {
    std::string rgb;
    for (const std::uint32_t pixel : image.rgb) rgb += fmt::format("{:06x}", pixel);
    const double edge = image.reach * image.side / (image.side - 1);  // outside of the outermost pixels
    const std::array reach{-edge, edge};
    pictures_.emplace_back(meaning, json{{"kind", "raster"},
                                         {"x_label", "to starboard [m/s]"},
                                         {"y_label", "ahead [m/s]"},
                                         {"x", reach},
                                         {"y", reach},
                                         {"width", image.side},
                                         {"height", image.side},
                                         {"rgb", std::move(rgb)}});
  }

  json picture(std::string_view meaning, const std::string& title) const {
    for (const auto& [name, picture] : pictures_) {
      if (name != meaning) continue;
      json block = picture;
      block["title"] = title;
      block["marks"] = marks_;
      return block;
    }
    return page::note("warning", fmt::format("AVOA drew no {}", meaning));
  }

 private:
  std::vector<std::pair<std::string, json>> pictures_;
  json marks_ = json::array();
};

Album drawn(const Scene& scene, const ParamValues& params) {
  Album album;
  const Situation situation{.time = 0.0,
                            .period = 0.2,
                            .own = {.velocity = {scene.wanted, 0.0, 0.0}, .radius = vessel_radius},
                            .goal = {.position = goal, .cruise_speed = scene.wanted},
                            .limits = {.max_speed = 1.5, .max_turn_rate = 0.3751},
                            .tracks = scene.tracks,
                            .obstacles = scene.obstacles};
  (void)builtin_avoiders().make("avoa", params, Rng{1}).decide(situation, &album);
  return album;
}

}  // namespace

std::vector<json> zone_figures() {
  const ParamValues no_kinematics{{"thruster_speed_mps", 100.0}, {"least_speed_mps", 0.0}};
  const Scene one{.obstacles = {buoy(5.0, 0.0)}, .tracks = {}};
  const Scene two{.obstacles = {buoy(5.0, 2.0)}, .tracks = {vessel(1, 5.0, -3.0, 0.0, 0.55)}};
  const Scene crossing{.obstacles = {},
                       .tracks = {vessel(1, 6.0, -3.0, 0.0, 0.55), vessel(2, 6.0, 3.5, -0.3, -0.4)}};

  const auto zones = [](const Scene& scene, const ParamValues& params, const std::string& title) {
    return drawn(scene, params).picture("protective zones", title);
  };
  const auto danger = [](const Scene& scene, const ParamValues& params, const std::string& title) {
    return drawn(scene, params).picture("cost of danger", title);
  };
  return {page::grid(2, {zones(one, no_kinematics, "Figure 3a: one static obstacle"),
                         danger(one, no_kinematics, "Figure 3a: cost of danger"),
                         zones(two, no_kinematics, "Figure 3b: a static and a moving one"),
                         danger(two, no_kinematics, "Figure 3b: cost of danger")}),
          page::grid(2, {zones(one, {}, "Figure 4a: with the thrusters' limits"),
                         zones(two, {}, "Figure 4b: with the thrusters' limits")}),
          page::grid(2, {zones(crossing, {}, "Figure 5: two moving obstacles"),
                         drawn(crossing, {}).picture("metric", "Figure 6: the metric, lighter is better")})};
}

}  // namespace fairway::surface
