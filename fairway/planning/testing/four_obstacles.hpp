// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/planning/planar_map.hpp"

/// The second case of rehman2021: four obstacles of radius 1 m (Table 5), inflated to 4.2 m.
namespace fairway::four_obstacles {

inline constexpr double inflation_m = 3.2;
inline constexpr double grown_radius_m = 4.2;
inline const Vec2 start{0.0, 0.0};
inline const Vec2 goal{22.0, 35.0};

inline std::vector<Vec2> centres() { return {{10, 12}, {20, 20}, {10, 33}, {20, 30}}; }

inline std::vector<Obstacle> obstacles() {
  std::vector<Obstacle> all;
  for (const Vec2& centre : centres()) {
    all.push_back({.kind = Obstacle::Kind::sphere, .position = {centre.x(), centre.y(), 0.0}, .radius = 1.0});
  }
  return all;
}

inline PlanarMap map() { return {obstacles(), inflation_m}; }

/// The waypoints that the paper's RRT* found (Table 7).
inline std::vector<Vec2> published_waypoints() {
  return {{0, 0},      {4.2, 2.4},   {5.3, 6.9},   {2.7, 11.2},  {3, 16}, {6.2, 19.7},
          {9.6, 23.4}, {13.2, 26.8}, {14.6, 31.6}, {17.9, 34.9}, {22, 35}};
}

}  // namespace fairway::four_obstacles
