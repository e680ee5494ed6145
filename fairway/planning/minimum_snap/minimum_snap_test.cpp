// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/minimum_snap/minimum_snap.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "fairway/core/error.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/planning/testing/four_obstacles.hpp"

namespace fairway {
namespace {

struct Course {
  std::vector<Vec2> waypoints;
  std::vector<double> durations;
};

/// A random walk; durations spread over a factor of `spread`.
Course wandering(int count, double spread, Rng rng) {
  Course course{.waypoints = {{3.0, -2.0}}};
  for (int i = 1; i < count; ++i) {
    course.waypoints.push_back(course.waypoints.back() + Vec2{rng.uniform(-5, 5), rng.uniform(-5, 5)});
    course.durations.push_back(10.0 * std::pow(spread, rng.uniform(-0.5, 0.5)));
  }
  return course;
}

/// The largest jump of a derivative at an inner knot, by the largest value of it at any knot.
double largest_jump(const Trajectory& trajectory, int order) {
  double jump = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < trajectory.segments().size(); ++i) {
    const Vec2 end = trajectory.derivative(i, order, 1.0);
    scale = std::fmax(scale, end.norm());
    if (i + 1 == trajectory.segments().size()) break;
    const Vec2 begin = trajectory.derivative(i + 1, order, 0.0);
    jump = std::fmax(jump, (begin - end).norm());
  }
  return jump / scale;
}

TEST(MinimumSnap, OneSegmentFromRestToRestIsTheSepticSmoothstep) {
  // x = d (35 s^4 - 84 s^5 + 70 s^6 - 20 s^7), with integral of squared snap 100800 d^2 / T^7 and
  // greatest speed 35/16 d / T at the middle
  const std::vector<Vec2> waypoints{{1, 2}, {4, 6}};
  const std::vector<double> durations{7.0};
  const Trajectory trajectory = minimum_snap(waypoints, durations);
  for (const double s : {0.0, 0.1, 0.5, 0.8, 1.0}) {
    const double x = 35 * std::pow(s, 4) - 84 * std::pow(s, 5) + 70 * std::pow(s, 6) - 20 * std::pow(s, 7);
    EXPECT_LT((trajectory.sample(7.0 * s).position - Vec2(1 + 3 * x, 2 + 4 * x)).norm(), 1e-13);
  }
  EXPECT_NEAR(trajectory.snap_integral(), 100800.0 * 25.0 / std::pow(7.0, 7), 1e-9);
  EXPECT_NEAR(trajectory.sample(3.5).velocity.norm(), 35.0 / 16 * 5 / 7, 1e-13);
  EXPECT_NEAR(trajectory.peak_speed(), 35.0 / 16 * 5 / 7, 1e-5);
}

TEST(MinimumSnap, PassesItsWaypointsOnTimeAndRestsAtItsEnds) {
  for (const int count : {2, 3, 4, 11, 60}) {
    const Course course = wandering(count, 9.0, Rng{5}.stream("walk", static_cast<std::uint64_t>(count)));
    const Trajectory trajectory = minimum_snap(course.waypoints, course.durations);
    double time = 0.0;
    for (std::size_t i = 0; i < course.waypoints.size(); ++i) {
      EXPECT_LT((trajectory.sample(time).position - course.waypoints[i]).norm(), 1e-10);
      if (i < course.durations.size()) time += course.durations[i];
    }
    EXPECT_DOUBLE_EQ(trajectory.duration(), time);
    const double pace = trajectory.peak_speed();
    for (int order = 1; order <= 3; ++order) {
      EXPECT_LT(trajectory.derivative(0, order, 0.0).norm(), 1e-12 * pace);
      EXPECT_LT(trajectory.derivative(trajectory.segments().size() - 1, order, 1.0).norm(), 1e-10 * pace);
    }
  }
}

TEST(MinimumSnap, DerivativesAreContinuousInPhysicalTimeWithUnequalDurations) {
  for (const int count : {3, 4, 11, 60}) {
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Course course = wandering(count, 9.0, Rng{6}.stream("walk", i));
      const Trajectory trajectory = minimum_snap(course.waypoints, course.durations);
      // durations spread over a factor of 9; measured 2e-12 up to order 3, 2e-11 up to order 6
      for (int order = 0; order <= 6; ++order) EXPECT_LT(largest_jump(trajectory, order), 1e-9) << order;
      EXPECT_GT(largest_jump(trajectory, 7), 1e-3);
    }
  }
}

