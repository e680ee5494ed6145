// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/submerged_body.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "fairway/dynamics/testing/adrift.hpp"

namespace fairway {
namespace {

using fossen::Matrix6;
using fossen::Vector6;

/// A body with nothing zero and no symmetry: every off-diagonal term takes part.
SubmergedBodyNumbers lopsided() {
  SubmergedBodyNumbers n;
  n.mass = 52.0;
  n.displaced_mass = 52.5;
  n.r_g = {0.03, -0.02, 0.05};
  n.r_b = {-0.01, 0.01, -0.04};
  n.inertia << 0.9, 0.1, -0.2, 0.1, 9.4, 0.3, -0.2, 0.3, 9.5;
  n.added_mass.diagonal() << 2.0, 64.6, 68.5, 0.5, 12.3, 12.3;
  n.added_mass(1, 5) = n.added_mass(5, 1) = 3.0;
  n.added_mass(2, 4) = n.added_mass(4, 2) = -2.0;
  return n;
}

SubmergedBodyNumbers with_damping(SubmergedBodyNumbers n) {
  n.linear_damping << 1.0, 5.0, 6.0, 0.5, 2.0, 2.0;
  n.quadratic_damping << 14.2, 139.0, 126.0, 0.1, 9.44, 9.44;
  return n;
}

VehicleState random_state(Rng& rng) {
  VehicleState x;
  x.p_n = random_vector(rng, 5.0);
  x.q_nb = random_orientation(rng);
  x.v_b = random_vector(rng, 0.5);
  x.omega_b = random_vector(rng, 0.4);
  return x;
}

TEST(Fossen, RigidBodyMassOfAPointMassIsThatOfItsLever) {
  // 2 kg at (0, 0, 3) m: I_xx = I_yy = m z^2 = 18; surge pushes it into pitch by m z = 6, sway into roll by
  // -6
  const Matrix6 M = fossen::rigid_body_mass(2.0, {0.0, 0.0, 3.0}, fossen::Matrix3::Zero());
  Matrix6 expected = Matrix6::Zero();
  expected.diagonal() << 2, 2, 2, 18, 18, 0;
  expected(0, 4) = expected(4, 0) = 6.0;
  expected(1, 3) = expected(3, 1) = -6.0;
  EXPECT_TRUE(M.isApprox(expected, 1e-15)) << M;
}

TEST(Fossen, MassMatrixIsSymmetricPositiveDefinite) {
  const Matrix6 M = SubmergedBody{lopsided()}.mass();
  EXPECT_TRUE(M.isApprox(M.transpose(), 1e-15));
  EXPECT_EQ(M.llt().info(), Eigen::Success);
}

TEST(Fossen, CoriolisMatrixIsSkewSymmetricAndAgreesWithTheCrossProducts) {
  Rng rng{1};
  const Matrix6 M = SubmergedBody{lopsided()}.mass();
  for (int i = 0; i < 100; ++i) {
    Vector6 nu;
    nu << random_vector(rng, 1.0), random_vector(rng, 1.0);
    const Matrix6 C = fossen::coriolis_matrix(M, nu);
    EXPECT_TRUE((C + C.transpose()).isZero(0.0));
    EXPECT_TRUE((C * nu).isApprox(fossen::coriolis_force(M * nu, nu.head<3>(), nu.tail<3>()), 1e-12));
  }
}

TEST(Fossen, CoriolisForcesDoNoWorkWithAndWithoutTheMunkMoment) {
  Rng rng{2};
  for (const bool munk : {true, false}) {
    SubmergedBodyNumbers numbers = lopsided();
    numbers.munk_moment = munk;
    const Matrix6 M = SubmergedBody{numbers}.coriolis_mass();
    for (int i = 0; i < 100; ++i) {
      Vector6 nu;
      nu << random_vector(rng, 1.0), random_vector(rng, 1.0);
      EXPECT_NEAR(nu.dot(fossen::coriolis_force(M * nu, nu.head<3>(), nu.tail<3>())), 0.0, 1e-12);
    }
  }
}

TEST(Fossen, RestoringMomentOfALowCentreOfGravityBringsTheHullUpright) {
  // g is what tau must balance: rolled to starboard by 30 deg the hull rolls back, so g_K = +W z_g sin 30 deg
  const Eigen::Quaterniond q = quaternion_of({.roll = radians(30), .pitch = 0, .yaw = 1.0});
  const Vec3 down_b = q.conjugate() * Vec3::UnitZ();
  const Vector6 g = fossen::restoring(100.0, 100.0, {0, 0, 0.02}, Vec3::Zero(), down_b);
  EXPECT_TRUE(g.head<3>().isZero(1e-12));
  EXPECT_NEAR(g[3], 100.0 * 0.02 * 0.5, 1e-12);
  EXPECT_NEAR(g[4], 0.0, 1e-12);
}

TEST(Fossen, IdealDiskPowerIsForceTimesInducedSpeed) {
  // momentum theory at rest: F = 2 rho A v^2, P = F v; v = 0.5 m/s through 0.01 m2 gives 5 N and 2.5 W
  EXPECT_NEAR(fossen::ideal_disk_power(-5.0, 0.01, 1000.0), 2.5, 1e-12);
}

TEST(SubmergedBody, SolvesTheEquationsWrittenWithFullMatrices) {
  Rng rng{3};
  const SubmergedBodyNumbers n = with_damping(lopsided());
  const SubmergedBody body{n};
  const Water water{.current_n = {0.2, -0.3, 0.1}, .density = 1025.0, .current_rate_n = {0.4, 0.5, -0.6}};
  for (int i = 0; i < 20; ++i) {
    const VehicleState x = random_state(rng);
    Vector6 tau;
    tau << random_vector(rng, 20.0), random_vector(rng, 5.0);
    const StateRate rate = body.derivative(x, tau, water);

    const Eigen::Matrix3d R = x.q_nb.toRotationMatrix();
    const Vec3 v_c = R.transpose() * water.current_n;
    Vector6 nu_r, nu_c_dot;
    nu_r << x.v_b - v_c, x.omega_b;
    nu_c_dot << R.transpose() * water.current_rate_n - fossen::skew(x.omega_b) * v_c, Vec3::Zero();
    const Vector6 drag =
        1.025 * (n.linear_damping + n.quadratic_damping.cwiseProduct(nu_r.cwiseAbs())).cwiseProduct(nu_r);
    const Vector6 g =
        fossen::restoring(52.0 * 9.81, 52.5 * 9.81 * 1.025, n.r_g, n.r_b, R.transpose() * Vec3::UnitZ());
    const Vector6 expected =
        body.mass().llt().solve(tau - fossen::coriolis_matrix(body.mass(), nu_r) * nu_r - drag - g) +
        nu_c_dot;
    EXPECT_LT((rate.v_b - expected.head<3>()).norm(), 1e-12);
    EXPECT_LT((rate.omega_b - expected.tail<3>()).norm(), 1e-12);
    EXPECT_LT((rate.p_n - R * x.v_b).norm(), 1e-14);
  }
}

TEST(SubmergedBody, EnergyStaysConstantWithoutDamping) {
  Rng rng{4};
  for (const bool munk : {true, false}) {
    SubmergedBodyNumbers numbers = lopsided();
    numbers.munk_moment = munk;
    const Adrift model{SubmergedBody{numbers}};
    for (int i = 0; i < 5; ++i) {
      const VehicleState start = random_state(rng);
      const VehicleState end = integrated(model, start, 5.0, 0.002);
      EXPECT_NEAR(model.body.energy(end), model.body.energy(start), 1e-7)
          << "munk " << munk;  // measured 1e-9
    }
  }
}

TEST(SubmergedBody, EnergyNeverGrowsWithDamping) {
  Rng rng{5};
  const Adrift model{SubmergedBody{with_damping(lopsided())}};
  for (int i = 0; i < 10; ++i) {
    VehicleState x = random_state(rng);
    double energy = model.body.energy(x);
    for (int step = 0; step < 500; ++step) {
      x = rk4(model, x, ActuatorValues{}, Water{}, 0.01);
      const double next = model.body.energy(x);
      ASSERT_LE(next, energy + 1e-9);
      energy = next;
    }
  }
}

TEST(SubmergedBody, MomentumOfBodyAndWaterIsConservedWhereNothingPulls) {
  Rng rng{6};
  SubmergedBodyNumbers numbers = lopsided();
  numbers.displaced_mass = numbers.mass;
  numbers.r_b = numbers.r_g;
  const Adrift model{SubmergedBody{numbers}};
  const auto momenta = [&](const VehicleState& x) {
    Vector6 nu;
    nu << x.v_b, x.omega_b;
    const Vector6 h = model.body.mass() * nu;
    Vector6 ned;
    ned.head<3>() = x.q_nb * Vec3{h.head<3>()};
    ned.tail<3>() = x.q_nb * Vec3{h.tail<3>()} + x.p_n.cross(Vec3{ned.head<3>()});
    return ned;
  };
  for (int i = 0; i < 5; ++i) {
    const VehicleState start = random_state(rng);
    const VehicleState end = integrated(model, start, 5.0, 0.002);
    EXPECT_LT((momenta(end) - momenta(start)).norm(), 1e-7);
  }
}

TEST(SubmergedBody, RungeKuttaConvergesWithOrderFour) {
  Rng rng{7};
  const Adrift model{SubmergedBody{lopsided()}};
  const Water water{.current_n = {0.2, -0.3, 0.1}, .density = 1000.0};
  const VehicleState start = random_state(rng);
  const auto error = [&](double h) {
    static const VehicleState exact = integrated(model, start, 2.0, 0.00125, water);
    const VehicleState x = integrated(model, start, 2.0, h, water);
    return (x.p_n - exact.p_n).norm() + (x.v_b - exact.v_b).norm() + (x.omega_b - exact.omega_b).norm();
  };
  const double order = std::log2(error(0.02) / error(0.01));
  EXPECT_NEAR(order, 4.0, 0.2);
}

TEST(SubmergedBody, AtRestInACurrentItIsCarriedAlongAsTheClosedFormSays) {
  // (m + A) u_r' = -d u_r |u_r| from u_r(0) = -V: u_r = -V / (1 + d V t / (m + A))
  SubmergedBodyNumbers numbers;
  numbers.mass = numbers.displaced_mass = 52.0;
  numbers.inertia = Vec3{0.5, 9.4, 9.5}.asDiagonal();
  numbers.added_mass(0, 0) = 2.0;
  numbers.quadratic_damping[0] = 14.2;
  const double V = 0.4, t = 120.0;
  const VehicleState x =
      integrated(Adrift{SubmergedBody{numbers}}, {}, t, 0.05, {.current_n = {V, 0, 0}, .density = 1000.0});
  EXPECT_NEAR(x.v_b.x(), V - V / (1.0 + 14.2 * V * t / 54.0), 1e-8);
}

TEST(SubmergedBody, QuaternionStaysUnit) {
  Rng rng{8};
  const Adrift model{SubmergedBody{lopsided()}};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(integrated(model, random_state(rng), 20.0, 0.05).q_nb.norm(), 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace fairway
