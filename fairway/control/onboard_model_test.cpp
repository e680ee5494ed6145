// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/onboard_model.hpp"

#include <gtest/gtest.h>

#include "fairway/dynamics/catalog.hpp"

namespace fairway {
namespace {

TEST(OnboardModel, OfTheTransportReachesTheLimitsOfALinearProgramme) {
  const OnboardModel model = *onboard_model(builtin_vehicles().make("minerva_transport"));
  // 1200 turns, other axes at zero: 778 N either way in surge and sway, 1351 and -865 N m in yaw
  for (const int axis : {0, 1}) {
    EXPECT_NEAR(model.greatest[axis], 778.0, 1.0);  // measured 778.3
    EXPECT_NEAR(model.least[axis], -778.0, 1.0);
  }
  EXPECT_NEAR(model.greatest[5], 1351.0, 1.0);
  EXPECT_NEAR(model.least[5], -865.0, 1.0);
  for (const int axis : {2, 3, 4}) {
    EXPECT_EQ(model.greatest[axis], 0.0);
    EXPECT_EQ(model.least[axis], 0.0);
  }
  EXPECT_NEAR(model.mass[0], 4800.0, 1.0);
  EXPECT_NEAR(model.drag(0, 0.5), 70.0 + 0.25 * 2403.0, 0.1);
}

TEST(OnboardModel, OfTheAlignedLayoutIsAsymmetric) {
  const OnboardModel model = *onboard_model(builtin_vehicles().make(
      "minerva_transport",
      {{"layout[1].yaw_deg", 0.0}, {"layout[2].yaw_deg", 0.0}, {"layout[3].yaw_deg", 0.0}}));
  EXPECT_NEAR(model.greatest[0], 1308.0, 1.0);
  EXPECT_NEAR(model.least[0], -602.0, 1.0);
  EXPECT_NEAR(model.greatest[1], 640.0, 1.0);
  EXPECT_NEAR(model.least[1], -440.0, 1.0);
  EXPECT_NEAR(model.greatest[5], 1664.0, 1.0);
  EXPECT_NEAR(model.least[5], -1664.0, 1.0);
}

TEST(OnboardModel, OfSparusIsItsThrusters) {
  const OnboardModel model = *onboard_model(builtin_vehicles().make("sparus2"));
  EXPECT_NEAR(model.greatest[0], 143.0, 1e-3);  // two of 71.5 N ahead
  EXPECT_NEAR(model.least[0], -60.0, 1e-3);     // two of 30 N astern
  EXPECT_NEAR(model.greatest[2], 12.702, 1e-3);
  EXPECT_NEAR(model.least[2], -6.277, 1e-3);
  EXPECT_NEAR(model.greatest[5], 2 * 0.17 * 30.0, 1e-3);  // what astern gives, either way
  EXPECT_NEAR(model.least[5], -2 * 0.17 * 30.0, 1e-3);
}

TEST(OnboardModel, OfAKinematicVehicleIsUnknown) {
  EXPECT_FALSE(onboard_model(builtin_vehicles().make("kinematic")).has_value());
}

}  // namespace
}  // namespace fairway
