// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/chi.hpp"

#include <cmath>
#include <numbers>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// P(|x| <= k): the series of the incomplete gamma function P(n/2, k^2/2) (Abramowitz and Stegun
/// 1964, 6.5.29),
///     k^n e^(-k^2/2) / (2^(n/2) Gamma(n/2 + 1)) (1 + k^2 / (n + 2) + k^4 / ((n + 2) (n + 4)) + ...).
double chi_probability(double k, int dimensions) {
  const bool odd = dimensions % 2 == 1;
  double term = math::exp(-0.5 * k * k) * (odd ? std::sqrt(2.0 * std::numbers::inv_pi) * k : 1.0);
  for (int n = odd ? 3 : 2; n <= dimensions; n += 2) term *= k * k / n;
  double probability = 0.0;
  for (int n = dimensions + 2; term > 0x1p-60 * probability; n += 2) {
    probability += term;
    term *= k * k / n;
  }
  return probability;
}

}  // namespace

double chi_quantile(double probability, int dimensions) {
  if (dimensions == 2) return std::sqrt(-2.0 * math::log(1.0 - probability));

  double below = 0.0;
  double above = 16.0;  // the probability beyond it is below 1e-40 in 10 dimensions
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (below + above);
    (chi_probability(middle, dimensions) < probability ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

}  // namespace fairway
