// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/thrust_allocator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"
#include "fairway/dynamics/catalog.hpp"

namespace fairway {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Thrusters as they come: a configuration and asymmetric limits.
struct Rig {
  Propulsion propulsion;
  std::vector<ActuatorInfo> actuators;

  ThrustAllocator allocator(AllocationMethod method = AllocationMethod::bounded) const {
    return {propulsion, actuators, method};
  }
  Wrench given(const ActuatorValues& u) const { return propulsion.effectiveness * u; }
};

Rig random_rig(Rng& rng, Eigen::Index thrusters, int axes) {
  Rig rig;
  rig.propulsion.effectiveness.setZero(6, thrusters);
  for (Eigen::Index i = 0; i < thrusters; ++i) {
    for (int k = 0; k < axes; ++k) rig.propulsion.effectiveness(5 - k, i) = rng.normal();
    rig.actuators.push_back({.name = "thruster_n", .range = {-rng.uniform(5, 50), rng.uniform(5, 100)}});
  }
  return rig;
}

Rig rig_of(const Vehicle& vehicle) {
  return {*vehicle.propulsion(), {vehicle.actuators().begin(), vehicle.actuators().end()}};
}

Wrench random_wrench(Rng& rng, double size) {
  Wrench tau;
  for (double& axis : tau) axis = size * rng.normal();
  return tau;
}

double error(const Rig& rig, const Wrench& weights, const ActuatorValues& u, const Wrench& tau) {
  return weights.cwiseProduct(rig.given(u) - tau).norm();
}

/// The least error over every way to hold thrusters low, high or let them go.
double least_error(const Rig& rig, const Wrench& weights, const Wrench& tau) {
  const Eigen::MatrixXd WB = weights.asDiagonal() * Eigen::MatrixXd{rig.propulsion.effectiveness};
  const auto n = static_cast<Eigen::Index>(rig.actuators.size());
  const int ways = static_cast<int>(std::lround(std::pow(3.0, static_cast<double>(n))));
  double least = 1e300;
  for (int way = 0; way < ways; ++way) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(n);
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0, rest = way; i < n; ++i, rest /= 3) {
      const Range range = rig.actuators[static_cast<std::size_t>(i)].range;
      if (rest % 3 == 0)
        free.push_back(i);
      else
        u[i] = rest % 3 == 1 ? range.lo : range.hi;
    }
    if (!free.empty()) {
      const Eigen::VectorXd x = WB(Eigen::all, free)
                                    .completeOrthogonalDecomposition()
                                    .solve(Eigen::VectorXd{weights.cwiseProduct(tau)} - WB * u);
      for (std::size_t k = 0; k < free.size(); ++k) u[free[k]] = x[static_cast<Eigen::Index>(k)];
    }
    bool feasible = true;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Range range = rig.actuators[static_cast<std::size_t>(i)].range;
      feasible &= u[i] >= range.lo - 1e-9 && u[i] <= range.hi + 1e-9;
    }
    if (feasible) least = std::fmin(least, error(rig, weights, u, tau));
  }
  return least;
}

TEST(ThrustAllocator, BoundedFindsTheLeastErrorOfAllActiveSets) {
  Rng rng{1};
  for (int i = 0; i < 300; ++i) {
    const Rig rig = random_rig(rng, 3 + i % 4, 2 + i % 5);
    const ThrustAllocator allocator = rig.allocator();
    const Wrench tau = random_wrench(rng, rng.uniform(5.0, 300.0));
    const double found = error(rig, allocator.weights(), allocator.allocate(tau), tau);
    const double least = least_error(rig, allocator.weights(), tau);
    EXPECT_LT(found - least, 1e-6 * (1.0 + least));  // measured 3e-8: what epsilon costs
  }
}

TEST(ThrustAllocator, BoundedMeetsTheConditionsOfKarushKuhnAndTucker) {
  Rng rng{2};
  for (int i = 0; i < 2000; ++i) {
    const Rig rig = random_rig(rng, 1 + i % max_actuators, 1 + i % 6);
    const ThrustAllocator allocator = rig.allocator();
    const Wrench tau = random_wrench(rng, rng.uniform(5.0, 1000.0));
    const ActuatorValues u = allocator.allocate(tau);
    const Wrench W = allocator.weights();
    const Eigen::MatrixXd WB = W.asDiagonal() * Eigen::MatrixXd{rig.propulsion.effectiveness};
    const double epsilon = 1e-12 * WB.squaredNorm();
    const Eigen::VectorXd gradient =
        WB.transpose() * W.cwiseProduct(rig.given(u) - tau) + epsilon * Eigen::VectorXd{u};
    const double tolerance = 1e-10 * WB.norm() * W.cwiseProduct(tau).norm();  // measured 1e-11
    for (Eigen::Index k = 0; k < u.size(); ++k) {
      const Range range = rig.actuators[static_cast<std::size_t>(k)].range;
      ASSERT_GE(u[k], range.lo);
      ASSERT_LE(u[k], range.hi);
      ASSERT_TRUE(u[k] == range.lo || gradient[k] < tolerance) << i;
      ASSERT_TRUE(u[k] == range.hi || gradient[k] > -tolerance) << i;
    }
  }
}

