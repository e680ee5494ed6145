// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca2d/shore.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "fairway/avoidance/orca2d/cone.hpp"
#include "fairway/core/math.hpp"

namespace fairway::orca2d {
namespace {

auto rank_of(const Landmark& a) { return std::tuple{a.distance, a.obstacle, a.edge}; }

bool is_nearer(const Landmark& a, const Landmark& b) { return rank_of(a) < rank_of(b); }

/// Vertices that run clockwise, though they should not, are read backwards: a polygon is solid.
bool is_clockwise(std::span<const Vec3> vertices) {
  const Vec2 first = vertices.front().head<2>();
  double area = 0.0;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
    area += cross(vertices[i].head<2>() - first, vertices[i + 1].head<2>() - first);
  return area < 0.0;
}

/// A closed line of vertices, of which some may be in one place, relative to own ship.
class Outline {
 public:
  Outline(std::span<const Vec3> vertices, bool is_reversed, const Vec2& position)
      : vertices_{vertices}, is_reversed_{is_reversed}, position_{position} {}

  std::size_t size() const { return vertices_.size(); }
  std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }
  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : size() - 1; }
  Vec2 at(std::size_t i) const { return charted(i) - position_; }

  /// Unit, from vertex `i` along the edge that ends there, backwards; zero if all are in one place.
  Vec2 backwards(std::size_t i) const { return towards(i, &Outline::before); }
  /// Unit, from vertex `i` along the edge that begins there.
  Vec2 forwards(std::size_t i) const { return towards(i, &Outline::after); }

  /// True where the solid has less than half a turn.
  bool is_convex(std::size_t i) const { return cross(forwards(i), backwards(i)) >= 0.0; }

 private:
  Vec2 charted(std::size_t i) const { return vertices_[is_reversed_ ? size() - 1 - i : i].head<2>(); }

  Vec2 towards(std::size_t i, std::size_t (Outline::*next)(std::size_t) const) const {
    const Vec2 here = charted(i);
    for (std::size_t j = (this->*next)(i); j != i; j = (this->*next)(j)) {
      const Vec2 way = charted(j) - here;
      const double length = way.norm();
      if (length > 0.0) return way / length;
    }
    return Vec2::Zero();
  }

  std::span<const Vec3> vertices_;
  bool is_reversed_;
  Vec2 position_;
};

/// How far own ship is from the edge that begins at a vertex, and where it is nearest.
struct Bearing {
  double distance2;
  int end;        ///< -1 at its beginning, 1 at its end, 0 between
  double inside;  ///< positive if own ship is on the side of the solid
};

Bearing bearing_of(const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double reached = -from.dot(along);
  const double length2 = along.squaredNorm();
  const double inside = -cross(along, from);
  if (reached < 0.0) return {from.squaredNorm(), -1, inside};
  if (reached > length2) return {to.squaredNorm(), 1, inside};
  return {length2 > 0.0 ? inside * inside / length2 : from.squaredNorm(), 0, inside};
}

}  // namespace

Shore::Shore(std::span<const Obstacle> obstacles, const Sight& sight) noexcept {
  for (std::uint32_t i = 0; i < obstacles.size(); ++i) {
    const Obstacle& obstacle = obstacles[i];
    if (obstacle.kind == Obstacle::Kind::sphere) {
      const double centre = (obstacle.position.head<2>() - sight.position).norm();
      const double distance = centre - obstacle.radius;
      if (distance <= sight.disc_range) add({math::fmax(0.0, distance), i, 0, Landmark::Kind::disc, false});
    } else if (obstacle.kind == Obstacle::Kind::segment) {
      const Vec2 from = obstacle.from.head<2>() - sight.position;
      const double distance = std::sqrt(bearing_of(from, obstacle.to.head<2>() - sight.position).distance2);
      if (distance <= sight.wall_range) add({distance, i, 0, Landmark::Kind::wall, false});
    } else if (!obstacle.vertices.empty()) {
      add_polygon(obstacle.vertices, i, sight);
    }
  }
  std::sort(landmarks_.begin(), landmarks_.begin() + static_cast<std::ptrdiff_t>(count_), is_nearer);
}

void Shore::add_polygon(std::span<const Vec3> vertices, std::uint32_t index, const Sight& sight) {
  const bool is_reversed = is_clockwise(vertices);
  const Outline outline{vertices, is_reversed, sight.position};
  const auto each_edge = [&](const auto& see) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 from = outline.at(i);
      const Vec2 to = outline.at(outline.after(i));
      if (from != to) see(i, bearing_of(from, to));
    }
  };

  // the nearest edge tells whether own ship is inside
  std::size_t nearest = 0;
  Bearing to_nearest{.distance2 = std::numeric_limits<double>::infinity()};
  each_edge([&](std::size_t i, const Bearing& bearing) {
    if (bearing.distance2 >= to_nearest.distance2) return;
    nearest = i;
    to_nearest = bearing;
  });
  const auto landmark = [&](std::size_t edge, double distance, Landmark::Kind kind) {
    if (distance <= sight.wall_range)
      add({distance, index, static_cast<std::uint32_t>(edge), kind, is_reversed});
  };
  if (to_nearest.distance2 == std::numeric_limits<double>::infinity()) {
    landmark(0, outline.at(0).norm(), Landmark::Kind::wall);
    return;
  }
  const bool is_inside = to_nearest.end == 0
                             ? to_nearest.inside > 0.0
                             : !outline.is_convex(to_nearest.end < 0 ? nearest : outline.after(nearest));
  if (is_inside) {
    landmark(nearest, 0.0, Landmark::Kind::wall_from_inside);
    return;
  }
  each_edge([&](std::size_t i, const Bearing& bearing) {
    if (bearing.inside <= 0.0) landmark(i, std::sqrt(bearing.distance2), Landmark::Kind::wall);
  });
}

void Shore::add(const Landmark& landmark) {
  const auto begin = landmarks_.begin();
  if (count_ < max_landmarks) {
    landmarks_[count_++] = landmark;
    if (count_ == max_landmarks) std::make_heap(begin, landmarks_.end(), is_nearer);
  } else if (is_nearer(landmark, landmarks_.front())) {
    std::pop_heap(begin, landmarks_.end(), is_nearer);
    landmarks_.back() = landmark;
    std::push_heap(begin, landmarks_.end(), is_nearer);
  }
}

Wall wall_at(const Obstacle& obstacle, const Landmark& landmark, const Vec2& position) noexcept {
  if (obstacle.kind == Obstacle::Kind::segment) {
    const WallEnd from{obstacle.from.head<2>() - position};
    const WallEnd to{obstacle.to.head<2>() - position};
    return bearing_of(from.p, to.p).inside > 0.0 ? Wall{to, from} : Wall{from, to};
  }
  const Outline outline{obstacle.vertices, landmark.is_reversed, position};
  const std::size_t edge = landmark.edge;
  const std::size_t next = outline.after(edge);
  return {{outline.at(edge), outline.is_convex(edge), outline.backwards(edge)},
          {outline.at(next), outline.is_convex(next), outline.forwards(next)}};
}

}  // namespace fairway::orca2d
