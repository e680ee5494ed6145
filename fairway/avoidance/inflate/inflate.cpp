// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/inflate/inflate.hpp"

#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>

#include "fairway/core/chi.hpp"

namespace fairway {
namespace {

constexpr int sweeps = 8;  // of Jacobi's rotations: each squares what is left of the rest

/// Rounding may leave it a little below zero. Eigen's solvers are for matrices of any size: they would bring
/// locks into the library.
template <int N>
double greatest_eigenvalue(Eigen::Matrix<double, N, N> covariance) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int p = 0; p + 1 < N; ++p) {
      for (int q = p + 1; q < N; ++q) {
        Eigen::JacobiRotation<double> rotation;
        if (!rotation.makeJacobi(covariance, p, q)) continue;
        covariance.applyOnTheLeft(p, q, rotation.adjoint());
        covariance.applyOnTheRight(p, q, rotation);
      }
    }
  }
  return std::max(0.0, covariance.diagonal().maxCoeff());
}

}  // namespace

Inflate::Inflate(const Params& chosen)
    : params{chosen},
      k_space{chi_quantile(chosen.confidence_ratio, 3)},
      k_plane{chi_quantile(chosen.confidence_ratio, 2)} {}

double Inflate::growth(const Track& track, bool is_planar) const noexcept {
  const Mat3& covariance = track.position_covariance;
  const double wanted = is_planar
                            ? k_plane * std::sqrt(greatest_eigenvalue<2>(covariance.topLeftCorner<2, 2>()))
                            : k_space * std::sqrt(greatest_eigenvalue<3>(covariance));
  return std::min(wanted, params.max_growth_m);
}

Command Inflate::decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept {
  const bool is_planar = inner.thinks_in_plane();
  memory.shown.assign(s.tracks.begin(), s.tracks.end());
  for (Track& track : memory.shown) {
    track.radius += growth(track, is_planar);
    if (context.sketch) context.sketch->sphere(track.position, track.radius, "sphere grown by uncertainty");
  }
  Situation shown = s;
  shown.tracks = memory.shown;
  return inner.decide(shown, context.sketch);
}

}  // namespace fairway
