// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/plane_program/plane_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

/// A program that owns its half-planes.
struct Question {
  std::vector<HalfPlane> half_planes;
  std::size_t hard_count = 0;
  double max_length = 1.0;
  Vec2 wanted;

  PlaneChoice answer() const { return nearest_in_plane({half_planes, hard_count, max_length}, wanted); }
};

using Long = Eigen::Matrix<long double, 2, 1>;

/// A half-plane n . x + s t >= b over the point x and the violation t: s is 1 for soft ones.
struct Slanted {
  Long normal;
  long double slope;
  long double offset;
};

/// Every active set, tried in long double.
class BruteForce {
 public:
  explicit BruteForce(const Question& q) : q_{q} {
    for (std::size_t i = 0; i < q.half_planes.size(); ++i) {
      const HalfPlane& h = q.half_planes[i];
      all_.push_back({h.normal.cast<long double>(), i < q.hard_count ? 0.0L : 1.0L, h.offset});
    }
  }

  /// The nearest point in all half-planes, the soft ones moved back by `level`.
  std::optional<Long> nearest(long double level) const {
    std::vector<Long> candidates{wanted()};
    if (wanted().norm() > 0) candidates.push_back(radius() * wanted().normalized());
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const long double b = all_[i].offset - level * all_[i].slope;
      candidates.push_back(wanted() + (b - all_[i].normal.dot(wanted())) * all_[i].normal);
      add_on_circle(all_[i].normal, b, candidates);
      for (std::size_t j = 0; j < i; ++j)
        add_crossing(all_[i].normal, b, all_[j].normal, all_[j].offset - level * all_[j].slope, candidates);
    }
    std::optional<Long> best;
    for (const Long& x : candidates) {
      if (!keeps(x, level)) continue;
      if (!best || (x - wanted()).norm() < (*best - wanted()).norm()) best = x;
    }
    return best;
  }

  /// The least largest violation of the soft ones, among the corners of what is to be kept.
  long double least_violation() const {
    std::vector<Long> candidates;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      candidates.push_back(radius() * all_[i].normal);
      add_on_circle(all_[i].normal, all_[i].offset, candidates);
      for (std::size_t j = 0; j < i; ++j) {
        add_crossing(all_[i].normal, all_[i].offset, all_[j].normal, all_[j].offset, candidates);
        add_on_circle(all_[i].normal - all_[j].normal, all_[i].offset - all_[j].offset, candidates);
        for (std::size_t k = 0; k < all_.size(); ++k) {
          const Slanted& a = all_[i];
          const Slanted& b = all_[j];
          const Slanted& c = all_[k];
          add_crossing(a.normal - b.normal, a.offset - b.offset, c.normal, c.offset, candidates);
          if (k < j) {
            add_crossing(a.normal - b.normal, a.offset - b.offset, a.normal - c.normal, a.offset - c.offset,
                         candidates);
          }
        }
      }
    }
    long double least = std::numeric_limits<long double>::infinity();
    for (const Long& x : candidates) {
      if (!keeps(x, std::numeric_limits<long double>::infinity())) continue;
      long double largest = 0;
      for (const Slanted& h : all_)
        if (h.slope > 0) largest = std::max(largest, h.offset - h.normal.dot(x));
      least = std::min(least, largest);
    }
    return least;
  }

 private:
  static constexpr long double tolerance = 1e-14L;

  Long wanted() const { return q_.wanted.cast<long double>(); }
  long double radius() const { return q_.max_length; }

  bool keeps(const Long& x, long double level) const {
    if (!(x.norm() <= radius() + tolerance)) return false;
    return std::ranges::all_of(all_, [&](const Slanted& h) {
      return (h.slope > 0 && std::isinf(level)) ||
             h.normal.dot(x) + h.slope * (h.slope > 0 ? level : 0) >= h.offset - tolerance;
    });
  }

  void add_on_circle(Long normal, long double offset, std::vector<Long>& to) const {
    const long double length = normal.norm();
    if (length == 0 || std::isinf(radius())) return;
    normal /= length;
    offset /= length;
    const long double half2 = radius() * radius() - offset * offset;
    if (half2 < -1e-17L) return;
    const long double half = std::sqrt(std::max(0.0L, half2));
    const Long along{-normal.y(), normal.x()};
    to.push_back(offset * normal + half * along);
    to.push_back(offset * normal - half * along);
  }

  static void add_crossing(const Long& m, long double a, const Long& n, long double b,
                           std::vector<Long>& to) {
    const long double determinant = m.x() * n.y() - m.y() * n.x();
    if (std::fabs(determinant) < 1e-17L) return;
    to.push_back(Long{(a * n.y() - b * m.y()) / determinant, (b * m.x() - a * n.x()) / determinant});
  }

  const Question& q_;
  std::vector<Slanted> all_;
};

