// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

/// ORCA in the plane once more, in long double and by other means, to hold the real ones against: its
/// half-planes come from the tangents of the velocity obstacle, and its program tries all corners.
namespace fairway::plane_reference {

using Real = long double;
using Vector = Eigen::Matrix<Real, 2, 1>;

inline Real cross(const Vector& a, const Vector& b) { return a.x() * b.y() - a.y() * b.x(); }

struct Line {
  Vector normal;
  Real offset;

  Real violation(const Vector& v) const { return offset - normal.dot(v); }
};

/// What a neighbour who takes `1 - share` of the change leaves. The boundary of the velocity obstacle is an
/// arc and two legs, all tangent to it: the nearest point is the nearest of the three that lies on
/// its piece. `p` and `v` as in ORCA, `own` the present velocity.
inline Line half_plane(const Vector& p, const Vector& v, const Vector& own, Real radius, Real tau,
                       Real period, Real share = 0.5L) {
  const Real d = p.norm();
  Vector best = Vector::Zero();
  Vector normal = Vector::Zero();
  Real nearest = std::numeric_limits<Real>::infinity();
  const auto offer = [&](const Vector& point, const Vector& outward) {
    if ((point - v).norm() < nearest) {
      nearest = (point - v).norm();
      best = point;
      normal = outward;
    }
  };
  if (d <= radius) {
    const Vector w = v - p / period;
    offer(p / period + radius / period * w.normalized(), w.normalized());
  } else {
    const Real reach = std::sqrt(d * d - radius * radius);
    for (const Real side : {-1.0L, 1.0L}) {
      // along the leg; the tangent point of the disc at the horizon is where it begins
      const Vector leg{(p.x() * reach - side * p.y() * radius) / (d * d),
                       (side * p.x() * radius + p.y() * reach) / (d * d)};
      const Vector outward = side * Vector{-leg.y(), leg.x()};
      const Real along = std::fmax(leg.dot(v), reach / tau);
      offer(along * leg, outward);
    }
    const Vector w = v - p / tau;
    if (w.dot(p) < 0 && -w.dot(p) > radius * w.norm()) {
      offer(p / tau + radius / tau * w.normalized(), w.normalized());
    }
  }
  const Vector u = best - v;
  return {normal, normal.dot(own + share * u)};
}

struct Answer {
  Vector velocity = Vector::Zero();
  Real violation = std::numeric_limits<Real>::infinity();
};

/// The plane program, the first `hard_count` lines hard: of the points where it can have its optimum, the
/// best.
class Program {
 public:
  Program(std::vector<Line> lines, std::size_t hard_count, Vector preferred, Real speed)
      : lines_{std::move(lines)}, hard_count_{hard_count}, preferred_{std::move(preferred)}, speed_{speed} {}

  Answer solve() const {
    if (const auto nearest = this->nearest()) return {*nearest, 0};
    Answer least = least_violation();
    if (least.violation < std::numeric_limits<Real>::infinity()) return least;
    const auto end = lines_.begin() + static_cast<std::ptrdiff_t>(hard_count_);
    return Program{{lines_.begin(), end}, 0, preferred_, speed_}.solve();
  }

 private:
  static constexpr Real tolerance = 1e-14L;

  bool keeps_hard(const Vector& v) const {
    if (!(v.norm() <= speed_ * (1 + tolerance))) return false;
    return std::all_of(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(hard_count_),
                       [&](const Line& h) { return h.violation(v) <= tolerance * speed_; });
  }

  Real worst(const Vector& v) const {
    Real most = 0;
    for (std::size_t i = hard_count_; i < lines_.size(); ++i) most = std::fmax(most, lines_[i].violation(v));
    return most;
  }

  template <class See>
  void on_rim(const Line& line, const See& see) const {
    const Real length2 = line.normal.squaredNorm();
    const Real half2 = speed_ * speed_ * length2 - line.offset * line.offset;
    if (half2 < 0) return;
    for (const Real sign : {-1.0L, 1.0L}) {
      const Vector along{-line.normal.y(), line.normal.x()};
      see(Vector{(line.offset * line.normal + sign * std::sqrt(half2) * along) / length2});
    }
  }

  template <class See>
  static void at_crossing(const Line& a, const Line& b, const See& see) {
    const Real determinant = cross(a.normal, b.normal);
    if (determinant == 0) return;
    see(Vector{(a.offset * b.normal.y() - b.offset * a.normal.y()) / determinant,
               (b.offset * a.normal.x() - a.offset * b.normal.x()) / determinant});
  }

  std::optional<Vector> nearest() const {
    std::optional<Vector> best;
    const auto offer = [&](const Vector& v) {
      if (!keeps_hard(v) || worst(v) > tolerance * speed_) return;
      if (!best || (v - preferred_).norm() < (*best - preferred_).norm()) best = v;
    };
    offer(preferred_);
    offer(preferred_.normalized() * speed_);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      offer(preferred_ + lines_[i].violation(preferred_) * lines_[i].normal);
      on_rim(lines_[i], offer);
      for (std::size_t j = 0; j < i; ++j) at_crossing(lines_[i], lines_[j], offer);
    }
    return best;
  }

  /// Where one, two or three soft lines are violated alike, on hard ones or on the rim where these are too
  /// few.
  Answer least_violation() const {
    Answer best;
    const auto offer = [&](const Vector& v) {
      if (keeps_hard(v) && worst(v) < best.violation) best = {v, worst(v)};
    };
    std::vector<Line> bounds{lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(hard_count_)};
    for (std::size_t i = hard_count_; i < lines_.size(); ++i) {
      offer(speed_ * lines_[i].normal);
      for (std::size_t j = hard_count_; j < i; ++j)
        bounds.push_back({lines_[j].normal - lines_[i].normal, lines_[j].offset - lines_[i].offset});
    }
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      on_rim(bounds[i], offer);
      for (std::size_t j = 0; j < i; ++j) at_crossing(bounds[i], bounds[j], offer);
    }
    return best;
  }

  std::vector<Line> lines_;
  std::size_t hard_count_;
  Vector preferred_;
  Real speed_;
};

}  // namespace fairway::plane_reference
