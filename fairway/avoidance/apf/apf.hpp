// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// How the sum of the potential field's vectors becomes a velocity.
enum class ApfSpeedLaw {
  clamped,    ///< the vector itself, its horizontal and vertical parts each held to the cruise speed
  bang_bang,  ///< full cruise speed horizontally and vertically, as raja2024 Algorithm 1 prints it
};

template <>
struct EnumNames<ApfSpeedLaw> {
  static constexpr std::array names{"clamped", "bang_bang"};
};

/// Artificial potential fields: a unit pull towards the goal and a push away from everyone close,
/// growing linearly as they come closer (raja2024, eq. 1 and Algorithm 1, lines 1-13). Everything in
/// NED; the repulsion is summed afresh on every decision. O(tracks + obstacle vertices), no memory.
///
///     paper        here
///     CRIT_DIST    crit_dist_m
///     W1, W2       w1_ratio, w2_ratio
///     DES_VEL      goal.cruise_speed
///     V_obj        v_obj, along the preferred velocity
///     V_obs, V_f   v_obs, v_f
struct Apf {
  static constexpr AlgorithmInfo info{
      .name = "apf",
      .title = "Artificial potential fields",
      .source = "raja2024, section III-B, Algorithm 1, after Khatib 1986",
      .needs_sway = true,
  };

  struct Params {
    double crit_dist_m = 6.0;
    double w1_ratio = 1.0;
    double w2_ratio = 0.5;
    ApfSpeedLaw speed_law = ApfSpeedLaw::clamped;

    static consteval auto fields() {
      return std::tuple{
          field<&Params::crit_dist_m>({0.1, 1000},
                                      "range at which repulsion begins, centre to centre; "
                                      "to the surface of an obstacle"),
          field<&Params::w1_ratio>({0, 1000}, "weight of the attraction W1"),
          field<&Params::w2_ratio>({0, 1000}, "weight of the repulsion W2"),
          field<&Params::speed_law>("how the force becomes a velocity"),
      };
    }
  };

  using Memory = NoMemory;

  Params params;

  /// Alone, the preferred velocity with Mode::cruise; otherwise Mode::avoid, and stern first is allowed.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;

  double farthest_obstacle() const noexcept { return params.crit_dist_m; }
};

static_assert(AvoidanceAlgorithm<Apf>);

}  // namespace fairway
