// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/core/shapes.hpp"

namespace fairway {

/// The obstacles that no chart shows and that were met so far, up to a number. Owns what it holds, so it
/// outlives the situations in which they were seen, and remembers what has gone out of sight.
class Finds {
 public:
  /// What is seen this near to where it was seen before, point by point, is the same: sensors have noise [m].
  static constexpr double same_place = 0.2;
  /// So many are remembered, those that are nearest when another is met.
  static constexpr std::size_t capacity = 256;

  /// Adds those of `obstacles` that are not charted and not known yet, as seen from `own` [m, NED]; true if
  /// there were any. O(obstacles x finds).
  bool add(std::span<const Obstacle> obstacles, const Vec3& own);

  /// All of them, as charted obstacles; the views are valid until the next add().
  std::vector<Obstacle> charted() const;

  bool empty() const { return found_.empty(); }

 private:
  struct Find {
    Obstacle shape;  // its vertices are those below
    std::vector<Vec3> vertices;

    bool is(const Obstacle& other) const;
    Obstacle seen() const {
      Obstacle whole = shape;
      whole.vertices = vertices;
      return whole;
    }
  };
  /// Forgets what is farthest from `own`, if that is more than `distance` [m]. Whether it was.
  bool forget_farther(double distance, const Vec3& own);

  std::vector<Find> found_;
};

}  // namespace fairway
