// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/avoidance/avoa/distance_transform.hpp"
#include "fairway/avoidance/avoa/kinematic_zone.hpp"
#include "fairway/avoidance/avoa/protective_zones.hpp"
#include "fairway/avoidance/avoa/velocity_metric.hpp"

namespace fairway::avoa {

/// All that is known of the velocities of one decision: which are in a protective zone, which own ship can
/// make, how near the others are to danger. What depends on own ship alone, speed and heading of each cell
/// among it, is kept from one decision to the next. Allocates only when the grid grows.
class VelocitySpace {
 public:
  /// The cells' speeds and headings and, apart from them, the kinematic zone, unless they are as they were;
  /// slower than `least_speed` is not feasible either. Forgets all obstacles. O(cells)
  void begin(const VelocityGrid& grid, const KinematicZone& kinematics, double least_speed);

  /// To be filled between begin() and finish().
  ProtectiveZones& zones() { return zones_; }
  const ProtectiveZones& zones() const { return zones_; }

  /// The feasible set F and the distances to the zones. Danger begins `threshold` from a zone [m/s]. O(cells)
  void finish(double threshold);

  const VelocityGrid& grid() const { return zones_.grid(); }
  const KinematicZone& kinematics() const { return kinematics_; }

  /// The cells of F, ascending.
  std::span<const std::int32_t> feasible() const { return {feasible_.data(), feasible_count_}; }
  bool is_feasible(int cell) const { return is_feasible_[static_cast<std::size_t>(cell)] != 0; }
  /// Speed and heading of a cell.
  const PolarVelocity& velocity(int cell) const { return velocities_[static_cast<std::size_t>(cell)]; }

  /// The danger of a cell, in [0, 1].
  double danger(int cell) const {
    const std::int32_t squared = distance_.squared(cell, safe_squared_);
    if (squared >= safe_squared_) return 0.0;
    return cost_of_danger(grid().spacing() * std::sqrt(static_cast<double>(squared)), threshold_);
  }

 private:
  ProtectiveZones zones_;
  KinematicZone kinematics_;
  double least_speed_ = -1.0;
  std::vector<PolarVelocity> velocities_;
  std::vector<std::uint8_t> within_reach_;  // neither in the kinematic zone nor too slow
  std::vector<std::uint8_t> is_feasible_;
  std::vector<std::int32_t> feasible_;
  std::size_t feasible_count_ = 0;
  DistanceTransform distance_;
  double threshold_ = 0.0;
  std::int32_t safe_squared_ = 0;  // from here on nothing is near [cells^2]
};

/// A velocity and what it costs.
struct Candidate {
  PolarVelocity velocity;
  double cost{};
};

/// The cheapest of the feasible cells, or `first` if none is cheaper; of equals the first. O(cells)
Candidate cheapest_cell(const VelocitySpace& space, const VelocityMetric& metric, const Candidate& first);

}  // namespace fairway::avoa
