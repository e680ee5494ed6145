// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/composite/composite_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "fairway/dynamics/testing/adrift.hpp"

namespace fairway {
namespace {

using fossen::Matrix6;
using fossen::Vector6;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A neutrally buoyant part, anywhere and turned anyhow, balanced about its centre of gravity.
Part random_part(Rng& rng) {
  Part part{.position = random_vector(rng, 1.0), .orientation = random_orientation(rng)};
  SubmergedBodyNumbers& n = part.numbers;
  n.mass = n.displaced_mass = rng.uniform(20.0, 80.0);
  n.r_g = n.r_b = random_vector(rng, 0.1);
  n.inertia.diagonal() << rng.uniform(5, 9), rng.uniform(5, 9), rng.uniform(5, 9);
  for (int i = 0; i < 6; ++i) n.added_mass(i, i) = rng.uniform(1.0, 30.0);
  for (int i = 0; i < 6; ++i) n.linear_damping[i] = rng.uniform(1.0, 10.0);
  for (int i = 0; i < 6; ++i) n.quadratic_damping[i] = rng.uniform(1.0, 50.0);
  return part;
}

std::vector<Part> random_parts(Rng& rng, std::size_t count) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < count; ++i) parts.push_back(random_part(rng));
  return parts;
}

std::vector<Part> without_damping(std::vector<Part> parts) {
  for (Part& part : parts) {
    part.numbers.linear_damping.setZero();
    part.numbers.quadratic_damping.setZero();
  }
  return parts;
}

VehicleState random_state(Rng& rng, DegreesOfFreedom degrees_of_freedom) {
  VehicleState x;
  if (degrees_of_freedom == DegreesOfFreedom::planar) {
    x.q_nb = quaternion_of({.roll = 0, .pitch = 0, .yaw = rng.uniform(-pi, pi)});
    x.v_b = {0.5 * rng.normal(), 0.5 * rng.normal(), 0.0};
    x.omega_b = {0.0, 0.0, 0.2 * rng.normal()};
    return x;
  }
  x.q_nb = random_orientation(rng);
  x.v_b = random_vector(rng, 0.5);
  x.omega_b = random_vector(rng, 0.1);
  return x;
}

Vector6 nu_of(const VehicleState& x) {
  Vector6 nu;
  nu << x.v_b, x.omega_b;
  return nu;
}

double kinetic_energy(const CompositeBody& body, const VehicleState& x) {
  return 0.5 * nu_of(x).dot(body.mass() * nu_of(x));
}

/// P = R M_v nu [N s, NED].
Vec3 momentum(const CompositeBody& body, const VehicleState& x) {
  return x.q_nb * Vec3{body.mass().topRows<3>() * nu_of(x)};
}

constexpr std::array both{DegreesOfFreedom::planar, DegreesOfFreedom::six};

TEST(CompositeBody, OfOnePartAtItsOriginIsASubmergedBody) {
  Rng rng{1};
  for (int i = 0; i < 20; ++i) {
    Part part = random_part(rng);
    part.position.setZero();
    part.orientation.setIdentity();
    part.numbers.r_b.z() -= 0.1;
    part.numbers.displaced_mass += 1.0;
    part.numbers.munk_moment = i % 2 == 0;
    const VehicleState x = random_state(rng, DegreesOfFreedom::six);
    const Water water{.current_n = random_vector(rng, 0.3), .density = 1025.0};
    const Vector6 tau = Vector6::Constant(rng.uniform(-20.0, 20.0));

    const StateRate one = SubmergedBody{part.numbers}.derivative(x, tau, water);
    const StateRate composite = CompositeBody{std::array{part}, {}}.derivative(x, tau, water);
    EXPECT_LT((one.v_b - composite.v_b).norm(), 1e-12);
    EXPECT_LT((one.omega_b - composite.omega_b).norm(), 1e-12);
    EXPECT_LT((one.p_n - composite.p_n).norm(), 1e-14);
    EXPECT_EQ(one.q_nb, composite.q_nb);
    EXPECT_LT((SubmergedBody{part.numbers}.level_restoring() -
               CompositeBody{std::array{part}, {}}.level_restoring())
                  .norm(),
              1e-12);
  }
}