TEST(MinimumSnap, NoOtherRatesAtTheWaypointsGiveLessSnap) {
  // the same waypoints and times, with velocity, acceleration and jerk at the inner waypoints changed by
  // a little or a lot: each change adds a bump to two segments
  for (std::uint64_t i = 0; i < 30; ++i) {
    Rng rng = Rng{7}.stream("walk", i);
    const Course course = wandering(7, 4.0, rng);
    const Trajectory best = minimum_snap(course.waypoints, course.durations);
    const double least = best.snap_integral();
    for (int trial = 0; trial < 30; ++trial) {
      std::vector<Trajectory::Segment> changed{best.segments().begin(), best.segments().end()};
      const auto knot = 1 + rng.index(changed.size() - 1);
      const double size = std::pow(10.0, rng.uniform(-3, 0));
      const Eigen::Matrix<double, 2, 3> change =
          size * Eigen::Matrix<double, 2, 3>::NullaryExpr([&] { return rng.normal(); });
      // on both sides of the knot the polynomial with this data there and none at its other end, by a dense
      // solver
      for (const bool is_before : {true, false}) {
        Trajectory::Segment& segment = changed[is_before ? knot - 1 : knot];
        Eigen::Matrix<double, 8, 8> data = Eigen::Matrix<double, 8, 8>::Zero();
        Eigen::Matrix<double, 8, 2> values = Eigen::Matrix<double, 8, 2>::Zero();
        for (int order = 0; order < 4; ++order) {
          for (int k = order; k < 8; ++k) {
            double product = 1.0;
            for (int j = 0; j < order; ++j) product *= k - j;
            data(order, k) = k == order ? product : 0.0;
            data(4 + order, k) = product;
          }
          if (order == 0) continue;
          values.row((is_before ? 4 : 0) + order) =
              std::pow(segment.duration, order) * change.col(order - 1).transpose();
        }
        segment.coefficients += data.fullPivLu().solve(values).transpose();
      }
      const Trajectory other{changed};
      for (int order = 0; order <= 3; ++order) ASSERT_LT(largest_jump(other, order), 1e-9);
      EXPECT_GE(other.snap_integral(), least * (1 - 1e-12));
    }
  }
}

TEST(MinimumSnap, RestToRestSegmentsStayOnTheStraightLines) {
  const Course course = wandering(6, 4.0, Rng{8});
  const Trajectory trajectory = minimum_snap(course.waypoints, course.durations, Joining::rest_to_rest);
  for (std::size_t i = 0; i < course.durations.size(); ++i) {
    const Vec2 a = course.waypoints[i], ab = course.waypoints[i + 1] - a;
    for (int order = 1; order <= 3; ++order) {
      EXPECT_LT(trajectory.derivative(i, order, 0.0).norm(), 1e-12);
      EXPECT_LT(trajectory.derivative(i, order, 1.0).norm(), 1e-12);
    }
    for (const double s : {0.1, 0.4, 0.9}) {
      const Vec2 p = trajectory.derivative(i, 0, s) - a;
      EXPECT_NEAR(p.x() * ab.y() - p.y() * ab.x(), 0.0, 1e-12);
    }
  }
}

TEST(MinimumSnap, WhereTheOriginIsDoesNotMatter) {
  const Course course = wandering(11, 4.0, Rng{9});
  std::vector<Vec2> shifted = course.waypoints;
  for (Vec2& p : shifted) p += Vec2{4.6e6, 5e5};
  const Trajectory here = minimum_snap(course.waypoints, course.durations);
  const Trajectory there = minimum_snap(shifted, course.durations);
  for (int i = 0; i <= 50; ++i) {
    const double time = here.duration() * i / 50;
    const Vec2 change = there.sample(time).position - here.sample(time).position - Vec2{4.6e6, 5e5};
    EXPECT_LT(change.norm(), 1e-7);  // positions are good to 1e-9 m there; measured 1e-9
  }
}

TEST(MinimumSnap, IsWellConditioned) {
  const auto worst = [](int count, double spread) {
    double condition = 1.0;
    for (std::uint64_t i = 0; i < 20; ++i) {
      condition = std::fmax(
          condition, minimum_snap_condition(wandering(count, spread, Rng{6}.stream("walk", i)).durations));
    }
    return condition;
  };
  EXPECT_LT(worst(60, 1.0), 1e3);  // measured 3.4e2; the 8 unknowns a segment of the paper: 1e4 .. 2e8
  EXPECT_LT(worst(60, 9.0), 1e5);  // measured 2e4
  EXPECT_LT(worst(60, 1e2), 3e7);  // measured 7e6
}

TEST(MinimumSnap, RefusesWhatIsNoTrajectory) {
  const std::vector<Vec2> one{{0, 0}}, two{{0, 0}, {1, 0}}, twice{{0, 0}, {1, 0}, {1, 0}};
  const std::vector<Vec2> nowhere{{0, 0}, {std::nan(""), 0}};
  const std::vector<double> none, second{1.0}, seconds{1.0, 1.0}, instant{0.0}, nan{std::nan("")};
  EXPECT_THROW(minimum_snap(one, none), InputError);
  EXPECT_THROW(minimum_snap(two, seconds), InputError);
  EXPECT_THROW(minimum_snap(nowhere, second), InputError);
  EXPECT_THROW(minimum_snap(two, instant), InputError);
  EXPECT_THROW(minimum_snap(two, nan), InputError);
  EXPECT_EQ(refusal_by([&] { (void)minimum_snap(twice, seconds); }),
            "waypoints[2] is where the one before it is: a segment must have a length");
}

