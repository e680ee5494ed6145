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
    const auto [west, east] = std::minmax(vertices[i].x(), vertices[next(i)].x());
    edges.push_back({i, west, east});
  }
  std::ranges::sort(edges, {}, &Edge::west);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n && edges[j].west <= edges[i].east; ++j) {
      const auto [a, b] = std::minmax(edges[i].from, edges[j].from);
      const bool are_neighbours = next(a) == b || next(b) == a;
      if (are_neighbours) {  // they share an end; beyond it they meet where one runs back along the other
        const std::size_t shared = next(a) == b ? b : a;
        const std::size_t before = shared == b ? a : b, after = next(shared);
        const Vec3 back = vertices[before] - vertices[shared], on = vertices[after] - vertices[shared];
        if (side_of(vertices[before], vertices[shared], vertices[after]) != 0 ||
            back.head<2>().dot(on.head<2>()) <= 0.0)
          continue;
        return std::pair{a, b};
      }
      if (meet(vertices[a], vertices[next(a)], vertices[b], vertices[next(b)])) return std::pair{a, b};
    }
  }
  return std::nullopt;
}

}  // namespace fairway