HalfPlane half_plane(double bearing, double offset) {
  return {{std::cos(bearing), std::sin(bearing)}, offset};
}

/// Up to ten half-planes and a disc; with `hard`, up to four of them are the sides of a turned box.
Question random_question(std::uint64_t index, bool hard) {
  Rng rng = Rng{1}.stream("question", index);
  Question q;
  q.max_length = std::exp(rng.uniform(-3.0, 3.0));
  if (hard) {
    const double turn = rng.uniform(-pi, pi);
    q.hard_count = 4;
    for (int side = 0; side < 4; ++side)
      q.half_planes.push_back(half_plane(turn + side * pi / 2, -q.max_length * rng.uniform(0.05, 1.2)));
  }
  const double most = rng.uniform(-0.2, 1.0);
  const std::uint64_t count = rng.index(9);
  for (std::uint64_t i = 0; i < count; ++i) {
    q.half_planes.push_back(half_plane(rng.uniform(-pi, pi), q.max_length * rng.uniform(-1.0, most)));
  }
  const double bearing = rng.uniform(-pi, pi);
  q.wanted = rng.uniform(0.0, 1.5 * q.max_length) * Vec2{std::cos(bearing), std::sin(bearing)};
  return q;
}

struct Difference {
  double point = 0.0;
  double violation = 0.0;
  int infeasible = 0;
};

/// Largest differences from the brute force, as fractions of the disc's radius.
template <class Make>
Difference from_brute_force(std::uint64_t count, Make make) {
  Difference d;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Question q = make(i);
    const PlaneChoice choice = q.answer();
    const BruteForce brute_force{q};
    const std::optional<Long> feasible = brute_force.nearest(0);
    EXPECT_EQ(choice.is_feasible(), feasible.has_value()) << "question " << i;
    const long double level = feasible ? 0.0L : brute_force.least_violation();
    const std::optional<Long> expected = feasible ? feasible : brute_force.nearest(level + 1e-15L);
    if (!expected) {
      ADD_FAILURE() << "no active set fits question " << i;
      continue;
    }
    d.infeasible += feasible ? 0 : 1;
    const auto apart = static_cast<double>((choice.point.cast<long double>() - *expected).norm());
    d.point = std::fmax(d.point, apart / q.max_length);
    d.violation =
        std::fmax(d.violation, std::fabs(choice.violation - static_cast<double>(level)) / q.max_length);
  }
  return d;
}

TEST(PlaneProgram, AgreesWithEveryActiveSetTriedInLongDouble) {
  const Difference d = from_brute_force(4000, [](std::uint64_t i) { return random_question(i, false); });
  EXPECT_LT(d.point, 1e-10);      // measured 1e-11
  EXPECT_LT(d.violation, 1e-12);  // measured 2e-14
  EXPECT_GT(d.infeasible, 400);
}

TEST(PlaneProgram, AgreesWhenTheFirstFourAreHard) {
  const Difference d = from_brute_force(4000, [](std::uint64_t i) { return random_question(i, true); });
  EXPECT_LT(d.point, 1e-10);      // measured 1e-11
  EXPECT_LT(d.violation, 1e-12);  // measured 2e-14
  EXPECT_GT(d.infeasible, 400);
}

TEST(PlaneProgram, NothingInTheWayGivesTheWantedPointItself) {
  EXPECT_EQ(nearest_in_plane({}, {3.0, -4.0}).point, Vec2(3.0, -4.0));
  EXPECT_LT((nearest_in_plane({.max_length = 2.5}, {3.0, -4.0}).point - Vec2(1.5, -2.0)).norm(), 1e-15);
  EXPECT_EQ(nearest_in_plane({.max_length = 0.0}, {3.0, -4.0}).point, Vec2(0.0, 0.0));
}

