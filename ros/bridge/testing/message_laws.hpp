// SPDX-License-Identifier: Apache-2.0
// What messages are in every middleware: INSTANTIATE_TYPED_TEST_SUITE_P(Ros1, Messages, ros1::Middleware).
// C++17.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "ros/bridge/messages.hpp"

namespace fairway::bridge {

template <class Middleware>
class Messages : public ::testing::Test {};
TYPED_TEST_SUITE_P(Messages);

TYPED_TEST_P(Messages, AStampIsTheNearestNanosecondAndReadsBackTheSame) {
  const auto ns = [](double seconds) { return TypeParam::nanoseconds(Writer<TypeParam>::stamp(seconds)); };
  EXPECT_EQ(ns(55.55), 55550000000);
  EXPECT_EQ(ns(3 * 0.05), 150000000) << "0.15000000000000002";
  EXPECT_EQ(ns(1.9999999999), 2000000000);
  EXPECT_EQ(ns(-1.0), 0);
  EXPECT_EQ(ns(1e10), 0);
  EXPECT_EQ(ns(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(seconds_of(12345678901), 12.345678901);
  for (int tick = 0; tick < 100000; ++tick) ASSERT_EQ(ns(seconds_of(ns(tick * 0.05))), tick * 50000000LL);
}

TYPED_TEST_P(Messages, NorthBoundNoseDownIsAsRep103HasIt) {
  // heading north, 0.2 rad nose down, 3 m north, 4 m east, 5 m deep, diving: all in NED and FRD
  const double half = -0.1;
  const Motion motion{
      7.5, {3, 4, 5}, {std::cos(half), 0, std::sin(half), 0}, {0.5, 0.1, 0.2}, {0.01, 0.02, 0.03}};
  Writer<TypeParam> writer{Frame::enu, "world"};
  const auto odometry = writer.odometry(motion, "auv");
  EXPECT_EQ(TypeParam::nanoseconds(odometry.header.stamp), 7500000000);
  EXPECT_EQ(std::string{odometry.header.frame_id}, "world");
  EXPECT_EQ(std::string{odometry.child_frame_id}, "auv");
  EXPECT_EQ(triple_in(odometry.pose.pose.position), (Triple{4, 3, -5}));
  EXPECT_EQ(triple_in(odometry.twist.twist.linear), (Triple{0.5, -0.1, -0.2})) << "left, not starboard";
  EXPECT_EQ(triple_in(odometry.twist.twist.angular), (Triple{0.01, -0.02, -0.03})) << "anticlockwise";
  // forward in ENU: to the north and down
  const auto& q = odometry.pose.pose.orientation;
  EXPECT_NEAR(1 - 2 * (q.y * q.y + q.z * q.z), 0, 1e-12);
  EXPECT_NEAR(2 * (q.x * q.y + q.w * q.z), std::cos(0.2), 1e-12);
  EXPECT_NEAR(2 * (q.x * q.z - q.w * q.y), -std::sin(0.2), 1e-12);
}

TYPED_TEST_P(Messages, InNedNothingChangesNotABitAndInEnuItComesBack) {
  const Motion motion{7.5, {1.0 / 3, -4e-7, 5e5}, {0.5, -0.5, 0.5, 0.5}, {0.1, 0.2, 0.3}, {-0.1, 1e-9, 3},
                      0.5};
  for (const Frame frame : {Frame::ned, Frame::enu}) {
    Writer<TypeParam> writer{frame};
    const Motion back = motion_of<TypeParam>(writer.odometry(motion, "auv"), frame);
    EXPECT_EQ(back.time, motion.time);
    EXPECT_EQ(back.position_n, motion.position_n);
    EXPECT_EQ(back.v_b, motion.v_b);
    EXPECT_EQ(back.omega_b, motion.omega_b);
    EXPECT_EQ(back.position_sigma, motion.position_sigma);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(back.q_nb[i], motion.q_nb[i], frame == Frame::ned ? 0.0 : 1e-15) << i;
  }
}

TYPED_TEST_P(Messages, OfACovarianceTheWorstSideCountsAndWhatIsNoneStatesNothing) {
  const auto sigma_of = [](double north, double both, double east) {
    typename TypeParam::Odometry odometry{};
    auto& rows = odometry.pose.covariance;
    rows[0] = north, rows[1] = rows[6] = both, rows[7] = east, rows[14] = 100.0;
    return motion_of<TypeParam>(odometry, Frame::enu).position_sigma;
  };
  EXPECT_EQ(sigma_of(0, 0, 0), 0.0);
  EXPECT_EQ(sigma_of(1, 0, 4), 2.0);
  EXPECT_DOUBLE_EQ(sigma_of(5, 4, 5), 3.0) << "to the north-east";
  EXPECT_EQ(sigma_of(-1, 0, 4), 0.0);
  EXPECT_EQ(sigma_of(std::numeric_limits<double>::quiet_NaN(), 0, 4), 0.0);
  EXPECT_EQ(sigma_of(4, std::numeric_limits<double>::infinity(), 4), 0.0);
}

TYPED_TEST_P(Messages, WhatIsNotANumberStaysSo) {
  typename TypeParam::Odometry odometry{};
  odometry.pose.pose.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(motion_of<TypeParam>(odometry, Frame::enu).position_n[1]));
}

TYPED_TEST_P(Messages, ATurnToStarboardAndADiveAreTurnedOverAndComeBack) {
  const BodyVelocity request{0.5, 0.1, 0.2, 0.3};
  const auto enu = Writer<TypeParam>{Frame::enu}.twist(request, 1.0, "auv").twist;
  EXPECT_EQ(triple_in(enu.linear), (Triple{0.5, -0.1, -0.2}));
  EXPECT_EQ(enu.angular.z, -0.3);
  for (const Frame frame : {Frame::enu, Frame::ned}) {
    const BodyVelocity back = velocity_of(Writer<TypeParam>{frame}.twist(request, 1.0, "auv").twist, frame);
    EXPECT_EQ(back.surge_mps, 0.5);
    EXPECT_EQ(back.sway_mps, 0.1);
    EXPECT_EQ(back.heave_mps, 0.2);
    EXPECT_EQ(back.yaw_rate_radps, 0.3);
  }
}

TYPED_TEST_P(Messages, MarkersClearWhatWasAndShowWhatIs) {
  const Mark ball{Mark::Kind::sphere, "safety", {{1, 2, 3}}, 1.5};
  const Mark name{Mark::Kind::words, "names", {{0, 0, 0}}, 0.0, {}, 2.0, "auv"};
  const Mark line{Mark::Kind::line, "", {{0, 0, 0}, {1, 0, 0}}, 0.0, {}, 0.1};
  Writer<TypeParam> writer{Frame::enu};
  const auto array = writer.markers({ball, name, line}, 2.0, "fleet");
  const auto& markers = TypeParam::elements(array.markers);
  ASSERT_EQ(markers.size(), 4U);
  EXPECT_EQ(markers[0].action, 3) << "DELETEALL";
  EXPECT_EQ(markers[1].type, 2) << "SPHERE";
  EXPECT_EQ(triple_in(markers[1].scale), (Triple{3, 3, 3})) << "diameters";
  EXPECT_EQ(triple_in(markers[1].pose.position), (Triple{2, 1, -3}));
  EXPECT_EQ(markers[2].type, 9) << "TEXT_VIEW_FACING";
  EXPECT_EQ(std::string{markers[2].text}, "auv");
  EXPECT_EQ(markers[2].scale.z, 2.0);
  EXPECT_EQ(markers[3].type, 4) << "LINE_STRIP";
  EXPECT_EQ(triple_in(TypeParam::elements(markers[3].points)[1]), (Triple{0, 1, 0})) << "north";
  const std::string space = TypeParam::name_space("fleet");
  EXPECT_EQ(std::string{markers[0].ns}, space);
  EXPECT_EQ(std::string{markers[1].ns}, space.empty() ? "safety" : space + "/safety");
  EXPECT_EQ(std::string{markers[3].ns}, space);
}

REGISTER_TYPED_TEST_SUITE_P(Messages, AStampIsTheNearestNanosecondAndReadsBackTheSame,
                            NorthBoundNoseDownIsAsRep103HasIt, InNedNothingChangesNotABitAndInEnuItComesBack,
                            OfACovarianceTheWorstSideCountsAndWhatIsNoneStatesNothing,
                            WhatIsNotANumberStaysSo, ATurnToStarboardAndADiveAreTurnedOverAndComeBack,
                            MarkersClearWhatWasAndShowWhatIs);

}  // namespace fairway::bridge
