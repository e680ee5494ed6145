// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/core/leg.hpp"

namespace fairway {

/// A list of legs and how far a vehicle has come with it. A value: a copy is a snapshot.
class Mission {
 public:
  /// `stuck_after` is how many times the straight-line time a transit may last before the vehicle
  /// counts as stuck.
  Mission(std::vector<Leg> legs, double stuck_after);

  /// Passes every leg that is complete at `time` [s]. `everyone_ready` opens the present rendezvous.
  void advance(const Ownship& own, double time, bool everyone_ready) noexcept;

  /// From `time` [s] on these legs, of which there are as many as before, each of the kind that it was. The
  /// present leg leads to its new end, and a transit has its time anew; whoever has arrived sets out again.
  void change(std::vector<Leg> legs, const Ownship& own, double time);

  /// The leg to carry out, or null after the last.
  const Leg* leg() const { return index_ < legs_.size() ? &legs_[index_] : nullptr; }
  Phase phase() const { return phase_; }

  /// The next transit from the present leg on, or null.
  const Leg* next_transit() const;

  /// Rendezvous reached so far, the one it waits at included; past the last one, any number.
  int rendezvous_reached() const;

 private:
  bool is_complete(const Leg& leg, const Ownship& own, double time, bool everyone_ready) const noexcept;
  void begin_leg(const Ownship& own, double time) noexcept;

  std::vector<Leg> legs_;
  std::size_t past_last_rendezvous_{0};  ///< index of the first leg after it
  double stuck_after_;
  std::size_t index_{0};
  int rendezvous_passed_{0};
  Phase phase_{Phase::deploying};
  bool begun_{false};
  double leg_start_{};  ///< [s]
  double deadline_{};   ///< of a transit [s]
};

}  // namespace fairway
