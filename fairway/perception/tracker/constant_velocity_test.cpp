// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/constant_velocity.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>

#include "fairway/core/rng.hpp"
#include "fairway/perception/tracker/gate.hpp"

namespace fairway {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

Mat6 whole(const ConstantVelocity& x) {
  Mat6 p;
  p << x.position_covariance, x.cross_covariance, x.cross_covariance.transpose(), x.velocity_covariance;
  return p;
}

double innovation2(const ConstantVelocity& x, const Vec3& z, const Mat3& r) {
  return distance2(z - x.position, x.position_covariance + r, std::numeric_limits<double>::infinity());
}

Mat3 random_covariance(Rng& rng) {
  Mat3 a;
  for (double& entry : a.reshaped()) entry = rng.normal();
  return a * a.transpose() + 0.1 * Mat3::Identity();
}

Vec3 drawn(const Mat3& covariance, Rng& rng) {
  const Vec3 n{rng.normal(), rng.normal(), rng.normal()};
  return covariance.llt().matrixL() * n;
}

ConstantVelocity unknown(double sigma, double speed) {
  return {.position_covariance = sigma * sigma * Mat3::Identity(),
          .velocity_covariance = speed * speed * Mat3::Identity()};
}

TEST(ConstantVelocity, StepsAreThoseOfTheTextbookFilterWithSixStates) {
  Rng rng{1};
  ConstantVelocity x = unknown(2.0, 1.0);
  Vec6 state = Vec6::Zero();
  Mat6 p = whole(x);
  const double t = 0.3;
  const double q = 0.05;
  Mat6 f = Mat6::Identity();
  f.topRightCorner<3, 3>() = t * Mat3::Identity();
  Mat6 noise;
  noise << q * t * t * t / 3 * Mat3::Identity(), q * t * t / 2 * Mat3::Identity(),
      q * t * t / 2 * Mat3::Identity(), q * t * Mat3::Identity();
  Eigen::Matrix<double, 3, 6> h = Eigen::Matrix<double, 3, 6>::Zero();
  h.leftCols<3>() = Mat3::Identity();

  for (int i = 0; i < 50; ++i) {
    const Mat3 r = random_covariance(rng);
    const Vec3 z{rng.normal(), rng.normal(), rng.normal()};
    x = x.predicted(t, q);
    state = f * state;
    p = f * p * f.transpose() + noise;
    const Mat3 s = h * p * h.transpose() + r;
    EXPECT_NEAR(innovation2(x, z, r), (z - h * state).dot(s.inverse() * (z - h * state)), 1e-9);
    const Eigen::Matrix<double, 6, 3> k = p * h.transpose() * s.inverse();
    state += k * (z - h * state);
    p = (Mat6::Identity() - k * h) * p;
    x = x.corrected(z, r);
    EXPECT_LT((whole(x) - p).norm(), 1e-10 * p.norm());
    EXPECT_LT((x.position - state.head<3>()).norm() + (x.velocity - state.tail<3>()).norm(), 1e-10);
  }
}

TEST(ConstantVelocity, InSteadyStateTheGainsAreThoseOfTheAlphaBetaFilter) {
  // with the gains alpha and beta / T, and L^2 = q T^3 / r, the fixed point of the Riccati equation reads
  // beta^2 = L^2 (1 - alpha) and alpha^2 = beta (2 - alpha) - beta^2 / 6
  const double t = 0.5;
  const double q = 0.2;
  const double r = 0.7;
  ConstantVelocity x = unknown(10.0, 10.0);
  for (int i = 0; i < 2000; ++i) x = x.predicted(t, q).corrected(Vec3::Zero(), r * Mat3::Identity());
  const ConstantVelocity before = x.predicted(t, q);
  const double s = before.position_covariance(0, 0) + r;
  const double alpha = before.position_covariance(0, 0) / s;
  const double beta = t * before.cross_covariance(0, 0) / s;
  const double index2 = q * t * t * t / r;
  EXPECT_NEAR(beta * beta, index2 * (1.0 - alpha), 1e-12);
  EXPECT_NEAR(alpha * alpha, beta * (2.0 - alpha) - beta * beta / 6.0, 1e-12);
  EXPECT_TRUE(before.position_covariance.isDiagonal(1e-15));
}

TEST(ConstantVelocity, CovariancesStaySymmetricAndPositiveWhateverTheMeasurements) {
  Rng rng{2};
  ConstantVelocity x = unknown(1e4, 1e2);
  for (int i = 0; i < 5000; ++i) {
    const double scale = std::pow(10.0, rng.uniform(-6, 6));
    x = x.predicted(rng.uniform(0, 2), 1e-4)
            .corrected(drawn(Mat3::Identity(), rng), scale * random_covariance(rng));
    ASSERT_EQ(x.position_covariance, x.position_covariance.transpose());
    ASSERT_EQ(x.velocity_covariance, x.velocity_covariance.transpose());
    const Eigen::SelfAdjointEigenSolver<Mat6> eigen{whole(x)};
    ASSERT_GE(eigen.eigenvalues().minCoeff(), -1e-12 * eigen.eigenvalues().maxCoeff());
  }
}

/// Within these lies, with 95 %, the mean over 500 runs of a chi-square variable: its quantiles of 2.5 % and
/// 97.5 % with 500 times 6 and 500 times 3 degrees of freedom, over 500.
struct Bounds {
  double low;
  double high;

