// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/polygon.hpp"

#include <algorithm>
#include <vector>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// On which side of the line from a to b the point c lies: 1, -1, or 0 on it.
int side_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  return area > 0.0 ? 1 : area < 0.0 ? -1 : 0;
}

bool lies_between(const Vec3& a, const Vec3& b, const Vec3& c) {
  return math::fmin(a.x(), b.x()) <= c.x() && c.x() <= math::fmax(a.x(), b.x()) &&
         math::fmin(a.y(), b.y()) <= c.y() && c.y() <= math::fmax(a.y(), b.y());
}

/// Whether the segments from a to b and from c to d have a point in common, as seen from above.
bool meet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const int at_c = side_of(a, b, c), at_d = side_of(a, b, d);
  const int at_a = side_of(c, d, a), at_b = side_of(c, d, b);
  if (at_c != at_d && at_a != at_b) return true;
  return (at_c == 0 && lies_between(a, b, c)) || (at_d == 0 && lies_between(a, b, d)) ||
         (at_a == 0 && lies_between(c, d, a)) || (at_b == 0 && lies_between(c, d, b));
}

/// Whether the way from a to b goes back along itself to c.
bool runs_back(const Vec3& a, const Vec3& b, const Vec3& c) {
  return side_of(a, b, c) == 0 && (a - b).head<2>().dot((c - b).head<2>()) > 0.0;
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(std::span<const Vec3> vertices) {
  const std::size_t n = vertices.size();
  const auto next = [n](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  struct Edge {
    std::size_t from;
    double west, east;  // its least and greatest x
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < n; ++i) {
    const double here = vertices[i].x(), there = vertices[next(i)].x();
    edges.push_back({i, math::fmin(here, there), math::fmax(here, there)});
  }
  std::ranges::sort(edges, {}, &Edge::west);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n && edges[j].west <= edges[i].east; ++j) {
      const std::size_t a = std::min(edges[i].from, edges[j].from);
      const std::size_t b = std::max(edges[i].from, edges[j].from);
      if (next(a) == b || next(b) == a) {  // they share an end
        const std::size_t shared = next(a) == b ? b : a, before = shared == b ? a : b;
        if (runs_back(vertices[before], vertices[shared], vertices[next(shared)])) return std::pair{a, b};
        continue;
      }
      if (meet(vertices[a], vertices[next(a)], vertices[b], vertices[next(b)])) return std::pair{a, b};
    }
  }
  return std::nullopt;
}

}  // namespace fairway
