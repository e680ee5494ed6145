// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/avoidance/avoa_improved/capsule.hpp"
#include "fairway/avoidance/avoa_improved/drift.hpp"
#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// AVOA that knows how the vessel turns, and remembers the way round. Commands (speed, heading) are weighed
/// with AVOA's metric (campos2019, eqs. 6-8), but judged by the motion that they bring about, and the desired
/// heading is that of the shortest way round all that has been seen. README.md beside this file has the
/// mechanism. O(headings x speeds x window x solids) at worst, in order of cost and stopped at the best.
///
///     paper             here
///     V_i = [v, theta]  speed, heading
///     v_d, theta_d      preferred speed, heading of the way round
///     t_H               window_s
///     psi               speed_weight_ratio, heading_weight_ratio, danger_weight_ratio
struct AvoaImproved {
  static constexpr AlgorithmInfo info{
      .name = "avoa_improved",
      .title = "Adaptive velocity obstacle avoidance that foresees turns and remembers the way round",
      .source = "fairway; metric of campos2019, eqs. 6-8",
      .planar = true,
      .handed = true,
      .steers_by_heading = true,
      .needs_envelope = true,
      .finds_way = true,
  };

  struct Params {
    bool turn_aware = true;
    bool memory = true;
    double window_s = 7.5;
    double near_s = 5.0;
    double hold_s = 0.8;
    double margin_m = 0.25;
    double danger_m = 0.7;
    double turn_first_rad = 1.2;
    double way_margin_m = 0.4;
    double anticipation_s = 0.8;
    double bend_m = 2.0;
    double commitment_m = 4.0;
    double meeting_s = 55.0;
    double bow_s = 1.0;
    double same_place_m = 0.2;
    double speed_weight_ratio = 0.4;
    double heading_weight_ratio = 0.2;
    double danger_weight_ratio = 0.65;
    int heading_count = 36;
    int speed_count = 6;
    double least_speed_mps = 0.2;
    double astern_mps = 0.4;
    double turn_gain_hz = 1.0;
    double response_s = 0.5;
    double effort_ratio = 0.85;
    double drift_settling_s = 3.0;
    double max_turn_rate_radps = 0.3751;
    double max_turn_acceleration_radps2 = 0.5;
    double max_acceleration_mps2 = 0.5;

    static consteval auto fields() {
      using P = Params;
      constexpr Range share{0, 1};
      constexpr Range length{0, 1000};
      constexpr Range duration{0.2, 32};
      return std::tuple{
          field<&P::turn_aware>(
              "judge a command by the motion it brings about; else, and for a vehicle known to "
              "go sideways as well, as if it came at once"),
          field<&P::memory>("go round what has been seen, on the side chosen; else straight for the goal"),
          field<&P::window_s>(duration, "t_H: how far ahead contacts count"),
          field<&P::near_s>(duration, "turn_aware: how far ahead the clearance of what stays put costs"),
          field<&P::hold_s>(duration,
                            "turn_aware: after this long it must still be possible to stop short of "
                            "what stays put"),
          field<&P::margin_m>(length, "kept between own sphere and every surface"),
          field<&P::danger_m>({0.01, 1000}, "clearance beyond the margin up to which it costs"),
          field<&P::turn_first_rad>({0.01, 7},
                                    "turn_aware: who has to turn farther does so on the spot; slower "
                                    "from a quarter of it on"),
          field<&P::way_margin_m>(length, "memory: kept by the way round beyond the margin"),
          field<&P::anticipation_s>({0, 60}, "memory: the way round begins where the vessel will be by then"),
          field<&P::bend_m>(length, "memory: length that a radian of turning counts for"),
          field<&P::commitment_m>(length, "memory: to turn back, another way must be shorter by this"),
          field<&P::meeting_s>({0, 1000}, "memory: who can be met within this time is gone round there"),
          field<&P::bow_s>({0, 1000}, "memory: so much of its course ahead is gone round too"),
          field<&P::same_place_m>(length,
                                  "memory: what is seen this near to what was seen before is the same"),
          field<&P::speed_weight_ratio>(share, "psi of the deviation in speed; the three are scaled to 1"),
          field<&P::heading_weight_ratio>(share, "psi of the deviation in heading"),
          field<&P::danger_weight_ratio>(share, "psi of the cost of danger"),
          field<&P::heading_count>({4, 60}, "headings to choose from, evenly round the desired one"),
          field<&P::speed_count>({1, 16}, "speeds to choose from up to the limit, besides the desired one"),
          field<&P::least_speed_mps>({0, 100}, "slowest ahead, unless desired or to stop"),
          field<&P::astern_mps>({0, 100}, "turn_aware: speed astern to choose; 0 never"),
          field<&P::turn_gain_hz>({0.01, 10}, "k of the steering: turn rate per heading error"),
          field<&P::response_s>({0.01, 100}, "time constant of speed and turn rate"),
          field<&P::effort_ratio>({0.1, 1}, "share of the limits of turn rate and acceleration to count on"),
          field<&P::drift_settling_s>({0.1, 1000}, "turn_aware: time constant of learning the drift"),
          field<&P::max_turn_rate_radps>({0.001, 10}, "where the mission sets no limit"),
          field<&P::max_turn_acceleration_radps2>({0.001, 100}, "of the turn rate"),
          field<&P::max_acceleration_mps2>({0.001, 100}, "where the mission sets no limit"),
      };
    }
  };

  struct Memory {
    avoa_improved::Chart chart;
    std::optional<Vec2> committed;  ///< the direction of the way round taken last, unit [NED]
    avoa_improved::Drift drift;
    double time{};  ///< of the last decision [s]
  };

  Params params;

  /// Mode::cruise and the preferred velocity while that is free; Mode::avoid while anything makes it go
  /// otherwise; Mode::infeasible if no command keeps the margin, with the one that loses least of it. Who is
  /// to turn on the spot or go astern is told so by a turn rate.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<AvoaImproved>);

}  // namespace fairway