TEST(CompositeBody, MassesOnLeversAddUpAsParallelAxesSay) {
  // 2 kg at x = 3 m and at y = -1 m: Izz = 2 (9 + 1) = 20, their centre at (1.5, -0.5)
  Part point{.position = {3, 0, 0}};
  point.numbers.mass = point.numbers.displaced_mass = 2.0;
  Part other = point;
  other.position = {0, -1, 0};
  const CompositeBody body{std::array{point, other}, {.degrees_of_freedom = DegreesOfFreedom::planar}};
  EXPECT_NEAR(body.mass()(0, 0), 4.0, 1e-14);
  EXPECT_NEAR(body.mass()(5, 5), 20.0, 1e-14);
  EXPECT_NEAR(body.mass()(0, 5), 4.0 * 0.5, 1e-14);  // -m y_g
  EXPECT_NEAR(body.mass()(1, 5), 4.0 * 1.5, 1e-14);  // m x_g
}

TEST(CompositeBody, EachPartDragsWithItsOwnVelocity) {
  Rng rng{2};
  const std::vector<Part> parts = random_parts(rng, 6);
  const CompositeBody body{parts, {}};
  for (int i = 0; i < 50; ++i) {
    const Vector6 nu = nu_of(random_state(rng, DegreesOfFreedom::six));
    Vector6 expected = Vector6::Zero();
    for (const Part& part : parts) {
      const Matrix6 H = velocity_transform(part);
      const Vector6 nu_i = H * nu;
      expected +=
          H.transpose() * part.numbers.quadratic_damping.cwiseProduct(nu_i.cwiseAbs()).cwiseProduct(nu_i);
    }
    EXPECT_LT((body.quadratic_drag(nu) - expected).norm(), 1e-11);  // measured 2e-13
  }
}

TEST(CompositeBody, PlanarIsSixAxesHeldInHeaveRollAndPitch) {
  // the constraint takes up whatever of tau accelerates the held axes
  Rng rng{3};
  const std::vector<Part> parts = random_parts(rng, 4);
  const CompositeBody planar{parts, {.degrees_of_freedom = DegreesOfFreedom::planar}};
  const CompositeBody six{parts, {}};
  const Matrix6 M_inverse = six.mass().inverse();
  const fossen::Matrix3 holding = M_inverse.block<3, 3>(2, 2).inverse();
  for (int i = 0; i < 20; ++i) {
    const VehicleState x = random_state(rng, DegreesOfFreedom::planar);
    const Water water{.current_n = {rng.normal(), rng.normal(), 0.0}, .density = 1000.0};
    Vector6 tau = Vector6::Constant(rng.uniform(-20.0, 20.0));
    const StateRate free = six.derivative(x, tau, water);
    Vector6 unheld;
    unheld << free.v_b, free.omega_b;
    tau.segment<3>(2) -= holding * unheld.segment<3>(2);
    const StateRate held = six.derivative(x, tau, water);
    const StateRate rate = planar.derivative(x, tau, water);
    EXPECT_LT((rate.v_b - held.v_b).norm(), 1e-12);
    EXPECT_LT((rate.omega_b - held.omega_b).norm(), 1e-12);
    EXPECT_LT((rate.p_n - held.p_n).norm(), 1e-14);
    EXPECT_EQ(rate.p_n.z(), 0.0);
  }
}

