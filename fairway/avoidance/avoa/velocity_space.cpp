// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/velocity_space.hpp"

#include <algorithm>
#include <cmath>

namespace fairway::avoa {

void VelocitySpace::begin(const VelocityGrid& grid, const KinematicZone& kinematics, double least_speed) {
  const bool same_cells = grid == zones_.grid() && !velocities_.empty();
  zones_.clear(grid);
  if (!same_cells) {
    const auto count = static_cast<std::size_t>(grid.cell_count());
    velocities_.resize(count);
    within_reach_.resize(count);
    is_feasible_.resize(count);
    feasible_.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      velocities_[i] = PolarVelocity::of(grid.velocity(static_cast<int>(i)));
  }
  if (same_cells && kinematics == kinematics_ && least_speed == least_speed_) return;

  kinematics_ = kinematics;
  least_speed_ = least_speed;
  for (std::size_t i = 0; i < velocities_.size(); ++i) {
    const PolarVelocity& v = velocities_[i];
    within_reach_[i] = v.speed >= least_speed && !kinematics.contains(v) ? 1 : 0;
  }
}

void VelocitySpace::finish(double threshold) {
  const std::vector<std::uint8_t>& forbidden = zones_.forbidden();
  feasible_count_ = 0;
  for (std::size_t i = 0; i < forbidden.size(); ++i) {
    is_feasible_[i] = forbidden[i] != 0 ? std::uint8_t{0} : within_reach_[i];
    feasible_[feasible_count_] = static_cast<std::int32_t>(i);
    feasible_count_ += is_feasible_[i];
  }

  threshold_ = threshold;
  constexpr double beyond_all = DistanceTransform::infinite;
  const double safe = threshold / grid().spacing();
  safe_squared_ = static_cast<std::int32_t>(std::min(std::ceil(safe * safe), beyond_all));
  distance_.compute(forbidden, grid().side());
}

Candidate cheapest_cell(const VelocitySpace& space, const VelocityMetric& metric, const Candidate& first) {
  Candidate best = first;
  for (const std::int32_t cell : space.feasible()) {
    const PolarVelocity& v = space.velocity(cell);
    const double cost = metric(v, space.danger(cell));
    if (cost < best.cost) best = {v, cost};
  }
  return best;
}

}  // namespace fairway::avoa
