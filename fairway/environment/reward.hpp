// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace fairway::environment {

/// What a learner is paid for one step: added up over its ticks while it is under way.
struct RewardWeights {
  double progress{1.0};     ///< for each metre nearer to the end of its leg
  double arrival{10.0};     ///< once
  double collision{-50.0};  ///< each time that one begins
  double nearness{-1.0};    ///< for each second as near as a collision; less with distance, to 0 at `near_m`
  double time{-0.01};       ///< for each second
  double near_m{-1.0};      ///< between centres; below 0: twice the safety distance of the scenario

  static constexpr std::array<std::pair<std::string_view, double RewardWeights::*>, 6> members{
      {{"progress", &RewardWeights::progress},
       {"arrival", &RewardWeights::arrival},
       {"collision", &RewardWeights::collision},
       {"nearness", &RewardWeights::nearness},
       {"time", &RewardWeights::time},
       {"near_m", &RewardWeights::near_m}}};
};

/// 1 where centres are `safety_distance` apart or the sphere touches an obstacle, 0 from `near` on, linear in
/// between; whichever of the two is the nearer.
constexpr double nearness(double separation, double clearance, double safety_distance, double near) {
  const double room = std::min(separation - safety_distance, clearance);
  const double span = near - safety_distance;
  return span > 0.0 ? std::clamp(1.0 - room / span, 0.0, 1.0) : 0.0;
}

}  // namespace fairway::environment
