// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// Learns, of one velocity nu, the acceleration a that a model f of it does not explain:
///
///     nu^' = f(nu) + a + 2 L (nu - nu^),    a' = L^2 (nu - nu^)
///
/// with both poles at the bandwidth L, exact for steps of h. It is the integral action of a controller that
/// takes a off: since f is given what the actuators do, limits and lags included, it cannot wind up.
struct AccelerationObserver {
  bool begun{false};
  double velocity{};     ///< nu, as last measured
  double expected{};     ///< nu^
  double unexplained{};  ///< a

  /// Takes in nu, `h` [s] after the one before; `kept` is exp(-L h), `model` f. The first only begins.
  template <class Model>
  void observe(double nu, double h, double kept, const Model& model) noexcept {
    if (begun) {
      const double surprise = nu - (expected + h * (model(0.5 * (velocity + nu)) + unexplained));
      expected = nu - kept * kept * surprise;
      unexplained += (1.0 - kept) * (1.0 - kept) / h * surprise;
    } else {
      begun = true;
      expected = nu;
    }
    velocity = nu;
  }
};

}  // namespace fairway
