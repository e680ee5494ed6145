// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/fleet_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ros/bridge/avoider_parts.hpp"
#include "ros/bridge/hull_mesh.hpp"

namespace fairway::bridge {
namespace {

using Rgba = std::array<float, 4>;

constexpr double trail_spacing_m = 0.25;
constexpr std::size_t longest_trail = 2000;

// the colours of fairway view: of vehicles, and of their spheres
constexpr std::array<Rgba, 8> vehicle_colours{{{0.00F, 0.40F, 0.72F, 1.0F},
                                               {0.84F, 0.37F, 0.00F, 1.0F},
                                               {0.00F, 0.57F, 0.42F, 1.0F},
                                               {0.69F, 0.28F, 0.56F, 1.0F},
                                               {0.11F, 0.14F, 0.40F, 1.0F},
                                               {0.48F, 0.12F, 0.12F, 1.0F},
                                               {0.49F, 0.30F, 0.94F, 1.0F},
                                               {0.78F, 0.64F, 0.08F, 1.0F}}};
constexpr Rgba hull_colour{0.94F, 0.74F, 0.15F, 1.0F};
constexpr Rgba word_colour{0.09F, 0.13F, 0.17F, 1.0F};

Rgba alert_colour(Alert alert, float alpha) {
  constexpr std::array<Rgba, 3> colours{
      {{0.04F, 0.48F, 0.32F, 1}, {0.85F, 0.48F, 0.00F, 1}, {0.70F, 0.15F, 0.12F, 1}}};
  Rgba colour = colours[static_cast<std::size_t>(alert)];
  colour[3] = alpha;
  return colour;
}

double distance(const Triple& a, const Triple& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A hull in body axes, where its vehicle is. [m, NED]
std::vector<Triple> placed(const std::vector<Triple>& hull, const Motion& where) {
  const VehicleState at = fix_of(where).state;
  std::vector<Triple> points;
  points.reserve(hull.size());
  for (const Triple& point : hull) points.push_back(triple_of(at.p_n + at.q_nb * vec_of(point)));
  return points;
}

Mark ball(const char* meaning, const Triple& centre, double diameter, const Rgba& colour) {
  return {Mark::Kind::sphere, meaning, {centre}, diameter / 2, colour};
}

Mark line(const char* meaning, const std::vector<Triple>& points, const Rgba& colour, double width) {
  return {Mark::Kind::line, meaning, points, 0.0, colour, width};
}

}  // namespace

FleetMarks::FleetMarks(const FleetHost& fleet) : trails_(fleet.size()) {
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const FleetVehicle& vehicle = fleet.vehicle(i);
    hulls_.push_back(hull_mesh(vehicle.shape, vehicle.length_m, vehicle.beam_m));
  }
}

void FleetMarks::see(const FleetHost& fleet) {
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const Triple& here = fleet.vehicle(i).truth.position_n;
    std::vector<Triple>& trail = trails_[i];
    if (!trail.empty() && distance(trail.back(), here) < trail_spacing_m) continue;
    trail.push_back(here);
    if (trail.size() <= longest_trail) continue;
    std::size_t kept = 0;  // every second point
    for (std::size_t k = 0; k < trail.size(); k += 2) trail[kept++] = trail[k];
    trail.resize(kept);
  }
}

std::vector<Mark> FleetMarks::draw(const FleetHost& fleet) const {
  const double safety = fleet.safety_distance_m();
  const double size = std::clamp(0.25 * safety, 0.4, 2.0);  // of words and goals [m]
  std::vector<Mark> marks = fleet.obstacles();
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const FleetVehicle& vehicle = fleet.vehicle(i);
    const Triple& here = vehicle.truth.position_n;
    const Rgba& own = vehicle_colours[i % vehicle_colours.size()];
    marks.push_back({Mark::Kind::triangles, "vehicles", placed(hulls_[i], vehicle.truth), 0.0, hull_colour});
    marks.push_back(ball("detection", here, fleet.crit_dist_m(), alert_colour(vehicle.alert, 0.12F)));
    marks.push_back(ball("safety", here, safety, alert_colour(vehicle.alert, 0.30F)));
    if (trails_[i].size() > 1) marks.push_back(line("trails", trails_[i], own, 0.08 * size));
    marks.push_back({Mark::Kind::words,
                     "names",
                     {{here[0], here[1], here[2] - 0.5 * safety - size}},
                     0.0,
                     word_colour,
                     size,
                     vehicle.name});
    if (!vehicle.goal_n) continue;
    marks.push_back(ball("goals", *vehicle.goal_n, size, own));
    const Rgba faint{own[0], own[1], own[2], 0.35F};
    marks.push_back(line("goals", {here, *vehicle.goal_n}, faint, 0.04 * size));
  }
  return marks;
}

}  // namespace fairway::bridge
