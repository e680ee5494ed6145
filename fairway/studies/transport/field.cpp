// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/field.hpp"

#include <algorithm>
#include <bitset>

#include "fairway/core/rng.hpp"
#include "fairway/studies/disc.hpp"

namespace fairway::transport {
namespace {

constexpr double edge = 50.0;
constexpr double grid_step = 2.0;  // [s]

Vec3 place_in(Rng& rng, double lo, double hi) {
  const double n = rng.uniform(lo, hi);
  return {n, rng.uniform(lo, hi), 0.0};
}

/// Clear of start and goal, so that neither is blocked from the beginning.
bool leaves_room(const Field& field, const Vec3& at, double radius) {
  const double room = footprint_radius + radius + 2.0;
  return (at - field.start).norm() >= room && (at - field.goal).norm() >= room;
}

void add_discs(Field& field, FieldKind kind, Rng rng) {
  const std::uint64_t count = 8 + rng.index(7);
  while (field.obstacles.size() < count) {
    const double radius = rng.uniform(1.0, 4.0);
    const Vec3 at = place_in(rng, 0.0, edge);
    const bool uncharted = rng.uniform(0.0, 1.0) < 0.5;
    if (!leaves_room(field, at, radius)) continue;
    field.obstacles.push_back(disc(at, radius));
    field.obstacles.back().charted = kind == FieldKind::known || !uncharted;
  }
}

void add_drifters(Field& field, Rng rng) {
  for (int added = 0; added < 3;) {
    const double radius = rng.uniform(0.5, 1.5);
    const Vec3 at = place_in(rng, 0.0, edge);
    const Vec3 aim = place_in(rng, 10.0, 40.0);
    const double speed = rng.uniform(0.05, 0.2);
    if ((at - field.start).norm() < 20.0 || (aim - at).norm() < 1.0) continue;
    field.obstacles.push_back(disc(at, radius, speed * (aim - at).normalized()));
    field.obstacles.back().charted = false;
    ++added;
  }
}

/// What a disc can reach on a grid, step by step in time. A row of cells is a row of bits.
class ReachableSet {
 public:
  /// A disc of `radius` at `start`.
  ReachableSet(std::span<const ObstacleSpec> obstacles, const Vec3& start, double radius)
      : obstacles_{obstacles}, radius_{radius} {
    for (Row& row : free_) row.set();
    for (const ObstacleSpec& obstacle : obstacles_) {
      if (!obstacle.moves()) cover(free_, obstacle.position, obstacle.radius + radius_);
    }
    mark(reached_, start, size);
    for (std::size_t i = 0; i < rows; ++i) reached_[i] &= free_[i];
  }

  void step(double time) {
    Grid next;
    for (std::size_t i = 0; i < rows; ++i) {
      next[i] = reached_[i] | reached_[i] << 1 | reached_[i] >> 1;
      if (i > 0) next[i] |= reached_[i - 1];
      if (i + 1 < rows) next[i] |= reached_[i + 1];
      next[i] &= free_[i];
    }
    for (const ObstacleSpec& obstacle : obstacles_) {
      if (obstacle.moves())
        cover(next, obstacle.position + time * obstacle.velocity, obstacle.radius + radius_);
    }
    reached_ = next;
  }

  bool empty() const {
    return std::ranges::none_of(reached_, [](const Row& row) { return row.any(); });
  }

  bool holds_near(const Vec3& goal, double distance) const {
    Grid near{};
    mark(near, goal, distance);
    for (std::size_t i = 0; i < rows; ++i) {
      if ((near[i] & reached_[i]).any()) return true;
    }
    return false;
  }

 private:
  static constexpr double size = 0.5;       // of a cell [m]
  static constexpr double corner = -10.0;   // of the grid [m]
  static constexpr std::size_t rows = 140;  // 70 m
  using Row = std::bitset<rows>;
  using Grid = std::array<Row, rows>;

  /// Calls `visit(row, column)` for the cells whose centres lie in a disc.
  template <class Visit>
  static void for_disc(const Vec3& at, double radius, const Visit& visit) {
    const auto clamped = [](double cell) {
      return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(rows)));
    };
    const Vec3 low = (at.array() - radius - corner) / size;
    const Vec3 high = (at.array() + radius - corner) / size + 1.0;
    for (std::size_t row = clamped(low.x()); row < clamped(high.x()); ++row) {
      for (std::size_t column = clamped(low.y()); column < clamped(high.y()); ++column) {
        const double n = corner + size * (static_cast<double>(row) + 0.5) - at.x();
        const double e = corner + size * (static_cast<double>(column) + 0.5) - at.y();
        if (n * n + e * e < radius * radius) visit(row, column);
      }
    }
  }

  static void cover(Grid& grid, const Vec3& at, double radius) {
    for_disc(at, radius, [&](std::size_t row, std::size_t column) { grid[row].reset(column); });
  }
  static void mark(Grid& grid, const Vec3& at, double radius) {
    for_disc(at, radius, [&](std::size_t row, std::size_t column) { grid[row].set(column); });
  }

  std::span<const ObstacleSpec> obstacles_;
  double radius_;
  Grid free_{};
  Grid reached_{};
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
  constexpr double arrival = 1.0, room = 0.5;  // [m]
  constexpr int steps = 600;
  ReachableSet set{field.obstacles, field.start, footprint_radius + room};
  for (int i = 1; i <= steps; ++i) {
    set.step(grid_step * i);
    if (set.holds_near(field.goal, arrival)) return true;
  }
  return false;
}

bool can_stay_clear(std::span<const ObstacleSpec> obstacles, const Vec3& from, double time) {
  constexpr double room = 0.1;  // [m]
  constexpr int steps = 60;
  ReachableSet set{obstacles, from, footprint_radius + room};
  for (int i = 1; i <= steps; ++i) set.step(time + grid_step * i);
  return !set.empty();
}

}  // namespace fairway::transport
