// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/dynamics/lanes/kernel.hpp"
#include "fairway/dynamics/submerged_body.hpp"

namespace fairway {

/// Moves bodies of one kind by one step of `h` [s], as many at a time as the processor has lanes, each to the
/// bits of SubmergedBody::advanced. On the stack; allocates nothing.
class SideBySide {
 public:
  SideBySide(const SubmergedBody& body, double h, const lanes::MotionKernel& kernel) noexcept
      : body_{body}, kernel_{kernel} {
    bodies_.h = h;
  }

  /// `x` is moved by and by, at the latest by `finish`.
  void add(VehicleState& x, const lanes::PushOf<double>& push, const Water& water) noexcept;
  void finish() noexcept;

 private:
  lanes::Bodies bodies_;
  const SubmergedBody& body_;
  const lanes::MotionKernel& kernel_;
  std::size_t count_ = 0;
  std::array<VehicleState*, lanes::most_bodies> states_;
};

}  // namespace fairway
