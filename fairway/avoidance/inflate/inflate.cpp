// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/inflate/inflate.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fairway {
namespace {

/// P(|x| <= k) of three standard Gaussians.
double chi_probability_3(double k) {
  return std::erf(k / std::numbers::sqrt2) -
         std::sqrt(2.0 * std::numbers::inv_pi) * k * std::exp(-0.5 * k * k);
}

/// Rounding may leave it a little below zero.
template <int N>
double greatest_eigenvalue(const Eigen::Matrix<double, N, N>& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver{covariance, Eigen::EigenvaluesOnly};
  return std::max(0.0, solver.eigenvalues()[N - 1]);
}

}  // namespace

double chi_quantile_2(double probability) { return std::sqrt(-2.0 * std::log1p(-probability)); }

double chi_quantile_3(double probability) {
  double below = 0.0;
  double above = 40.0;  // the probability beyond it is less than the smallest number
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (below + above);
    (chi_probability_3(middle) < probability ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

Inflate::Inflate(const Params& chosen)
    : params{chosen},
      k_space{chi_quantile_3(chosen.confidence_ratio)},
      k_plane{chi_quantile_2(chosen.confidence_ratio)} {}

double Inflate::growth(const Track& track, bool is_planar) const noexcept {
  const Mat3& covariance = track.position_covariance;
  const double wanted = is_planar
                            ? k_plane * std::sqrt(greatest_eigenvalue<2>(covariance.topLeftCorner<2, 2>()))
                            : k_space * std::sqrt(greatest_eigenvalue<3>(covariance));
  return std::min(wanted, params.max_growth_m);
}

Command Inflate::decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept {
  memory.shown.assign(s.tracks.begin(), s.tracks.end());
  for (Track& track : memory.shown) {
    track.radius += growth(track, inner.info().planar);
    if (context.sketch) context.sketch->sphere(track.position, track.radius, "sphere grown by uncertainty");
  }
  Situation shown = s;
  shown.tracks = memory.shown;
  return inner.decide(shown, context.sketch);
}

}  // namespace fairway
