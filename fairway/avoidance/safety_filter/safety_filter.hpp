// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/trackable/keeper.hpp"

namespace fairway {

/// Changes another avoider's answer as little as keeps clear of everything: a control barrier function of
/// second order per hazard, on the disc round the vehicle, bounds its horizontal acceleration, within what
/// the actuators or `Limits::max_acceleration` give. A vehicle that must turn in order to go elsewhere has no
/// such acceleration: where its envelope is known, it keeps a backup manoeuvre instead. Where the answer is a
/// wrench and the model is known, the accelerations are those of forces; else those that lead from the
/// present velocity to the commanded one. O(n^2) in what is near, besides the inner avoider; O(n^3) at worst
/// where nothing keeps clear.
struct SafetyFilter {
  static constexpr AlgorithmInfo info{
      .name = "safety_filter",
      .title = "Control barrier function filter around another avoider",
      .source = "Ames et al. 2019; Nguyen and Sreenath 2016 (exponential barrier functions of second order)",
      .planar = true,
      .handed = true,  // heading straight for the middle it sidesteps to starboard
      .needs_envelope = true,
      .follows = true,
  };

  struct Params {
    double k1_hz = 0.3;
    double k2_hz = 0.3;
    double margin_m = 0.5;
    double authority_ratio = 0.7;
    double response_s = 1.5;
    double activation_m = 30.0;
    double sidestep_ratio = 0.2;
    double hold_s = 0.8;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::k1_hz>({0.001, 100}, "closing speed allowed per distance that is left"),
          field<&P::k2_hz>({0.001, 100}, "how fast that limit is approached"),
          field<&P::margin_m>({0, 1000}, "kept between own sphere and every surface"),
          field<&P::authority_ratio>({0, 1}, "share of the forces of the model that may be used"),
          field<&P::response_s>(
              {0.01, 1000},
              "without forces: time in which the vehicle takes up a velocity; no less than its "
              "time constant"),
          field<&P::activation_m>({0, 10000}, "what has its surface within this of own sphere counts"),
          field<&P::sidestep_ratio>({0, 10},
                                    "push to the side per push back, when heading straight for the middle"),
          field<&P::hold_s>({0, 100},
                            "of who must turn: how long an answer is kept before its backup must still be "
                            "possible"),
      };
    }
  };

  using Memory = trackable::Course;

  Params params;
  trackable::Deviations deviations{trackable::usual_slow_cost};

  double kept_margin() const { return params.margin_m; }

  /// The inner avoider's answer itself if it keeps clear. Otherwise Mode::avoid; Mode::infeasible if nothing
  /// within the bounds keeps clear of all, with what violates it least. `Command::note` says if it began too
  /// late. Without a model a wrench cannot be judged and is left out if anything is near. A vehicle that must
  /// turn is kept clear by a backup manoeuvre that is always ready (trackable::Keeper).
  Command decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept;

  /// By barriers alone, an answer that is there already; for methods that filter their own. `sketch` may be
  /// null.
  Command filtered(const Situation& s, const Command& asked, Sketch* sketch) const noexcept;
};

static_assert(AvoidanceWrapper<SafetyFilter>);

}  // namespace fairway
