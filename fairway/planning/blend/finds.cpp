// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/blend/finds.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

bool Finds::Find::is(const Obstacle& other) const {
  const auto is_at = [](const Vec3& a, const Vec3& b) { return (a - b).norm() <= same_place; };
  return shape.kind == other.kind && is_at(shape.position, other.position) &&
         std::abs(shape.radius - other.radius) <= same_place && is_at(shape.from, other.from) &&
         is_at(shape.to, other.to) && std::ranges::equal(vertices, other.vertices, is_at);
}

bool Finds::add(std::span<const Obstacle> obstacles, const Vec3& own) {
  bool any = false;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.charted) continue;
    if (std::ranges::any_of(found_, [&](const Find& find) { return find.is(obstacle); })) continue;
    if (found_.size() == capacity && !forget_farther(nearest_point(obstacle, own).distance, own)) continue;
    found_.push_back({obstacle, {obstacle.vertices.begin(), obstacle.vertices.end()}});
    any = true;
  }
  return any;
}

bool Finds::forget_farther(double distance, const Vec3& own) {
  const auto distance_of = [&](const Find& find) { return nearest_point(find.seen(), own).distance; };
  const auto farthest = std::ranges::max_element(found_, {}, distance_of);
  if (!(distance < distance_of(*farthest))) return false;
  found_.erase(farthest);
  return true;
}

std::vector<Obstacle> Finds::charted() const {
  std::vector<Obstacle> all;
  for (const Find& find : found_) {
    all.push_back(find.seen());
    all.back().charted = true;
  }
  return all;
}

}  // namespace fairway
