// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/fleet_marks.hpp"

#include <array>
#include <cmath>

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

/// Where the body's axis forward points [NED].
Triple forward(const Quaternion& q) {
  const auto& [w, x, y, z] = q;
  return {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
}

Mark ball(const char* meaning, const Triple& centre, double diameter, const Rgba& colour) {
  return {Mark::Kind::sphere, meaning, {centre}, diameter / 2, colour};
}

}  // namespace

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
  std::vector<Mark> marks = fleet.obstacles();
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const FleetVehicle& vehicle = fleet.vehicle(i);
    const Triple& here = vehicle.truth.position_n;
    const Rgba& own = vehicle_colours[i % vehicle_colours.size()];
    const Triple ahead = forward(vehicle.truth.q_nb);
    const double half = std::fmax(vehicle.length_m, 0.5) / 2;
    marks.push_back({Mark::Kind::line,
                     "vehicle",
                     {{here[0] - half * ahead[0], here[1] - half * ahead[1], here[2] - half * ahead[2]},
                      {here[0] + half * ahead[0], here[1] + half * ahead[1], here[2] + half * ahead[2]}},
                     0,
                     own});
    marks.push_back(ball("detection", here, fleet.crit_dist_m(), alert_colour(vehicle.alert, 0.10F)));
    marks.push_back(ball("safety", here, fleet.safety_distance_m(), alert_colour(vehicle.alert, 0.40F)));
    if (trails_[i].size() > 1) marks.push_back({Mark::Kind::line, "trail", trails_[i], 0, own});
    if (vehicle.goal_n) marks.push_back(ball("goal", *vehicle.goal_n, 0.6, own));
  }
  return marks;
}

}  // namespace fairway::bridge
