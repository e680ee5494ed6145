// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/core/obstacle_index.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// A sphere that drifts at a constant velocity, as it is at one instant.
struct Drifter {
  std::uint32_t number{};        ///< its place among the scenario's obstacles
  Vec3 position = Vec3::Zero();  ///< [m, NED]
  Vec3 velocity = Vec3::Zero();  ///< [m/s, NED]
  double radius{};               ///< [m]
};

/// Where those are that stay, by their indices: the charted ones and the others, of which less is known.
struct FixedIndexes {
  ObstacleIndex charted;
  ObstacleIndex uncharted;
};

/// What is solid in a scenario: what stays, and what drifts. Neither reacts to anyone.
class ObstacleField {
 public:
  explicit ObstacleField(std::vector<ObstacleSpec> specs);

  // the views point into the specs
  ObstacleField(const ObstacleField& other) : ObstacleField{other.specs_} {}
  ObstacleField(ObstacleField&&) noexcept = default;
  ObstacleField& operator=(ObstacleField other) noexcept;
  ~ObstacleField() = default;

  /// Moves the drifters to where they are at `time` [s].
  void move_to(double time) noexcept;

  std::span<const Obstacle> fixed() const { return fixed_; }
  /// Of `fixed()`; null where these are so few that they are gone through one by one.
  const FixedIndexes* indexes() const { return fixed_.size() > ObstacleIndex::handful ? &indexes_ : nullptr; }
  std::span<const Drifter> drifters() const { return drifters_; }

 private:
  std::vector<ObstacleSpec> specs_;
  std::vector<Obstacle> fixed_;
  FixedIndexes indexes_;  // empty where there are few
  std::vector<Drifter> drifters_;
};

}  // namespace fairway