TEST(CompositeBody, KineticEnergyStaysConstantWithoutDampingWithAndWithoutCoriolis) {
  Rng rng{4};
  for (const DegreesOfFreedom degrees_of_freedom : both) {
    for (const bool coriolis : {true, false}) {
      const Adrift model{CompositeBody{without_damping(random_parts(rng, 5)),
                                       {.degrees_of_freedom = degrees_of_freedom, .coriolis = coriolis}}};
      const VehicleState start = random_state(rng, degrees_of_freedom);
      const VehicleState end = integrated(model, start, 100.0, 0.02);
      const double before = kinetic_energy(model.body, start);
      EXPECT_NEAR(kinetic_energy(model.body, end) / before, 1.0, 1e-9);  // measured 4e-11
    }
  }
}

TEST(CompositeBody, MomentumStaysInPlaceWithCoriolisTermsAndTurnsWithTheBodyWithoutThem) {
  Rng rng{5};
  for (const DegreesOfFreedom degrees_of_freedom : both) {
    const std::vector<Part> parts = without_damping(random_parts(rng, 5));
    const VehicleState start = random_state(rng, degrees_of_freedom);
    for (const bool coriolis : {true, false}) {
      const Adrift model{
          CompositeBody{parts, {.degrees_of_freedom = degrees_of_freedom, .coriolis = coriolis}}};
      const VehicleState end = integrated(model, start, 100.0, 0.02);
      Vec3 before = momentum(model.body, start), after = momentum(model.body, end);
      if (degrees_of_freedom == DegreesOfFreedom::planar) before.z() = after.z() = 0.0;
      const double change = (after - before).norm() / before.norm();
      if (coriolis) {
        EXPECT_LT(change, 1e-9);  // measured 3e-11
      } else {
        EXPECT_GT(change, 0.01);
        EXPECT_LT((nu_of(end) - nu_of(start)).norm(), 1e-12);  // nothing changes nu: it circles
      }
    }
  }
}

TEST(CompositeBody, KineticEnergyNeverGrowsWithDamping) {
  Rng rng{6};
  for (const DegreesOfFreedom degrees_of_freedom : both) {
    for (int run = 0; run < 5; ++run) {
      const Adrift model{CompositeBody{random_parts(rng, 5), {.degrees_of_freedom = degrees_of_freedom}}};
      VehicleState x = random_state(rng, degrees_of_freedom);
      double energy = kinetic_energy(model.body, x);
      for (int step = 0; step < 1000; ++step) {
        x = rk4(model, x, ActuatorValues{}, Water{}, 0.02);
        const double next = kinetic_energy(model.body, x);
        ASSERT_LT(next, energy);
        energy = next;
      }
    }
  }
}

TEST(CompositeBody, PartsGivenForOtherWaterAreBroughtToThatOfTheFirst) {
  Rng rng{8};
  std::vector<Part> parts = random_parts(rng, 2);
  std::vector<Part> doubled = parts;
  parts[1].numbers.density = 500.0;
  doubled[1].numbers.linear_damping *= 2.0;
  doubled[1].numbers.quadratic_damping *= 2.0;
  doubled[1].numbers.displaced_mass *= 2.0;
  const VehicleState x = random_state(rng, DegreesOfFreedom::six);
  const StateRate a = CompositeBody{parts, {}}.derivative(x, Vector6::Zero(), {});
  const StateRate b = CompositeBody{doubled, {}}.derivative(x, Vector6::Zero(), {});
  EXPECT_LT((a.v_b - b.v_b).norm() + (a.omega_b - b.omega_b).norm(), 1e-13);
}

TEST(CompositeBody, RefusesNoPartsAndPartsWithoutInertia) {
  EXPECT_THAT(([] {
                CompositeBody{std::span<const Part>{}, {}};
              }),
              ThrowsMessage<InputError>(HasSubstr("has no parts")));
  EXPECT_THAT(([] {
                CompositeBody{std::array{Part{}}, {}};
              }),
              ThrowsMessage<InputError>(HasSubstr("not positive definite")));
}

}  // namespace
}  // namespace fairway
