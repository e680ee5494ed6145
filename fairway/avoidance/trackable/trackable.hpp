// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/trackable/keeper.hpp"

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
      .follows = true,
  };

  struct Params {
    double margin_m = 0.3;
    double tracking_bound_m = 0.0;
    double perception_error_m = 0.0;
    double navigation_error_m = 0.0;
    double current_error_mps = 0.0;
    double shown_margin_m = 0.4;
    double hold_s = 0.8;
    double slow_cost_ratio = trackable::usual_slow_cost;
    double drift_settling_s = 3.0;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::margin_m>({0, 1000}, "kept to every surface beyond own sphere and the four below"),
          field<&P::tracking_bound_m>({0, 1000}, "it is no farther than this from where it is foreseen"),
          field<&P::perception_error_m>({0, 1000}, "the others are no farther from where they are seen"),
          field<&P::navigation_error_m>({0, 1000}, "own ship is no farther from where it believes to be"),
          field<&P::current_error_mps>({0, 10}, "the water moves no more otherwise than it is taken to"),
          field<&P::shown_margin_m>({0, 1000}, "by which the inner avoider is shown own sphere larger"),
          field<&P::hold_s>({0, 100}, "how long a command is kept before its backup must still be possible"),
          field<&P::slow_cost_ratio>({0, 10}, "cost of stopping; that of turning round is 2"),
          field<&P::drift_settling_s>({0.1, 1000},
                                      "time constant of learning what sets it aside, beside the current"),
      };
    }
  };

  using Memory = trackable::Course;

  Params params;
  trackable::Deviations deviations;

  explicit Trackable(const Params& chosen) : params{chosen}, deviations{chosen.slow_cost_ratio} {}

  /// But for what the current adds over a window.
  double kept_margin() const {
    return params.margin_m + params.tracking_bound_m + params.perception_error_m + params.navigation_error_m;
  }

  Command decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceWrapper<Trackable>);

}  // namespace fairway
