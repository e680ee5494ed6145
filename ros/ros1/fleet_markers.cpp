// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/fleet_markers.hpp"

#include <algorithm>
#include <cmath>

#include "ros/ros1/hull_mesh.hpp"

namespace fairway::ros1 {
namespace {

using bridge::Alert;
using bridge::FleetVehicle;
using visualization_msgs::Marker;

constexpr double trail_spacing_m = 0.25;
constexpr std::size_t longest_trail = 2000;

// the colours of fairway view: of vehicles, and of their spheres
constexpr std::array<Colour, 8> series{{{0.00F, 0.40F, 0.72F, 1.0F},
                                        {0.84F, 0.37F, 0.00F, 1.0F},
                                        {0.00F, 0.57F, 0.42F, 1.0F},
                                        {0.69F, 0.28F, 0.56F, 1.0F},
                                        {0.11F, 0.14F, 0.40F, 1.0F},
                                        {0.48F, 0.12F, 0.12F, 1.0F},
                                        {0.49F, 0.30F, 0.94F, 1.0F},
                                        {0.78F, 0.64F, 0.08F, 1.0F}}};
constexpr Colour hull_colour{0.94F, 0.74F, 0.15F, 1.0F};
constexpr Colour word_colour{0.09F, 0.13F, 0.17F, 1.0F};

Colour alert_colour(Alert alert, float alpha) {
  switch (alert) {
    case Alert::clear:
      return {0.04F, 0.48F, 0.32F, alpha};
    case Alert::detected:
      return {0.85F, 0.48F, 0.00F, alpha};
    case Alert::collided:
      break;
  }
  return {0.70F, 0.15F, 0.12F, alpha};
}

double distance(const Triple& a, const Triple& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Every second point, the ends kept.
void thin(std::vector<Triple>& trail) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < trail.size(); i += 2) trail[kept++] = trail[i];
  if (trail.size() % 2 == 0) trail[kept++] = trail.back();
  trail.resize(kept);
}

}  // namespace

FleetMarkers::FleetMarkers(const bridge::FleetHost& fleet, Frame frame, const std::string& world)
    : markers_{frame, world},
      hulls_(fleet.size()),
      trails_(fleet.size()),
      size_{std::clamp(0.25 * fleet.safety_distance_m(), 0.4, 2.0)} {
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const FleetVehicle& vehicle = fleet.vehicle(i);
    for (const Triple& point : hull_mesh(vehicle.shape, vehicle.length_m, vehicle.beam_m))
      hulls_[i].push_back(point_of(body_in(frame, point)));
  }
}

void FleetMarkers::see(const bridge::FleetHost& fleet) {
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const Triple& here = fleet.vehicle(i).truth.position_n;
    std::vector<Triple>& trail = trails_[i];
    if (!trail.empty() && distance(trail.back(), here) < trail_spacing_m) continue;
    trail.push_back(here);
    if (trail.size() > longest_trail) thin(trail);
  }
}

const visualization_msgs::MarkerArray& FleetMarkers::draw(const bridge::FleetHost& fleet) {
  markers_.begin(fleet.time());
  for (const bridge::Mark& mark : fleet.obstacles()) markers_.add_mark(mark);
  for (std::size_t i = 0; i < fleet.size(); ++i) draw(fleet, i);
  return markers_.finish();
}

void FleetMarkers::draw(const bridge::FleetHost& fleet, std::size_t index) {
  const FleetVehicle& vehicle = fleet.vehicle(index);
  const Triple& here = vehicle.truth.position_n;
  const Colour& own = series[index % series.size()];
  markers_.add_solid("vehicles", Marker::TRIANGLE_LIST, hull_colour, vehicle.truth, {1, 1, 1}).points =
      hulls_[index];
  markers_.add_sphere("detection", alert_colour(vehicle.alert, 0.12F), here, fleet.crit_dist_m());
  markers_.add_sphere("safety", alert_colour(vehicle.alert, 0.30F), here, fleet.safety_distance_m());
  markers_.add_line("trails", own, trails_[index], 0.08 * size_);
  markers_.add_words("names", word_colour,
                     {here[0], here[1], here[2] - 0.5 * fleet.safety_distance_m() - size_}, size_,
                     vehicle.name);
  if (vehicle.goal_n) {
    markers_.add_sphere("goals", own, *vehicle.goal_n, size_);
    markers_.add_line("goals", {own[0], own[1], own[2], 0.35F}, {here, *vehicle.goal_n}, 0.04 * size_);
  }
}

}  // namespace fairway::ros1
