// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "fairway/core/angles.hpp"
#include "fairway/planning/planar_map.hpp"

/// The exact shortest path among discs of one radius, to judge planners by: it runs along straight lines
/// tangent to discs and along their rims, so it is found by Dijkstra's algorithm over the tangent points. The
/// discs may overlap. Independent of PlanarMap's geometry and of sampling. O(n^3) tangents against discs.
namespace fairway::tangent_graph {

class Graph {
 public:
  Graph(const Vec2& start, const Vec2& goal, std::span<const Vec2> centres, double radius)
      : centres_{centres.begin(), centres.end()}, radius_{radius} {
    nodes_ = {{start, -1, 0.0}, {goal, -1, 0.0}};
    link(0, 1);
    for (int disc = 0; disc < count(); ++disc) {
      add_tangents_from_points(disc);
      for (int other = 0; other < disc; ++other) add_tangents_between(other, disc);
    }
    for (int disc = 0; disc < count(); ++disc) link_along_rim(disc);
  }

  /// Length from start to goal; infinite if there is no way.
  double shortest() const {
    std::vector<double> length(nodes_.size(), std::numeric_limits<double>::infinity());
    std::vector<bool> is_done(nodes_.size(), false);
    length[0] = 0.0;
    for (std::size_t round = 0; round < nodes_.size(); ++round) {
      std::size_t next = nodes_.size();
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (!is_done[i] && (next == nodes_.size() || length[i] < length[next])) next = i;
      }
      is_done[next] = true;
      for (const Edge& edge : edges_) {
        if (edge.from != next && edge.to != next) continue;
        const std::size_t to = edge.from == next ? edge.to : edge.from;
        length[to] = std::fmin(length[to], length[next] + edge.length);
      }
    }
    return length[1];
  }

 private:
  struct Node {
    Vec2 point;
    int disc;      // on whose rim; -1 of start and goal
    double angle;  // there [rad], 0 .. 2 pi
  };
  struct Edge {
    std::size_t from, to;
    double length;
  };

  static constexpr double touch_m = 1e-9;  // a tangent touches its own discs

  int count() const { return static_cast<int>(centres_.size()); }
  const Vec2& centre(int disc) const { return centres_[static_cast<std::size_t>(disc)]; }

  std::size_t add_node(int disc, double angle) {
    angle = std::fmod(std::fmod(angle, 2.0 * pi) + 2.0 * pi, 2.0 * pi);
    nodes_.push_back({centre(disc) + radius_ * Vec2{std::cos(angle), std::sin(angle)}, disc, angle});
    return nodes_.size() - 1;
  }

  /// A straight edge, if no disc is in its way.
  void link(std::size_t from, std::size_t to) {
    const Vec2 a = nodes_[from].point, ab = nodes_[to].point - a;
    for (const Vec2& centre : centres_) {
      const double t = std::clamp((centre - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
      if ((a + t * ab - centre).norm() < radius_ - touch_m) return;
    }
    edges_.push_back({from, to, ab.norm()});
  }

  void add_tangents_from_points(int disc) {
    for (const std::size_t point : {std::size_t{0}, std::size_t{1}}) {
      const Vec2 out = nodes_[point].point - centre(disc);
      const double half = std::acos(std::fmin(1.0, radius_ / out.norm()));
      const double bearing = std::atan2(out.y(), out.x());
      link(point, add_node(disc, bearing + half));
      link(point, add_node(disc, bearing - half));
    }
  }

  void add_tangents_between(int one, int two) {
    const Vec2 apart = centre(two) - centre(one);
    const double bearing = std::atan2(apart.y(), apart.x());
    for (const double side : {-1.0, 1.0}) {
      link(add_node(one, bearing + side * pi / 2), add_node(two, bearing + side * pi / 2));
      if (apart.norm() <= 2.0 * radius_) continue;
      const double half = std::acos(2.0 * radius_ / apart.norm());
      link(add_node(one, bearing + side * half), add_node(two, bearing + pi + side * half));
    }
  }

  /// True if the rim of `disc` between the angles, `to` beyond `from`, is outside of every other disc.
  bool is_open(int disc, double from, double to) const {
    for (int other = 0; other < count(); ++other) {
      const Vec2 apart = centre(other) - centre(disc);
      if (other == disc || apart.norm() >= 2.0 * radius_) continue;
      const double half = std::acos(apart.norm() / (2.0 * radius_));
      const double middle = std::atan2(apart.y(), apart.x());
      for (int turn = -1; turn <= 2; ++turn) {
        const double begin = middle - half + 2.0 * pi * turn, end = middle + half + 2.0 * pi * turn;
        if (begin < to - touch_m && end > from + touch_m) return false;
      }
    }
    return true;
  }

  void link_along_rim(int disc) {
    std::vector<std::size_t> around;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].disc == disc) around.push_back(i);
    }
    std::ranges::sort(around, {}, [&](std::size_t i) { return std::pair{nodes_[i].angle, i}; });
    for (std::size_t i = 0; i < around.size(); ++i) {
      const std::size_t next = around[(i + 1) % around.size()];
      const double from = nodes_[around[i]].angle;
      const double to = nodes_[next].angle + (i + 1 == around.size() ? 2.0 * pi : 0.0);
      if (is_open(disc, from, to)) edges_.push_back({around[i], next, radius_ * (to - from)});
    }
  }

  std::vector<Vec2> centres_;
  double radius_;
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
};

inline double shortest_path(const Vec2& start, const Vec2& goal, std::span<const Vec2> centres,
                            double radius) {
  return Graph{start, goal, centres, radius}.shortest();
}

}  // namespace fairway::tangent_graph