TEST(ThrustAllocator, BoundedIsThePseudoInverseWhereNoLimitIsMet) {
  Rng rng{3};
  for (int i = 0; i < 200; ++i) {
    const Rig rig = random_rig(rng, 6 + i % 15, 6);
    const Wrench tau = random_wrench(rng, 0.3);
    const ActuatorValues bounded = rig.allocator().allocate(tau);
    const ActuatorValues inverse = rig.allocator(AllocationMethod::pseudo_inverse).allocate(tau);
    EXPECT_LT((rig.given(bounded) - tau).norm(), 1e-10);
    EXPECT_LT((bounded - inverse).norm(), 1e-9);
  }
}

TEST(ThrustAllocator, BoundedGivesWhatThePseudoInverseSaturatesAt) {
  // 600 N ahead: the least-norm share of vehicle 2, astern, exceeds its reverse thrust of 76 N
  const Rig rig = rig_of(builtin_vehicles().make("minerva_transport"));
  Wrench tau = Wrench::Zero();
  tau[0] = 600.0;
  const Wrench inverse = rig.given(rig.allocator(AllocationMethod::pseudo_inverse).allocate(tau));
  const Wrench bounded = rig.given(rig.allocator().allocate(tau));
  EXPECT_LT(inverse[0], 540.0);  // measured 539.8
  EXPECT_GT(inverse[5], 40.0);   // and turns it: measured 40.3 N m that nobody asked for
  EXPECT_LT((bounded - tau).norm(), 1e-6);
}

TEST(ThrustAllocator, YawIsServedFirstWhereNotAllCanBe) {
  const Rig rig = rig_of(builtin_vehicles().make("minerva_transport"));
  Wrench tau = Wrench::Zero();
  tau[0] = 2000.0;
  tau[5] = 400.0;
  const Wrench given = rig.given(rig.allocator().allocate(tau));
  EXPECT_NEAR(given[5], 400.0, 1e-6);
  EXPECT_NEAR(given[0], 778.4, 0.1);  // all the surge there is

  tau[5] = 800.0;
  const Wrench contested = rig.given(rig.allocator().allocate(tau));
  EXPECT_NEAR(contested[5], 800.0, 5.0);  // measured 796.6
  EXPECT_NEAR(contested[0], 770.0, 10.0);
}

TEST(ThrustAllocator, DeadThrustersAndAxesWithoutThrustersAreLeftAtZero) {
  Rng rng{4};
  Rig rig = random_rig(rng, 6, 3);
  rig.actuators[2].range = {0.0, 0.0};
  const ThrustAllocator allocator = rig.allocator();
  for (int i = 0; i < 100; ++i) {
    Wrench tau = random_wrench(rng, 100.0);
    tau[0] = std::nan("");
    tau[1] = 1e300;
    const ActuatorValues u = allocator.allocate(tau);
    EXPECT_TRUE(u.allFinite());
    EXPECT_EQ(u[2], 0.0);
    EXPECT_TRUE(rig.given(u).head<3>().isZero(0.0));
    tau.head<3>().setZero();
    EXPECT_LT((allocator.allocate(tau) - u).norm(), 1e-9);
  }
  EXPECT_TRUE(allocator.allocate(Wrench::Constant(1e300)).allFinite());
}

TEST(ThrustAllocator, SameWrenchGivesTheSameBitsWithoutAllocating) {
  const Rig rig = rig_of(builtin_vehicles().make("minerva_transport"));
  const ThrustAllocator allocator = rig.allocator();
  const ThrustAllocator copy = allocator;
  Rng rng{5};
  for (int i = 0; i < 100; ++i) {
    const Wrench tau = random_wrench(rng, 1000.0);
    const long before = allocation_count();
    const ActuatorValues u = allocator.allocate(tau);
    EXPECT_EQ(allocation_count(), before);
    EXPECT_EQ(u, copy.allocate(tau));
  }
}

TEST(ThrustAllocator, RefusesAnotherNumberOfActuators) {
  Rng rng{6};
  Rig rig = random_rig(rng, 4, 3);
  rig.actuators.pop_back();
  EXPECT_THAT([&] { (void)rig.allocator(); },
              ThrowsMessage<InputError>(HasSubstr("has 4 columns for 3 actuators")));
}

}  // namespace
}  // namespace fairway
