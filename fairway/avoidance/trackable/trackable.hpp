// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/trackable/foresight.hpp"

namespace fairway {

/// Lets another avoider command a vehicle that turns in order to go elsewhere: foresees, by the envelope of
/// the vehicle, what it will make of the answer, and follows it where it is clear, or a backup manoeuvre is
/// left after a while; otherwise the nearest course and speed of which that is true. A safe backup, once
/// there, is not given up as long as what is near keeps its velocity. It answers with surge and turn rate,
/// so that the way is the one foreseen, whatever steering the vehicle has. Without an envelope, and on a
/// vehicle that goes sideways, it shows the other avoider a margin and is nothing else. README.md beside this
/// file. O(plans x steps x solids) where the answer is not clear, and else O(steps x solids).
struct Trackable {
  static constexpr AlgorithmInfo info{
      .name = "trackable",
      .title = "Commands that the vehicle can follow, foreseen with a backup manoeuvre",
      .source =
          "fairway; after Alonso-Mora et al. 2010 (NH-ORCA) and Agrawal, Chen, Panagou 2023 (gatekeeper)",
      .handed = true,
      .steers_by_heading = true,
      .ignores_obstacles =
          true,  // without an envelope it shows a margin, and leaves the rest to the inner one
      .ignores_movers = true,
      .needs_envelope = true,
  };

  struct Params {
    double margin_m = 0.3;
    double shown_margin_m = 0.4;
    double hold_s = 0.8;
    double slow_cost_ratio = 0.5;
    double drift_settling_s = 3.0;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::margin_m>({0, 1000}, "kept to every surface, beyond own sphere"),
          field<&P::shown_margin_m>({0, 1000}, "by which the inner avoider is shown own sphere larger"),
          field<&P::hold_s>({0, 100}, "how long a command is kept before its backup must still be possible"),
          field<&P::slow_cost_ratio>({0, 10}, "cost of stopping; that of turning round is 2"),
          field<&P::drift_settling_s>({0.1, 1000}, "time constant of learning what sets it aside"),
      };
    }
  };

  struct Memory {
    std::optional<Vec2> drift;  ///< [m/s, NED]
    double sway{};              ///< through the water, to starboard, as the envelope says [m/s]
    double side = 1.0;          ///< to which it went last: 1 starboard, -1 port
  };

  /// A plan relative to the inner answer.
  struct Deviation {
    double cost;
    double speed_ratio;
    double turn;  ///< to the side that is preferred [rad]
  };
  static constexpr std::size_t turn_count = 25;  ///< both sides of every 15 degrees
  static constexpr std::size_t speed_count = 3;
  static constexpr std::size_t deviation_count = turn_count * speed_count + 1;

  Params params;
  std::array<Deviation, deviation_count> deviations;  ///< the cheapest first

  explicit Trackable(const Params& chosen);

  Command decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceWrapper<Trackable>);

}  // namespace fairway