TEST(PlaneProgram, OfOpposedHalfPlanesTheMiddleNearestToTheWantedPointIsTaken) {
  // x >= 2 and x <= -1 without a disc: both are violated by 1.5 on the line x = 0.5
  const std::vector<HalfPlane> walls{{{1.0, 0.0}, 2.0}, {{-1.0, 0.0}, 1.0}};
  const PlaneChoice choice = nearest_in_plane({walls}, {7.0, 3.0});
  EXPECT_NEAR(choice.violation, 1.5, 1e-12);
  EXPECT_LT((choice.point - Vec2(0.5, 3.0)).norm(), 1e-12);
}

TEST(PlaneProgram, HardHalfPlanesAreKeptWhateverTheOthersAsk) {
  // x <= 1 is hard, x >= 4 is not: 3 short of it, on the hard line
  const std::vector<HalfPlane> walls{{{-1.0, 0.0}, -1.0}, {{1.0, 0.0}, 4.0}};
  const PlaneChoice choice = nearest_in_plane({walls, 1}, {0.0, 2.0});
  EXPECT_NEAR(choice.violation, 3.0, 1e-12);
  EXPECT_LT((choice.point - Vec2(1.0, 2.0)).norm(), 1e-12);
}

TEST(PlaneProgram, TwoHardHalfPlanesMayLeaveALine) {
  const std::vector<HalfPlane> line{{{0.0, 1.0}, 0.0}, {{0.0, -1.0}, 0.0}, {{1.0, 0.0}, -1.0}};
  const PlaneChoice choice = nearest_in_plane({line, 2}, {-3.0, 5.0});
  EXPECT_TRUE(choice.is_feasible());
  EXPECT_LT((choice.point - Vec2(-1.0, 0.0)).norm(), 1e-14);
}

TEST(PlaneProgram, HardHalfPlanesThatContradictEachOtherAreViolatedLeastAndTheOthersCountStill) {
  // x >= 2 and x <= 0 are hard: 1 short of both on the line x = 1
  std::vector<HalfPlane> walls{{{1.0, 0.0}, 2.0}, {{-1.0, 0.0}, 0.0}};
  const PlaneChoice alone = nearest_in_plane({walls, 2}, {0.0, 0.0});
  EXPECT_NEAR(alone.violation, 1.0, 1e-12);
  EXPECT_LT((alone.point - Vec2(1.0, 0.0)).norm(), 1e-12);
  walls.push_back({{0.0, 1.0}, 50.0});
  const PlaneChoice kept = nearest_in_plane({walls, 2}, {0.0, 0.0});
  EXPECT_NEAR(kept.violation, 1.0, 1e-9);
  EXPECT_LT((kept.point - Vec2(1.0, 50.0)).norm(), 1e-9);
  walls.push_back({{0.0, -1.0}, -40.0});  // y >= 50 and y <= 40 contradict each other too
  const PlaneChoice between = nearest_in_plane({walls, 2}, {0.0, 0.0});
  EXPECT_NEAR(between.violation, 5.0, 1e-9);
  EXPECT_LT((between.point - Vec2(1.0, 45.0)).norm(), 1e-9);
}

TEST(PlaneProgram, RepeatedHalfPlanesChangeNothing) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Question q = random_question(i, true);
    const PlaneChoice once = q.answer();
    for (std::size_t k = q.half_planes.size(); k-- > 4;) q.half_planes.push_back(q.half_planes[k]);
    EXPECT_LT((q.answer().point - once.point).norm(), 1e-9 * q.max_length) << "question " << i;
  }
}

TEST(PlaneProgram, TheOrderOfTheSoftOnesChangesItByRoundingOnly) {
  double largest = 0.0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Question q = random_question(i, true);
    const PlaneChoice before = q.answer();
    std::reverse(q.half_planes.begin() + 4, q.half_planes.end());
    largest = std::fmax(largest, (q.answer().point - before.point).norm() / q.max_length);
  }
  EXPECT_LT(largest, 1e-11);  // measured 3e-14
}

TEST(PlaneProgram, AllocatesNothing) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Question q = random_question(i, true);
    const long before = allocation_count();
    (void)q.answer();
    EXPECT_EQ(allocation_count(), before);
  }
}

}  // namespace
}  // namespace fairway
