// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/zarco/zarco.hpp"

#include <gtest/gtest.h>

#include "fairway/dynamics/testing/held_actuators.hpp"

namespace fairway {
namespace {

/// By thrusts of port and starboard [N].
VehicleState driven(const Leg& leg, const Water& water = {}, const VehicleState& start = {}) {
  Vehicle vehicle{Zarco{{}}};
  vehicle.set_state(start);
  return driven(vehicle, {leg}, water);
}

double tilt_energy(const Zarco& zarco, const VehicleState& x) {
  const Hydrostatics& h = zarco.hydrostatics();
  const Vec3 d = fossen::rotation(x.q_nb).row(2).transpose();
  return zarco.body().energy(x) +
         0.5 * (h.heave * x.p_n.z() * x.p_n.z() + h.roll * d.y() * d.y() + h.pitch * d.x() * d.x());
}

TEST(Zarco, KeepsThePublishedLimitsAtTheSameTime) {
  // 37.5 N each hold 1.5 m/s: 20 * 1.5 + 20 * 1.5^2 = 75 N
  EXPECT_NEAR(driven({60.0, {37.5, 37.5}}).v_b.x(), 1.5, 1e-6);
  // +-12.9 N hold 0.3751 rad/s: 20 * 0.3751 + 20 * 0.3751^2 = 10.316 N m = 0.8 m * 12.895 N
  EXPECT_NEAR(driven({60.0, {12.895, -12.895}}).omega_b.z(), 0.3751, 1e-4);
  EXPECT_LT(37.5 + 12.895, Zarco{{}}.actuators()[0].range.hi);
}

TEST(Zarco, FloatsAtRestAndComesBackLevel) {
  EXPECT_EQ(driven({10.0, {0, 0}}).p_n, Vec3(0, 0, 0));
  VehicleState tipped;
  tipped.p_n.z() = 0.1;
  tipped.q_nb = quaternion_of({.roll = 0.3, .pitch = -0.2});
  const VehicleState x = driven({20.0, {0, 0}}, {}, tipped);
  EXPECT_NEAR(x.p_n.z(), 0.0, 1e-6);
  EXPECT_NEAR(euler_of(x.q_nb).roll, 0.0, 1e-6);
  EXPECT_NEAR(euler_of(x.q_nb).pitch, 0.0, 1e-6);
}

TEST(Zarco, LiesOnTheSlopeOfAWave) {
  // the surface 0.1 m high, rising northwards by 2 % and eastwards by 1 %
  const Water water{.elevation = 0.1, .slope_n = {0.02, 0.01}};
  const VehicleState x = driven({20.0, {0, 0}}, water);
  EXPECT_NEAR(x.p_n.z(), -0.1, 1e-6);
  EXPECT_NEAR(euler_of(x.q_nb).pitch, 0.02, 1e-4);  // bow up
  EXPECT_NEAR(euler_of(x.q_nb).roll, -0.01, 1e-4);  // starboard up
}

TEST(Zarco, EnergyIsKeptByHydrostaticsAndLostToDamping) {
  const Zarco zarco{{}};
  VehicleState tipped;
  tipped.p_n.z() = 0.2;
  tipped.q_nb = quaternion_of({.roll = 0.5, .pitch = 0.4});

  // without damping the wrench is that of the potential: power in = -d(potential)/dt
  VehicleState moving = tipped;
  moving.v_b = {0.3, -0.2, 0.4};
  moving.omega_b = {0.2, -0.3, 0.1};
  fossen::Vector6 nu;
  nu << moving.v_b, moving.omega_b;
  const double power = nu.dot(zarco.hydrostatics().wrench(moving, {}));
  const auto potential = [&](double t) {
    StateRate rate;
    rate.p_n = moving.v_n();
    rate.q_nb = fossen::quaternion_rate(moving.q_nb, moving.omega_b);
    VehicleState later = moved(moving, rate, t);
    later.q_nb.normalize();
    later.v_b = later.omega_b = Vec3::Zero();
    return tilt_energy(zarco, later);
  };
  EXPECT_NEAR(power, -(potential(1e-5) - potential(-1e-5)) / 2e-5, 1e-5 * std::abs(power));

  double last = tilt_energy(zarco, tipped);
  for (double t = 0.5; t < 5.0; t += 0.5) {
    const double now = tilt_energy(zarco, driven({t, {0, 0}}, {}, tipped));
    EXPECT_LT(now, last);
    last = now;
  }
}

}  // namespace
}  // namespace fairway
