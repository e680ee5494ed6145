// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <vector>

#include "fairway/avoidance/velocity_obstacle/choice.hpp"
#include "fairway/core/angles.hpp"

namespace fairway::velocity_obstacle {

/// The choice of choose() as it is defined, without any thought of what it costs: every velocity that can be
/// the best is tried against all obstacles. O(n^3).
inline ChosenVelocity exhaustive_choice(std::span<const VelocityObstacle> obstacles,
                                        const ReachableSet& reachable, const Wish& wish) {
  struct Line {
    Boundary boundary;
    Vec2 nearest;
    double distance;
    std::size_t order;
  };
  const double fastest = std::min(reachable.max_speed(), reachable.middle().norm() + reachable.max_change());
  const double scale =
      std::min(2.0 * std::max({wish.velocity.norm(), reachable.middle().norm(), 0.5}), fastest);
  const double slack = 1e-9 * scale;

  std::vector<Boundary> boundaries, rim(ReachableSet::max_boundaries);
  for (const VelocityObstacle& obstacle : obstacles) {
    std::array<Boundary, VelocityObstacle::max_boundaries> own;
    boundaries.insert(boundaries.end(), own.begin(), own.begin() + obstacle.boundaries(own));
  }
  rim.resize(reachable.boundaries(std::span<Boundary, ReachableSet::max_boundaries>{rim}));
  boundaries.insert(boundaries.end(), rim.begin(), rim.end());
  boundaries.push_back(Boundary::line(Vec2::Zero(), wish.ahead));
  std::vector<Line> lines;
  for (const Boundary& boundary : boundaries) {
    const Vec2 v = nearest(boundary, wish.velocity);
    lines.push_back({boundary, v, (v - wish.velocity).norm(), lines.size()});
  }
  std::ranges::sort(lines, {}, [](const Line& line) { return std::tie(line.distance, line.order); });

  ChosenVelocity best{Vec2::Zero(), true};
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](const Vec2& v, double cost) {
    const auto rank = [&](const Vec2& u) { return std::pair{cross(wish.ahead, u), wish.ahead.dot(u)}; };
    if (cost > least || (cost == least && !(rank(v) > rank(best.velocity)))) return;
    best.velocity = v;
    least = cost;
  };

  // what is clear
  std::vector<Vec2> clear{wish.velocity};
  const std::array<Vec2, 2> rest{reachable.middle(), Vec2::Zero()};
  clear.insert(clear.end(), rest.begin(), rest.end());
  for (const Line& line : lines) clear.push_back(line.nearest);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const Vec2& v : crossings(lines[i].boundary, lines[j].boundary)) clear.push_back(v);
    }
  }
  for (const Vec2& v : clear) {
    const bool is_clear = std::ranges::none_of(
        obstacles, [&](const VelocityObstacle& obstacle) { return obstacle.depth(v) > slack; });
    if (is_clear && reachable.contains(v, slack)) take(v, wish.cost(v));
  }
  if (least < std::numeric_limits<double>::infinity()) return best;

  // what is the least bad
  best.is_feasible = false;
  std::vector<Vec2> samples(rest.begin(), rest.end());
  const double reach =
      std::min(reachable.max_change(), limit_or(reachable.max_speed(), scale) + reachable.middle().norm());
  for (int spoke = 0; spoke < 32; ++spoke) {
    const Vec2 out = reach * fairway::turned(reachable.bow(), 2.0 * pi * spoke / 32);
    for (int ring = 1; ring <= 8; ++ring) samples.emplace_back(reachable.middle() + ring * out / 8);
  }
  for (const Line& line : lines) {
    samples.push_back(line.nearest);
    for (const Boundary& end : rim) {
      for (const Vec2& v : crossings(line.boundary, end)) samples.push_back(v);
    }
  }
  for (const Vec2& v : samples) {
    if (!reachable.contains(v, slack)) continue;
    double urgency = 0.0;
    for (const VelocityObstacle& obstacle : obstacles) {
      if (obstacle.depth(v) > slack) urgency = std::max(urgency, obstacle.urgency(v));
    }
    take(v, wish.cost(v) + wish.collision_weight * urgency);
  }
  return best;
}

}  // namespace fairway::velocity_obstacle
