// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/vehicle_limits.hpp"

#include <gtest/gtest.h>

#include "fairway/dynamics/catalog.hpp"

namespace fairway {
namespace {

Limits of(const char* vehicle, const ParamValues& params = {}, const Limits& mission = {}) {
  return narrowed(mission, builtin_vehicles().make(vehicle, params));
}

TEST(VehicleLimits, AreWhatTheActuatorsOfEachVehicleGive) {
  struct Case {
    const char* vehicle;
    bool sternway;
    bool sway;
  };
  for (const Case& c :
       {Case{"sparus2", true, false}, Case{"minerva", true, true}, Case{"minerva_transport", true, true},
        Case{"otter_by_thrust", true, false}, Case{"zarco", true, false}, Case{"kinematic", true, false},
        Case{"remus100", false, false}}) {
    EXPECT_EQ(of(c.vehicle).sternway, c.sternway) << c.vehicle;
    EXPECT_EQ(of(c.vehicle).sway, c.sway) << c.vehicle;
    EXPECT_EQ(of(c.vehicle).min_speed > 0.0, c.vehicle == std::string_view("remus100")) << c.vehicle;
  }
  EXPECT_NEAR(of("remus100").min_speed, 0.9615, 5e-5);  // FinAutopilot::steerage_way()
}

TEST(VehicleLimits, FollowTheParametersOfTheModel) {
  EXPECT_FALSE(of("kinematic", {{"max_reverse_mps", 0.0}}).sternway);
  EXPECT_TRUE(of("kinematic", {{"max_sway_mps", 0.1}}).sway);
  EXPECT_FALSE(of("zarco", {{"thrust_astern_n", 0.0}}).sternway);
}

TEST(VehicleLimits, AMissionMayAllowLessButNoMore) {
  const Limits mission{.max_speed = 1.2, .min_speed = 0.3, .sternway = false};
  const Limits kinematic = of("kinematic", {{"max_sway_mps", 0.1}}, mission);
  EXPECT_EQ(kinematic.min_speed, 0.3);
  EXPECT_FALSE(kinematic.sternway);
  EXPECT_TRUE(kinematic.sway);
  EXPECT_EQ(kinematic.max_speed, 1.2);
  EXPECT_GT(of("remus100", {}, mission).min_speed, 0.9);
}

}  // namespace
}  // namespace fairway
