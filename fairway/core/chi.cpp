// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/chi.hpp"

#include <cmath>
#include <numbers>

namespace fairway {
namespace {

/// P(|x| <= k), from one or two dimensions upwards by two.
double chi_probability(double k, int dimensions) {
  const bool odd = dimensions % 2 == 1;
  const double density = std::exp(-0.5 * k * k);
  double probability = odd ? std::erf(k / std::numbers::sqrt2) : 1.0 - density;
  double term = odd ? std::sqrt(2.0 * std::numbers::inv_pi) * k : 0.5 * k * k;
  for (int n = odd ? 3 : 4; n <= dimensions; n += 2) {
    probability -= term * density;
    term *= k * k / n;
  }
  return probability;
}

}  // namespace

double chi_quantile(double probability, int dimensions) {
  if (dimensions == 2) return std::sqrt(-2.0 * std::log1p(-probability));

  double below = 0.0;
  double above = 40.0;  // the probability beyond it is less than the smallest number
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (below + above);
    (chi_probability(middle, dimensions) < probability ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

}  // namespace fairway
