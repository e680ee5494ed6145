// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/field.hpp"

#include <algorithm>

#include "fairway/core/rng.hpp"

namespace fairway::transport {
namespace {

constexpr double edge = 50.0;

Vec3 place_in(Rng& rng, double lo, double hi) {
  const double n = rng.uniform(lo, hi);
  return {n, rng.uniform(lo, hi), 0.0};
}

/// Clear of start and goal, so that neither is blocked from the beginning.
bool leaves_room(const Field& field, const Vec3& at, double radius) {
  const double room = footprint_radius + radius + 2.0;
  return (at - field.start).norm() >= room && (at - field.goal).norm() >= room;
}

ObstacleSpec sphere(const Vec3& at, double radius) {
  ObstacleSpec spec{.kind = Obstacle::Kind::sphere};
  spec.position = at;
  spec.radius = radius;
  return spec;
}

void add_discs(Field& field, FieldKind kind, Rng rng) {
  const std::uint64_t count = 6 + rng.index(5);
  while (field.obstacles.size() < count) {
    const double radius = rng.uniform(1.0, 4.0);
    const Vec3 at = place_in(rng, 0.0, edge);
    const bool uncharted = rng.uniform(0.0, 1.0) < 0.5;
    if (!leaves_room(field, at, radius)) continue;
    ObstacleSpec disc = sphere(at, radius);
    disc.charted = kind == FieldKind::known || !uncharted;
    field.obstacles.push_back(disc);
  }
}

void add_drifters(Field& field, Rng rng) {
  for (int added = 0; added < 3;) {
    const double radius = rng.uniform(0.5, 1.5);
    const Vec3 at = place_in(rng, 0.0, edge);
    const Vec3 aim = place_in(rng, 10.0, 40.0);
    const double speed = rng.uniform(0.05, 0.2);
    if ((at - field.start).norm() < 20.0 || (aim - at).norm() < 1.0) continue;
    ObstacleSpec drifter = sphere(at, radius);
    drifter.charted = false;
    drifter.velocity = speed * (aim - at).normalized();
    field.obstacles.push_back(drifter);
    ++added;
  }
}

/// What a disc can reach on a grid, step by step in time.
class ReachableSet {
 public:
  explicit ReachableSet(const Field& field) : free_(cells, 1), reached_(cells, 0), next_(cells, 0) {
    for (const ObstacleSpec& obstacle : field.obstacles) {
      if (!obstacle.moves()) cover(free_, obstacle.position, obstacle.radius + inflation);
    }
    const auto [row, column] = cell_of(field.start);
    reached_[index(row, column)] = free_[index(row, column)];
  }

  void step(const Field& field, double time) {
    for (int row = 1; row + 1 < rows; ++row) {
      for (int column = 1; column + 1 < rows; ++column) {
        const std::size_t i = index(row, column);
        const int near =
            reached_[i] | reached_[i - 1] | reached_[i + 1] | reached_[i - rows] | reached_[i + rows];
        next_[i] = static_cast<unsigned char>(near & free_[i]);
      }
    }
    for (const ObstacleSpec& obstacle : field.obstacles) {
      if (obstacle.moves())
        cover(next_, obstacle.position + time * obstacle.velocity, obstacle.radius + inflation);
    }
    std::swap(reached_, next_);
  }

  bool holds_near(const Vec3& goal, double distance) const {
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < rows; ++column) {
        if (reached_[index(row, column)] != 0 && (centre(row, column) - goal).norm() <= distance) return true;
      }
    }
    return false;
  }

 private:
  static constexpr double size = 0.5;      // of a cell [m]
  static constexpr double corner = -10.0;  // of the grid [m]
  static constexpr int rows = 140;         // 70 m
  static constexpr std::size_t cells = std::size_t{rows} * rows;
  static constexpr double inflation = footprint_radius + 0.5;

  static std::size_t index(int row, int column) { return static_cast<std::size_t>(row * rows + column); }
  static Vec3 centre(int row, int column) {
    return {corner + size * (row + 0.5), corner + size * (column + 0.5), 0.0};
  }
  static std::pair<int, int> cell_of(const Vec3& p) {
    return {static_cast<int>((p.x() - corner) / size), static_cast<int>((p.y() - corner) / size)};
  }

  /// Takes the cells of a disc out.
  static void cover(std::vector<unsigned char>& set, const Vec3& at, double radius) {
    const auto [low_row, low_column] = cell_of(at - Vec3{radius, radius, 0.0});
    const auto [high_row, high_column] = cell_of(at + Vec3{radius, radius, 0.0});
    for (int row = std::max(0, low_row); row <= std::min(rows - 1, high_row); ++row) {
      for (int column = std::max(0, low_column); column <= std::min(rows - 1, high_column); ++column) {
        if (horizontal_norm(centre(row, column) - at) < radius) set[index(row, column)] = 0;
      }
    }
  }

  std::vector<unsigned char> free_, reached_, next_;
};

}  // namespace

std::string_view name_of(FieldKind kind) {
  constexpr std::array names{"field_known", "field_unknown", "field_moving"};
  return names[static_cast<std::size_t>(kind)];
}

Field random_field(FieldKind kind, std::uint64_t seed) {
  const Rng rng = Rng{seed}.stream("transport field");
  Field field;
  add_discs(field, kind, rng.stream("discs"));
  if (kind == FieldKind::moving) add_drifters(field, rng.stream("drifters"));
  return field;
}

bool has_escape(const Field& field) {
  constexpr double step = 2.0, patience = 1200.0, arrival = 1.0;  // [s, s, m]
  ReachableSet set{field};
  for (double time = step; time <= patience; time += step) {
    set.step(field, time);
    if (set.holds_near(field.goal, arrival)) return true;
  }
  return false;
}

}  // namespace fairway::transport
