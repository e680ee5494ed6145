// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/taut_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway {
namespace {

/// The waypoints and enough points between them that no two are farther apart than `spacing`.
std::vector<Vec2> densified(std::span<const Vec2> path, double spacing) {
  std::vector<Vec2> points{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2& from = path[i - 1];
    const Vec2& to = path[i];
    const int parts = std::max(1, static_cast<int>(std::ceil((to - from).norm() / spacing)));
    for (int k = 1; k < parts; ++k) points.push_back(from + (static_cast<double>(k) / parts) * (to - from));
    points.push_back(to);
  }
  return points;
}

/// The shortest way from the first to the last of `points` along lines of sight that only go forward. Each of
/// them costs `leg_price` [m] besides its length, so that one is preferred to several in line.
std::vector<Vec2> shortest_in_sight(std::span<const Vec2> points, double leg_price, const PlanarMap& map) {
  std::vector<double> length(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(points.size(), 0);
  length[0] = 0.0;
  for (std::size_t to = 1; to < points.size(); ++to) {
    // its neighbour is in sight by the path itself
    before[to] = to - 1;
    length[to] = length[to - 1] + (points[to] - points[to - 1]).norm() + leg_price;
    for (std::size_t from = 0; from + 1 < to; ++from) {
      const double candidate = length[from] + (points[to] - points[from]).norm() + leg_price;
      if (candidate < length[to] && map.is_free(points[from], points[to])) {
        length[to] = candidate;
        before[to] = from;
      }
    }
  }

  std::vector<Vec2> way;
  for (std::size_t i = points.size() - 1; i != 0; i = before[i]) way.push_back(points[i]);
  way.push_back(points.front());
  std::ranges::reverse(way);
  return way;
}

}  // namespace

std::vector<Vec2> taut_path(std::span<const Vec2> path, const PlanarMap& map) {
  constexpr int points_count = 100;
  constexpr int most_rounds = 20;
  std::vector<Vec2> best{path.begin(), path.end()};
  for (int round = 0; round < most_rounds && best.size() > 2; ++round) {
    const double length = length_of(best);
    if (length == 0.0) break;
    const std::vector<Vec2> shorter =
        shortest_in_sight(densified(best, length / points_count), 1e-9 * length, map);
    const double gain = length - length_of(shorter);
    if (gain > 0.0 || shorter.size() < best.size()) best = shorter;
    if (gain < 1e-4 * length) break;
  }
  return best;
}

}  // namespace fairway
