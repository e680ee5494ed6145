// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/core/shapes.hpp"

namespace fairway {

/// The obstacles that no chart shows and that were met so far. Owns what it holds, so it outlives the
/// situations in which they were seen, and remembers what has gone out of sight.
class Finds {
 public:
  /// Adds those of `obstacles` that are not charted and not known yet; true if there were any.
  /// O(obstacles x finds).
  bool add(std::span<const Obstacle> obstacles);

  /// All of them, as charted obstacles; the views are valid until the next add().
  std::vector<Obstacle> charted() const;

  bool empty() const { return found_.empty(); }

 private:
  struct Find {
    Obstacle shape;  // its vertices are those below
    std::vector<Vec3> vertices;

    bool is(const Obstacle& other) const;
  };
  std::vector<Find> found_;
};

}  // namespace fairway
