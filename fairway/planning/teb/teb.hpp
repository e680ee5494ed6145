// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/planning/teb/band.hpp"

namespace fairway {

/// Timed elastic bands (Roesmann et al. 2012, 2013, 2017) with the costs, weights and defaults of the ROS
/// package teb_local_planner, written anew. A band is a sequence of poses and of the times between them, from
/// where the vessel is along the way to the goal as far as it looks ahead; that is a straight line, or
/// planned round what is known (`global_plan`). Soft costs of time, of speeds and accelerations beyond their
/// limits, of leaving circular arcs and of nearness to obstacles are minimised by least squares, for a band
/// of each of up to five homotopy classes; the best is followed. For a vessel that goes where it heads: it
/// commands the speed along its heading, astern if negative, and a yaw rate.
///
/// At the default lookahead 0.2 ms a decision in open water, 1 to 2 ms among buoys.
struct Teb {
  static constexpr AlgorithmInfo info{
      .name = "teb",
      .title = "Timed elastic band in several homotopy classes",
      .source = "Roesmann et al. 2012, 2013, 2017; defaults of teb_local_planner",
      .planar = true,
      .allocates = true,
      .isotropic = false,  // but for rounding, which the search for a minimum magnifies
      .steers_by_heading = true,
      .finds_way = true,
  };

  using Params = TebParams;

  struct Memory {
    std::vector<Vec2> way;            ///< to the goal, from where the vessel was when it was planned [m, NE]
    double planned_s{};               ///< time of the situation in which one was planned
    bool plan_failed{};               ///< no band along it could be followed
    std::vector<teb::Band> bands;     ///< warm starts; the one followed comes first
    std::int64_t infeasible_count{};  ///< decisions whose band could not be followed
  };

  Params params;

  /// Keeps the speed below max_vel_x_mps whatever the goal's cruise speed is, and stands still where that is
  /// zero. Mode::cruise where no obstacle is within reach of the band, Mode::avoid otherwise,
  /// Mode::infeasible with zero velocity where the first poses of the best band touch something or its
  /// numbers make no sense; all bands are then forgotten.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<Teb>);

}  // namespace fairway