TEST(Paced, SpeedAndAccelerationJustReachTheirLimits) {
  const std::vector<Vec2> waypoints = four_obstacles::published_waypoints();
  const Trajectory raw = minimum_snap(waypoints, durations_by_length(waypoints));
  const Trajectory by_speed = paced(raw, {.max_speed_mps = 0.3, .max_acceleration_mps2 = 10.0});
  EXPECT_NEAR(by_speed.peak_speed(), 0.3, 1e-6);
  EXPECT_LT(by_speed.peak_acceleration(), 10.0);
  const Trajectory by_force = paced(raw, {.max_speed_mps = 10.0, .max_acceleration_mps2 = 0.01});
  EXPECT_NEAR(by_force.peak_acceleration(), 0.01, 1e-7);
  EXPECT_LT(by_force.peak_speed(), 10.0);
  // the way is the same
  EXPECT_NEAR(by_speed.length(), raw.length(), 1e-9);
  EXPECT_THROW(paced(raw, {.max_speed_mps = 0.0, .max_acceleration_mps2 = 1.0}), InputError);
}

TEST(Paced, NoSampleExceedsThePeaks) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Course course = wandering(8, 4.0, Rng{10}.stream("walk", i));
    const Trajectory trajectory = minimum_snap(course.waypoints, course.durations);
    double speed = 0.0, acceleration = 0.0;
    for (int k = 0; k <= 20000; ++k) {
      const TrajectorySample sample = trajectory.sample(trajectory.duration() * k / 20000);
      speed = std::fmax(speed, sample.velocity.norm());
      acceleration = std::fmax(acceleration, sample.acceleration.norm());
    }
    EXPECT_LE(speed, trajectory.peak_speed());
    EXPECT_LE(acceleration, trajectory.peak_acceleration());
    EXPECT_GT(speed, (1 - 1e-4) * trajectory.peak_speed());
    EXPECT_GT(acceleration, (1 - 1e-4) * trajectory.peak_acceleration());
  }
}

TEST(Trajectory, RestsBeforeItBeginsAndAfterItEnds) {
  const std::vector<Vec2> waypoints{{1, 2}, {4, 6}};
  const std::vector<double> durations{7.0};
  const Trajectory trajectory = minimum_snap(waypoints, durations);
  EXPECT_EQ(trajectory.sample(-1.0).position, Vec2(1, 2));
  EXPECT_LT((trajectory.sample(1e9).position - Vec2(4, 6)).norm(), 1e-13);
  EXPECT_EQ(trajectory.sample(1e9).velocity, Vec2(0, 0));
  EXPECT_EQ(Trajectory(Vec2(5, 5)).sample(3.0).position, Vec2(5, 5));
  EXPECT_EQ(Trajectory(Vec2(5, 5)).duration(), 0.0);
}

TEST(Trajectory, ItsDerivativesAreThoseOfThePositions) {
  const Course course = wandering(5, 4.0, Rng{12});
  const Trajectory trajectory = minimum_snap(course.waypoints, course.durations);
  const double h = 1e-3;
  for (int i = 1; i < 40; ++i) {
    const double time = trajectory.duration() * i / 40.37;
    const TrajectorySample before = trajectory.sample(time - h), after = trajectory.sample(time + h);
    const TrajectorySample at = trajectory.sample(time);
    EXPECT_LT(((after.position - before.position) / (2 * h) - at.velocity).norm(), 1e-6);
    EXPECT_LT(((after.velocity - before.velocity) / (2 * h) - at.acceleration).norm(), 1e-6);
    EXPECT_LT(((after.acceleration - before.acceleration) / (2 * h) - at.jerk).norm(), 1e-6);
    EXPECT_LT(((after.jerk - before.jerk) / (2 * h) - at.snap).norm(), 1e-5);
  }
}

TEST(Bezier, LiesInTheHullOfItsControlPoints) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    Rng rng = Rng{13}.stream("curve", i);
    Bezier::Points powers(2, static_cast<Eigen::Index>(1 + rng.index(8)));
    powers = powers.NullaryExpr(powers.rows(), powers.cols(), [&] { return rng.normal(); });
    const Bezier curve = Bezier::from_powers(powers);
    const auto [left, right] = curve.halves();
    const auto at = [&](double s) {
      Vec2 sum = Vec2::Zero();
      for (Eigen::Index k = powers.cols(); k-- > 0;) sum = s * sum + powers.col(k);
      return sum;
    };
    EXPECT_LT((curve.first() - at(0.0)).norm(), 1e-13);
    EXPECT_LT((curve.last() - at(1.0)).norm(), 1e-13);
    EXPECT_LT((left.last() - at(0.5)).norm(), 1e-13);
    EXPECT_LT((right.halves().first.last() - at(0.75)).norm(), 1e-13);
    for (int k = 0; k <= 100; ++k) {
      EXPECT_LE(at(k / 100.0).norm(), curve.norm_bound() + 1e-13);
      EXPECT_LE((at(k / 200.0) - Vec2(1, 2)).norm(), left.reach({1, 2}) + 1e-13);
    }
  }
}

}  // namespace
}  // namespace fairway
