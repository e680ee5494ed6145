// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/params.hpp"

namespace fairway {

/// What to do about a team mate that has not been heard for `neighbour_lost_s`.
enum class LostPolicy {
  inflate,  ///< go on avoiding a sphere that grows
  hold,     ///< hold until it is heard again
  forget,   ///< act as if it were not there
};

template <>
struct EnumNames<LostPolicy> {
  static constexpr std::array names{"inflate", "hold", "forget"};
};

/// When data counts as good, and what is done while it is not. Ages are of the time in the message against
/// the clock of the helm.
struct OnboardPolicy {
  double own_stale_s = 0.5;
  double own_lost_s = 3.0;
  double neighbour_stale_s = 1.0;
  double neighbour_lost_s = 30.0;
  LostPolicy neighbour_lost = LostPolicy::inflate;
  double growth_mps = 0.25;
  double max_growth_m = 10.0;
  double unforeseen_acceleration_mps2 = 0.02;
  double max_ahead_s = 0.2;
  double jump_m = 1.0;
  double jump_speed_mps = 3.0;
  int jump_confirmations_count = 5;
  double frozen_s = 2.0;
  double frozen_speed_mps = 0.05;
  double recovery_s = 1.0;
  double watchdog_s = 1.0;
  double progress_window_s = 30.0;
  double current_time_constant_s = 10.0;

  static consteval auto fields() {
    using P = OnboardPolicy;
    return std::tuple{
        field<&P::own_stale_s>({0.01, 600}, "own navigation older than this: the vehicle holds"),
        field<&P::own_lost_s>({0.01, 600}, "own navigation older than this: control is handed back"),
        field<&P::neighbour_stale_s>({0.01, 600},
                                     "a neighbour older than this is not only predicted: its sphere grows"),
        field<&P::neighbour_lost_s>({0.01, 1e4}, "a neighbour older than this is lost"),
        field<&P::neighbour_lost>("what is done about a lost neighbour"),
        field<&P::growth_mps>({0, 10}, "how fast the sphere of a stale neighbour grows"),
        field<&P::max_growth_m>({0, 1000}, "by how much it grows at most"),
        field<&P::unforeseen_acceleration_mps2>(
            {0, 10}, "what a neighbour may do between messages: of it come the covariances of its track"),
        field<&P::max_ahead_s>({0, 60}, "a message may be so far ahead of the clock"),
        field<&P::jump_m>({0, 1000}, "a position may be so far from where it was expected ..."),
        field<&P::jump_speed_mps>({0, 100}, "... and farther by this speed for the time since the last one"),
        field<&P::jump_confirmations_count>({1, 1000},
                                            "after so many that agree with each other a jump is believed"),
        field<&P::frozen_s>({0.01, 600},
                            "a position that stays the same to the bit for so long is frozen ..."),
        field<&P::frozen_speed_mps>({0, 10}, "... if the vehicle says that it is faster than this"),
        field<&P::recovery_s>({0, 600}, "good data for so long, before control is taken again"),
        field<&P::watchdog_s>({0.01, 60},
                              "a helm that is not updated for so long: the vehicle is told to hold"),
        field<&P::progress_window_s>(
            {0.01, 1e6}, "neither nearer to the goal nor at a new place for so long: it makes no progress"),
        field<&P::current_time_constant_s>(
            {0.01, 1e6}, "of the low-pass filter on the current that own fixes tell, for crab steering"),
    };
  }
};

}  // namespace fairway
