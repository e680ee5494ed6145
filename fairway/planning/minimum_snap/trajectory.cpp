// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/minimum_snap/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// k (k-1) .. (k-order+1): what the derivative leaves before s^(k-order).
double falling(int k, int order) {
  double product = 1.0;
  for (int i = 0; i < order; ++i) product *= k - i;
  return product;
}

/// `order` derivatives by s, by Horner's rule.
Vec2 derivative_by_s(const Trajectory::Coefficients& c, int order, double s) {
  Vec2 sum = Vec2::Zero();
  for (int k = 7; k >= order; --k) sum = s * sum + falling(k, order) * c.col(k);
  return sum;
}

/// Raises `greatest` to the greatest norm on `curve`, but for a millionth: a piece that cannot beat it by
/// that is left alone.
void raise(double& greatest, const Bezier& curve, int depth) {
  greatest = math::fmax(greatest, math::fmax(curve.first().norm(), curve.last().norm()));
  if (depth == 0 || curve.norm_bound() <= (1.0 + 0.9e-6) * greatest) return;
  const auto [left, right] = curve.halves();
  raise(greatest, left, depth - 1);
  raise(greatest, right, depth - 1);
}

}  // namespace

Trajectory::Trajectory(std::vector<Segment> segments) : segments_{std::move(segments)} {
  if (segments_.empty()) throw InputError("a trajectory needs a segment");
  double time = 0.0;
  for (const Segment& segment : segments_) {
    if (!(segment.duration > 0.0 && std::isfinite(segment.duration))) {
      throw InputError("a segment of a trajectory must last longer than 0 s");
    }
    ends_.push_back(time += segment.duration);
  }
}

Vec2 Trajectory::derivative(std::size_t segment, int order, double s) const noexcept {
  const Segment& piece = segments_[segment];
  return derivative_by_s(piece.coefficients, order, s) / math::power(piece.duration, order);
}

TrajectorySample Trajectory::sample(double time) const noexcept {
  if (segments_.empty()) return {.position = resting_};
  if (time <= 0.0) return {.position = derivative(0, 0, 0.0)};
  if (time >= duration()) return {.position = derivative(segments_.size() - 1, 0, 1.0)};

  const auto end = std::ranges::upper_bound(ends_, time);
  const auto i = static_cast<std::size_t>(end - ends_.begin());
  const double begin = i == 0 ? 0.0 : ends_[i - 1];
  const double s = std::min(1.0, (time - begin) / segments_[i].duration);
  return {.position = derivative(i, 0, s),
          .velocity = derivative(i, 1, s),
          .acceleration = derivative(i, 2, s),
          .jerk = derivative(i, 3, s),
          .snap = derivative(i, 4, s)};
}

Bezier Trajectory::curve(std::size_t segment, int order) const noexcept {
  const Segment& piece = segments_[segment];
  Bezier::Points powers(2, 8 - order);
  for (int k = order; k < 8; ++k) {
    powers.col(k - order) =
        falling(k, order) / math::power(piece.duration, order) * piece.coefficients.col(k);
  }
  return Bezier::from_powers(powers);
}

double Trajectory::peak(int order) const noexcept {
  constexpr int deepest = 40;
  double greatest = 0.0;
  for (std::size_t i = 0; i < segments_.size(); ++i) raise(greatest, curve(i, order), deepest);
  return (1.0 + 1e-6) * greatest;
}

double Trajectory::snap_integral() const noexcept {
  double sum = 0.0;
  for (const Segment& piece : segments_) {
    // products of c_i falling(i, 4) s^(i-4)
    for (int i = 4; i < 8; ++i) {
      for (int k = 4; k < 8; ++k) {
        sum += falling(i, 4) * falling(k, 4) * piece.coefficients.col(i).dot(piece.coefficients.col(k)) /
               ((i + k - 7) * math::power(piece.duration, 7));
      }
    }
  }
  return sum;
}

double Trajectory::length(std::size_t segment) const noexcept {
  constexpr int pieces = 64;
  double sum = 0.0;
  for (int k = 0; k <= 2 * pieces; ++k) {
    const double weight = k == 0 || k == 2 * pieces ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    const double s = k / (2.0 * pieces);
    sum += weight / (6.0 * pieces) * derivative_by_s(segments_[segment].coefficients, 1, s).norm();
  }
  return sum;
}

double Trajectory::length() const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < segments_.size(); ++i) sum += length(i);
  return sum;
}

Trajectory Trajectory::slowed(double factor) const {
  if (segments_.empty()) return *this;
  std::vector<Segment> segments = segments_;
  for (Segment& segment : segments) segment.duration *= factor;
  return Trajectory{std::move(segments)};
}

}  // namespace fairway
