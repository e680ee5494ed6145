// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/cma_es.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace fairway {
namespace {

using Function = std::function<double(const Eigen::VectorXd&)>;

/// Evaluations until `f` is below `goal`, or `most`.
int evaluations_until(const Function& f, Eigen::VectorXd start, double goal, int most, std::uint64_t seed) {
  CmaEs search{start, 0.3};
  Rng rng{seed};
  for (int spent = 0; spent < most;) {
    std::vector<Eigen::VectorXd> points;
    for (std::size_t i = 0; i < search.population(); ++i) points.push_back(search.ask(rng));
    spent += static_cast<int>(points.size());
    std::ranges::sort(points, {}, f);
    if (f(points.front()) < goal) return spent;
    search.tell(points);
  }
  return most;
}

const Eigen::VectorXd optimum = Eigen::VectorXd::Constant(5, 0.6);

double sphere(const Eigen::VectorXd& x) { return (x - optimum).squaredNorm(); }

double ellipsoid(const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double scale = std::pow(1000.0, static_cast<double>(i) / static_cast<double>(x.size() - 1));
    sum += std::pow(scale * (x[i] - optimum[i]), 2);
  }
  return sum;
}

/// The valley of Rosenbrock, its optimum at 0.75 in every coordinate.
double rosenbrock(const Eigen::VectorXd& place) {
  const Eigen::VectorXd x = 4.0 * place - Eigen::VectorXd::Constant(place.size(), 2.0);
  double sum = 0.0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i)
    sum += 100.0 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1.0 - x[i], 2);
  return sum;
}

TEST(CmaEs, FindsTheBottomOfBowlsLongValleysAndBentOnes) {
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(5, 0.2);
  EXPECT_LT(evaluations_until(sphere, start, 1e-9, 5000, 1), 1000);
  EXPECT_LT(evaluations_until(ellipsoid, start, 1e-9, 20000, 1), 4000);
  EXPECT_LT(evaluations_until(rosenbrock, start, 1e-9, 30000, 1), 8000);
}

TEST(CmaEs, OnlyTheOrderOfValuesCounts) {
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(5, 0.2);
  const Function bent = [](const Eigen::VectorXd& x) { return std::sqrt(sphere(x)); };
  EXPECT_EQ(evaluations_until(sphere, start, 1e-8, 5000, 3), evaluations_until(bent, start, 1e-4, 5000, 3));
}

TEST(CmaEs, StaysInTheBoxAlsoWhereTheBestPlaceIsACorner) {
  const Function corner = [](const Eigen::VectorXd& x) { return x.sum(); };
  EXPECT_LT(evaluations_until(corner, Eigen::VectorXd::Constant(3, 0.5), 1e-6, 3000, 2), 3000);
  CmaEs search{Eigen::VectorXd::Constant(3, 0.01), 2.0};
  Rng rng{4};
  for (int i = 0; i < 1000; ++i) {
    const Eigen::VectorXd point = search.ask(rng);
    EXPECT_GE(point.minCoeff(), 0.0);
    EXPECT_LE(point.maxCoeff(), 1.0);
  }
}

TEST(CmaEs, WorksInOneDimension) {
  const Function f = [](const Eigen::VectorXd& x) { return (x[0] - 0.3) * (x[0] - 0.3); };
  EXPECT_LT(evaluations_until(f, Eigen::VectorXd::Constant(1, 0.9), 1e-12, 2000, 1), 400);
}

}  // namespace
}  // namespace fairway
