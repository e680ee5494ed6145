// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/algorithm.hpp"

namespace fairway::pledge {

/// Whether own hull does what it is told, ahead, up and down, and in its turn: what it does, beside what its
/// envelope lets it do of what it is asked. A dead thruster or a stuck helm shows so while it is hardly off
/// its way. What waves do, to and fro, is left out. A value; nothing allocates. O(1).
class Obedience {
 public:
  /// What the hull does now. To be called at every decision, before `ask`.
  void look(const Situation& s) noexcept;
  /// What it is asked to do from now on.
  void ask(const Situation& s, const Command& command) noexcept;

  /// It goes slower, or turns less or otherwise, than it should have for some seconds.
  bool is_lacking() const { return is_lacking_; }

 private:
  /// Of one axis what is asked, what is to be expected by now, and what is lacking of that without the waves.
  struct Axis {
    double asked{}, expected{}, lacks{};

    /// It does `does`, can do no more than between the least and the greatest, comes to what is asked with a
    /// lag [s], and changes by no more than `up` and `down` in a second.
    void see(double does, double least, double greatest, double lag, double up, double down,
             double period) noexcept;
  };

  bool has_begun_{false}, is_lacking_{false};
  Axis surge_{}, heave_{}, turn_{};  // [m/s], through the water; [rad/s]
};

}  // namespace fairway::pledge
