// SPDX-License-Identifier: Apache-2.0
// In a plane, ORCA in space is ORCA: against an independent one in two dimensions, in long double, whose
// half-planes come from the tangents of the velocity obstacle and whose program tries all pairs.
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using Real = long double;
using Vec2 = Eigen::Matrix<Real, 2, 1>;

Real cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

struct HalfPlane {
  Vec2 normal;
  Real offset;

  Real violation(const Vec2& v) const { return offset - normal.dot(v); }
};

/// The boundary of the velocity obstacle is an arc and two legs, all tangent to it: the nearest point is
/// the nearest of the three that lies on its piece.
HalfPlane half_plane(const Vec2& p, const Vec2& v, const Vec2& own, Real radius, Real tau, Real period) {
  const Real d = p.norm();
  Vec2 best = Vec2::Zero();
  Vec2 normal = Vec2::Zero();
  Real nearest = std::numeric_limits<Real>::infinity();
  const auto offer = [&](const Vec2& point, const Vec2& outward) {
    if ((point - v).norm() < nearest) {
      nearest = (point - v).norm();
      best = point;
      normal = outward;
    }
  };
  if (d <= radius) {
    const Vec2 w = v - p / period;
    offer(p / period + radius / period * w.normalized(), w.normalized());
  } else {
    const Real reach = std::sqrt(d * d - radius * radius);
    for (const Real side : {-1.0L, 1.0L}) {
      // along the leg; the tangent point of the ball at the horizon is where it begins
      const Vec2 leg{(p.x() * reach - side * p.y() * radius) / (d * d),
                     (side * p.x() * radius + p.y() * reach) / (d * d)};
      const Vec2 outward = side * Vec2{-leg.y(), leg.x()};
      const Real along = std::fmax(leg.dot(v), reach / tau);
      offer(along * leg, outward);
    }
    const Vec2 w = v - p / tau;
    if (w.dot(p) < 0 && -w.dot(p) > radius * w.norm()) {
      offer(p / tau + radius / tau * w.normalized(), w.normalized());
    }
  }
  const Vec2 u = best - v;
  return {normal, normal.dot(own + u / 2)};
}

struct Answer {
  Vec2 velocity;
  Real violation = std::numeric_limits<Real>::infinity();
};

Answer solve(const std::vector<HalfPlane>& planes, const Vec2& preferred, Real speed) {
  const auto worst = [&](const Vec2& v) {
    Real most = 0;
    for (const HalfPlane& h : planes) most = std::fmax(most, h.violation(v));
    return most;
  };
  Answer best;
  Real nearest = std::numeric_limits<Real>::infinity();
  const auto offer = [&](const Vec2& v) {
    const bool is_allowed = v.norm() <= speed * (1 + 1e-14L) && worst(v) <= 1e-14L * speed;
    if (is_allowed && (v - preferred).norm() < nearest) {
      nearest = (v - preferred).norm();
      best = {v, 0};
    }
  };
  /// where a line meets the circle
  const auto offer_rim = [&](const Vec2& n, Real b, const auto& see) {
    const Real half2 = speed * speed * n.squaredNorm() - b * b;
    if (half2 < 0) return;
    for (const Real sign : {-1.0L, 1.0L}) {
      see(Vec2{(b * n + sign * std::sqrt(half2) * Vec2{-n.y(), n.x()}) / n.squaredNorm()});
    }
  };
  const auto meet = [](const Vec2& n, Real b, const Vec2& m, Real c) -> std::optional<Vec2> {
    const Real det = cross(n, m);
    if (det == 0) return std::nullopt;
    return Vec2{(b * m.y() - c * n.y()) / det, (c * n.x() - b * m.x()) / det};
  };

  offer(preferred);
  offer(preferred.normalized() * speed);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& [n, b] = planes[i];
    offer(preferred + (b - n.dot(preferred)) * n);
    offer_rim(n, b, offer);
    for (std::size_t j = 0; j < i; ++j) {
      if (const auto v = meet(n, b, planes[j].normal, planes[j].offset)) offer(*v);
    }
  }
  if (best.violation == 0) return best;

  // the least largest violation: one, two or three half-planes violated alike
  const auto offer_least = [&](const Vec2& v) {
    if (v.norm() <= speed * (1 + 1e-14L) && worst(v) < best.violation) best = {v, worst(v)};
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& [n, b] = planes[i];
    offer_least(speed * n);
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 nj = planes[j].normal - n;
      const Real bj = planes[j].offset - b;
      offer_rim(nj, bj, offer_least);
      for (std::size_t k = 0; k < j; ++k) {
        if (const auto v = meet(nj, bj, planes[k].normal - n, planes[k].offset - b)) offer_least(*v);
      }
    }
  }
  return best;
}

TEST(Orca3dInAPlane, IsOrcaInTwoDimensions) {
  double largest = 0.0;
  int infeasible = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const Rng rng = Rng{7}.stream("plane", i);
    const int count = 1 + static_cast<int>(i % 9);
    encounters::Encounter e =
        i % 2 == 0 ? encounters::swarm(count, 2.2, 6.0, rng) : encounters::congested(count, rng);
    Situation& s = e.situation;
    s.own.velocity.z() = 0.0;
    s.goal.position.z() = s.own.position.z();
    std::vector<HalfPlane> planes;
    const Vec2 own = s.own.velocity.head<2>().cast<Real>();
    for (Track& t : e.tracks) {
      t.position.z() = s.own.position.z();
      t.velocity.z() = 0.0;
      planes.push_back(half_plane((t.position - s.own.position).head<2>().cast<Real>(),
                                  own - t.velocity.head<2>().cast<Real>(), own, 2.0L, 5.0L, s.period));
    }
    const Answer expected = solve(planes, s.preferred_velocity().head<2>().cast<Real>(), s.limits.max_speed);

    Rng draws{1};
    Context context{draws};
    NoMemory memory;
    const Command command = Orca3d{{}}.decide(e, memory, context);

    EXPECT_EQ(command.velocity.z(), 0.0);
    EXPECT_EQ(command.mode, expected.violation > 0 ? Mode::infeasible : Mode::avoid) << "case " << i;
    const Vec2 velocity = command.velocity.head<2>().cast<Real>();
    largest = std::fmax(largest, static_cast<double>((velocity - expected.velocity).norm()));
    infeasible += expected.violation > 0 ? 1 : 0;
  }
  EXPECT_LT(largest, 1e-9 * 1.5);  // measured 2e-13
  EXPECT_GT(infeasible, 400);
}

}  // namespace
}  // namespace fairway
