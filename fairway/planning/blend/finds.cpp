// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/blend/finds.hpp"

#include <algorithm>

namespace fairway {

bool Finds::Find::is(const Obstacle& other) const {
  return shape.kind == other.kind && shape.position == other.position && shape.radius == other.radius &&
         shape.from == other.from && shape.to == other.to && std::ranges::equal(vertices, other.vertices);
}

bool Finds::add(std::span<const Obstacle> obstacles) {
  bool any = false;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.charted) continue;
    if (std::ranges::any_of(found_, [&](const Find& find) { return find.is(obstacle); })) continue;
    found_.push_back({obstacle, {obstacle.vertices.begin(), obstacle.vertices.end()}});
    any = true;
  }
  return any;
}

std::vector<Obstacle> Finds::charted() const {
  std::vector<Obstacle> all;
  for (const Find& find : found_) {
    all.push_back(find.shape);
    all.back().vertices = find.vertices;
    all.back().charted = true;
  }
  return all;
}

}  // namespace fairway
