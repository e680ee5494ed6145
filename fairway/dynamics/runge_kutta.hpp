// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// `x` one step of length `h` [s] later, by the classical Runge-Kutta method of order 4; `rate_of(x)` says
/// how fast it changes, `moved` and `mean_of` of such rates stand with the state. All that it calls is to be
/// compiled into it: calls through memory cost Sparus2 and Kinematic half of the step.
template <class State, class RateOf>
[[gnu::always_inline]] inline State runge_kutta(const State& x, double h, const RateOf& rate_of) {
  const auto k1 = rate_of(x);
  const auto k2 = rate_of(moved(x, k1, h / 2));
  const auto k3 = rate_of(moved(x, k2, h / 2));
  const auto k4 = rate_of(moved(x, k3, h));
  return moved(x, mean_of(k1, k2, k3, k4), h);
}

}  // namespace fairway
