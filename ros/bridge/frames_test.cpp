// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/frames.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <stdexcept>

#include "fairway/core/state.hpp"

namespace fairway::bridge {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;

Quaterniond quaternion_from(const Quaternion& q) { return {q[0], q[1], q[2], q[3]}; }
Quaternion numbers_of(const Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Vec3 vector_from(const Triple& v) { return {v[0], v[1], v[2]}; }

/// Where an axis of the body (forward, left, up) points in east-north-up, for a vehicle with these angles of
/// Fossen's.
Vec3 axis_in_enu(const Vec3& axis_flu, const Euler& angles) {
  return quaternion_from(flip_attitude(numbers_of(quaternion_of(angles)))) * axis_flu;
}

const Vec3 forward{1, 0, 0}, left{0, 1, 0}, up{0, 0, 1};
const Vec3 east{1, 0, 0}, north{0, 1, 0}, above{0, 0, 1};

class RandomAttitudes {
 public:
  Quaterniond next() {
    return Quaterniond{normal_(engine_), normal_(engine_), normal_(engine_), normal_(engine_)}.normalized();
  }
  Triple vector() { return {normal_(engine_), normal_(engine_), normal_(engine_)}; }

 private:
  std::mt19937 engine_{1};
  std::normal_distribution<double> normal_;
};

// The matrices are written down from the axes' names alone: a row of `enu_of_ned` is east, north or up
// in components north, east, down.
const Matrix3d enu_of_ned = (Matrix3d{} << 0, 1, 0, 1, 0, 0, 0, 0, -1).finished();
const Matrix3d flu_of_frd = (Matrix3d{} << 1, 0, 0, 0, -1, 0, 0, 0, -1).finished();

TEST(Frames, AVectorOfTheWorldIsEastNorthUp) {
  EXPECT_EQ(flip_world({10, 3, 5}), (Triple{3, 10, -5}));  // 10 north, 3 east, 5 deep
  EXPECT_EQ(flip_world(flip_world({10, 3, 5})), (Triple{10, 3, 5}));
}

TEST(Frames, AVectorOfTheBodyIsForwardLeftUp) {
  EXPECT_EQ(flip_body({1, 2, 3}), (Triple{1, -2, -3}));
  EXPECT_EQ(flip_body(flip_body({1, 2, 3})), (Triple{1, 2, 3}));
}

TEST(Frames, HeadingNorthIsYawOf90DegreesInEnu) {
  const Quaternion q = flip_attitude({1, 0, 0, 0});
  EXPECT_NEAR(q[0], std::cos(pi / 4), 1e-15);
  EXPECT_EQ(q[1], 0.0);
  EXPECT_EQ(q[2], 0.0);
  EXPECT_NEAR(q[3], std::sin(pi / 4), 1e-15);
}

TEST(Frames, HeadingEastIsNoRotationInEnu) {
  const Quaternion q = flip_attitude(numbers_of(quaternion_of(Euler{0, 0, pi / 2})));
  EXPECT_NEAR(std::fabs(q[0]), 1.0, 1e-15);
}

TEST(Frames, YawOfRep103IsNinetyDegreesLessTheHeading) {
  for (int degree = -180; degree <= 180; degree += 15) {
    const double heading = radians(degree);
    const Vec3 bow = axis_in_enu(forward, {0, 0, heading});
    EXPECT_NEAR(wrap_angle(std::atan2(bow.y(), bow.x()) - (pi / 2 - heading)), 0.0, 1e-14) << degree;
  }
}

TEST(Frames, NoseDownPointsDownInEnu) {
  const Vec3 bow = axis_in_enu(forward, {0, radians(-30), 0});  // Fossen's pitch is positive nose up
  EXPECT_NEAR(bow.dot(above), -0.5, 1e-15);
  EXPECT_NEAR(bow.dot(north), std::sqrt(0.75), 1e-15);
}

TEST(Frames, RolledToStarboardThePortSideIsUp) {
  const Vec3 port = axis_in_enu(left, {radians(30), 0, 0});  // heading north, port is west
  EXPECT_NEAR(port.dot(above), 0.5, 1e-15);
  EXPECT_NEAR(port.dot(east), -std::sqrt(0.75), 1e-15);
}

TEST(Frames, LevelTheMastPointsUp) { EXPECT_NEAR(axis_in_enu(up, {0, 0, 1.234}).dot(above), 1.0, 1e-15); }

TEST(Frames, TurningToStarboardIsANegativeYawRateInEnu) { EXPECT_EQ(flip_body({0, 0, 0.2})[2], -0.2); }

TEST(Frames, AttitudesAgreeWithRotationMatricesBothWays) {
  RandomAttitudes random;
  for (int i = 0; i < 100'000; ++i) {
    const Quaterniond q = random.next();
    const Quaterniond flipped = quaternion_from(flip_attitude(numbers_of(q)));
    const Matrix3d expected = enu_of_ned * q.toRotationMatrix() * flu_of_frd.transpose();
    ASSERT_LT((flipped.toRotationMatrix() - expected).cwiseAbs().maxCoeff(), 4e-15) << i;
    const Matrix3d back = quaternion_from(flip_attitude(numbers_of(flipped))).toRotationMatrix();
    ASSERT_LT((back - enu_of_ned.transpose() * expected * flu_of_frd).cwiseAbs().maxCoeff(), 4e-15) << i;
  }
}

TEST(Frames, AttitudesComeBackWithTheirSign) {
  RandomAttitudes random;
  for (int i = 0; i < 100'000; ++i) {
    const Quaternion q = numbers_of(random.next());
    const Quaternion back = flip_attitude(flip_attitude(q));
    for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR(back[k], q[k], 1e-15) << i;
  }
}

TEST(Frames, AMotionTurnsAsOne) {
  // what moves forward and turns about the body's axes does so in both worlds alike
  RandomAttitudes random;
  for (int i = 0; i < 1000; ++i) {
    const Motion motion{1.5, random.vector(), numbers_of(random.next()), random.vector(), random.vector()};
    const Motion shown = motion_in(Frame::enu, motion);
    const Vec3 velocity_n = quaternion_from(motion.q_nb) * vector_from(motion.v_b);
    const Vec3 velocity_enu = quaternion_from(shown.q_nb) * vector_from(shown.v_b);
    ASSERT_LT((velocity_enu - enu_of_ned * velocity_n).norm(), 1e-14);
    const Vec3 turn_n = quaternion_from(motion.q_nb) * vector_from(motion.omega_b);
    const Vec3 turn_enu = quaternion_from(shown.q_nb) * vector_from(shown.omega_b);
    ASSERT_LT((turn_enu - enu_of_ned * turn_n).norm(), 1e-14);
    ASSERT_EQ(shown.time, 1.5);
    ASSERT_EQ(motion_in(Frame::enu, shown).position_n, motion.position_n);
  }
}

TEST(Frames, WithNedNotABitChanges) {
  RandomAttitudes random;
  const Motion motion{0.1, random.vector(), numbers_of(random.next()), random.vector(), random.vector()};
  const Motion shown = motion_in(Frame::ned, motion);
  EXPECT_EQ(shown.position_n, motion.position_n);
  EXPECT_EQ(shown.q_nb, motion.q_nb);
  EXPECT_EQ(shown.v_b, motion.v_b);
  EXPECT_EQ(shown.omega_b, motion.omega_b);
}

TEST(Frames, AnUnknownFrameIsRefused) {
  EXPECT_EQ(frame_of("enu"), Frame::enu);
  EXPECT_EQ(frame_of("ned"), Frame::ned);
  EXPECT_THROW(frame_of("NED"), std::runtime_error);
  EXPECT_THROW(frame_of(""), std::runtime_error);
}

}  // namespace
}  // namespace fairway::bridge
