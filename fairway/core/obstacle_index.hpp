// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fairway/core/shapes.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// Which obstacles are near, of those that stand still: a tree of boxes, each half as many obstacles as the
/// one round it (Kay and Kajiya, SIGGRAPH 1986: a hierarchy of bounding volumes), so that whoever looks round
/// passes over what is far away a box at a time. Long shapes have long boxes, and polygons reach through
/// every depth. It finds exactly what going through all of them finds: boxes are a little larger than what is
/// in them, by more than all that is rounded, and decide about the cost alone. A value, made once.
class ObstacleIndex {
 public:
  /// So few are gone through one by one as fast.
  static constexpr std::size_t handful = 16;

  ObstacleIndex() = default;

  /// Takes the obstacles that `obstacle_of(i)` points to, i from 0 to `count` - 1; where it is null there is
  /// none. One without a shape is near everywhere. O(count log count).
  template <class ObstacleOf>
  ObstacleIndex(std::size_t count, const ObstacleOf& obstacle_of) {
    std::vector<Item> items;
    items.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (const Obstacle* obstacle = obstacle_of(i))
        items.push_back({box_of(*obstacle), middle_of(*obstacle), static_cast<std::uint32_t>(i)});
    }
    build(items);
  }

  /// Calls `visit(i)` for each obstacle whose surface may be within `reach` of `place` [m], and for others,
  /// in no order. `visit` returns how far to look from then on [m]. What `place` is inside of is always
  /// visited. Does not allocate.
  template <class Visit>
  void visit(const Vec3& place, double reach, const Visit& visit) const {
    double reach2 = square_of(reach);
    for (std::size_t k = 0; k < nodes_.size();) {
      const Node& node = nodes_[k];
      if (distance2(node.box, place) > reach2) {
        k = node.next;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.end; ++i)
        reach2 = square_of(visit(std::size_t{indices_[i]}));
      ++k;
    }
  }

  std::size_t size() const { return indices_.size(); }

 private:
  static constexpr std::size_t most_in_a_leaf = 4;

  struct Box {
    Vec3 low;   // [m, NED]
    Vec3 high;  // likewise
  };
  struct Item {
    Box box;
    Vec3 middle;
    std::uint32_t index;
  };
  /// In the order in which a box is looked into: it, what is in its first half, what is in its second.
  struct Node {
    Box box;
    std::uint32_t next;        // the first node that is not in it
    std::uint32_t first, end;  // of its own, among the indices; none unless it is a leaf
  };

  static Box box_of(const Obstacle& obstacle);
  static Vec3 middle_of(const Obstacle& obstacle);

  /// Of a little more than `reach`, whose rounding this covers; of nothing where it is negative.
  static double square_of(double reach) {
    const double more = (1.0 + 1e-9) * std::max(reach, 0.0);
    return more * more;
  }

  static double distance2(const Box& box, const Vec3& place) {
    return (box.low - place).cwiseMax(place - box.high).cwiseMax(0.0).squaredNorm();
  }

  void build(std::span<Item> items);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> indices_;  // leaf by leaf
};

}  // namespace fairway
