// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/obstacle_index.hpp"

#include <limits>

namespace fairway {

ObstacleIndex::Box ObstacleIndex::box_of(const Obstacle& obstacle) {
  const Vec3 endless = Vec3::Constant(std::numeric_limits<double>::infinity());
  if (!has_shape(obstacle)) return {-endless, endless};
  Box box{endless, -endless};
  const auto include = [&](const Vec3& p) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  };
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      include(obstacle.position - Vec3::Constant(obstacle.radius));
      include(obstacle.position + Vec3::Constant(obstacle.radius));
      break;
    case Obstacle::Kind::segment:
      include(obstacle.from);
      include(obstacle.to);
      break;
    case Obstacle::Kind::polygon:
      for (const Vec3& vertex : obstacle.vertices) include(vertex);
      box.low.z() = -endless.z();
      box.high.z() = endless.z();
      break;
  }
  // distances are rounded to some 1e-16 of the coordinates that they are found from
  const Vec3 little = 1e-12 * box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs());
  return {box.low - little, box.high + little};
}

Vec3 ObstacleIndex::middle_of(const Obstacle& obstacle) {
  const Vec3 middle = centre_of(obstacle);
  return is_finite(middle) ? middle : Vec3::Zero();
}

void ObstacleIndex::build(std::span<Item> items) {
  if (items.empty()) return;
  Box hull = items.front().box;
  Vec3 low = items.front().middle, high = low;
  for (const Item& item : items) {
    hull = {hull.low.cwiseMin(item.box.low), hull.high.cwiseMax(item.box.high)};
    low = low.cwiseMin(item.middle);
    high = high.cwiseMax(item.middle);
  }
  const std::size_t here = nodes_.size();
  const auto first = static_cast<std::uint32_t>(indices_.size());
  nodes_.push_back({hull, 0, first, first});
  if (items.size() <= most_in_a_leaf) {
    for (const Item& item : items) indices_.push_back(item.index);
    nodes_[here].end = static_cast<std::uint32_t>(indices_.size());
  } else {
    // in halves along the axis on which their middles are farthest apart
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const std::size_t half = items.size() / 2;
    std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [&](const Item& item) { return item.middle[axis]; });
    build(items.first(half));
    build(items.subspan(half));
  }
  nodes_[here].next = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace fairway
