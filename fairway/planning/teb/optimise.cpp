// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/optimise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway::teb {
namespace {

/// The barriers that stand still and count for one pose.
void associate_still(std::span<const BandObstacle> barriers, const Pose& pose, std::size_t knot,
                     double weight, Problem& problem) {
  const TebParams& params = problem.params;
  const double included =
      params.obstacle_association_force_inclusion_factor_ratio * params.min_obstacle_dist_m;
  const double cut_off = params.obstacle_association_cutoff_factor_ratio * params.min_obstacle_dist_m;
  const Vec2 ahead = unit_at(pose.heading);

  struct Nearest {
    const BandObstacle* barrier{};
    double distance = std::numeric_limits<double>::infinity();
  };
  std::array<Nearest, 2> sides;
  for (const BandObstacle& barrier : barriers) {
    if (barrier.moves()) continue;
    const double distance = barrier.from(pose.position).distance;
    if (distance < included) {
      problem.close.push_back({knot, &barrier, 0.0, weight});
    } else if (distance <= cut_off) {
      const Vec2 to = barrier.centre() - pose.position;
      Nearest& side = sides[ahead.x() * to.y() > ahead.y() * to.x() ? 1 : 0];
      if (distance < side.distance) side = {&barrier, distance};
    }
  }
  for (const Nearest& side : sides) {
    if (side.barrier != nullptr) problem.close.push_back({knot, side.barrier, 0.0, weight});
  }
}

}  // namespace

void associate(std::span<const BandObstacle> barriers, const Band& band, double obstacle_weight,
               Problem& problem) {
  problem.close.clear();
  double time = 0.0;
  for (std::size_t i = 1; i + 1 < band.size(); ++i) {
    time += band.time(i - 1);
    associate_still(barriers, band.pose(i), i, obstacle_weight, problem);
    for (const BandObstacle& barrier : barriers) {
      if (!barrier.moves()) continue;
      problem.close.push_back({i, &barrier, time, problem.params.weight_dynamic_obstacle_ratio});
    }
  }
}

Cost cost_of(const Problem& problem, const Band& band) {
  Cost cost;
  const auto add_to = [](double& sum) {
    return [&sum]<class C>(std::size_t, const C& each) {
      Values<C::rows> out;
      each(out);
      sum += out.value.squaredNorm();
    };
  };
  for_each_motion_cost(problem, band, add_to(cost.motion));
  for_each_barrier_cost(problem, band, add_to(cost.barriers));
  return cost;
}

Cost optimise(const TebParams& params, std::span<const BandObstacle> barriers, double speed, double yaw_rate,
              Band& band) {
  Problem problem{.params = params, .speed = speed, .yaw_rate = yaw_rate, .close = {}};
  double weight = params.weight_obstacle_ratio;
  for (int round = 0; round < params.no_outer_iterations_count; ++round) {
    resize(params, band);
    associate(barriers, band, weight, problem);
    improve(problem, params.no_inner_iterations_count, band);
    weight *= params.weight_adapt_factor_ratio;
  }
  return cost_of(problem, band);
}

bool is_sound(const Band& band) {
  const auto finite = [](double number) { return std::isfinite(number); };
  return band.time(0) > 0.0 &&
         std::ranges::all_of(band.knots, [&](const Knot& knot) { return std::ranges::all_of(knot, finite); });
}

}  // namespace fairway::teb