  auto count(const std::vector<double>& means) const {
    return std::ranges::count_if(means, [&](double mean) { return mean >= low && mean <= high; });
  }
};
constexpr Bounds of_six{5.70017, 6.30741};
constexpr Bounds of_three{2.78911, 3.21847};

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(ConstantVelocity, ErrorsAreConsistentWithTheirCovarianceOver500Runs) {
  const int runs = 500;
  const int steps = 60;
  const double t = 1.0 / 15.0;
  const double q = 0.01;
  std::vector<double> nees(steps, 0.0);
  std::vector<double> nis(steps, 0.0);
  for (int run = 0; run < runs; ++run) {
    Rng rng = Rng{3}.stream("run", static_cast<std::uint64_t>(run));
    ConstantVelocity x = unknown(2.0, 1.0);
    Vec3 p = drawn(x.position_covariance, rng);
    Vec3 v = drawn(x.velocity_covariance, rng);
    for (int i = 0; i < steps; ++i) {
      // the exact discrete noise: velocity change w, position change t w / 2 + sqrt(q t^3 / 12) n
      const Vec3 w = std::sqrt(q * t) * drawn(Mat3::Identity(), rng);
      p += t * v + 0.5 * t * w + std::sqrt(q * t * t * t / 12.0) * drawn(Mat3::Identity(), rng);
      v += w;
      const Mat3 r = random_covariance(rng);
      const Vec3 z = p + drawn(r, rng);
      x = x.predicted(t, q);
      nis[i] += innovation2(x, z, r) / runs;
      x = x.corrected(z, r);
      Vec6 error;
      error << p - x.position, v - x.velocity;
      nees[i] += error.dot(whole(x).inverse() * error) / runs;
    }
  }
  // of 60 steps 57 are expected within; of independent ones fewer than 52 has a probability of 1 %
  EXPECT_GE(of_six.count(nees), 52);
  EXPECT_GE(of_three.count(nis), 52);
  EXPECT_GT(mean_of(nees), of_six.low);
  EXPECT_LT(mean_of(nees), of_six.high);
  // innovations are white: those of all steps count
  EXPECT_NEAR(mean_of(nis), 3.0, 2.0 * std::sqrt(2.0 * 3.0 / (runs * steps)));
  RecordProperty("nees", std::to_string(mean_of(nees)));
  RecordProperty("nis", std::to_string(mean_of(nis)));
}

}  // namespace
}  // namespace fairway
