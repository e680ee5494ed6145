// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/fleet_marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "ros/bridge/fleet_host.hpp"
#include "ros/bridge/hull_mesh.hpp"

namespace fairway::bridge {
namespace {

/// Enclosed volume, positive if the triangles are counter-clockwise from outside.
double volume_of(const std::vector<Triple>& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.size(); i += 3) {
    const auto& [a, b, c] = std::array{mesh[i], mesh[i + 1], mesh[i + 2]};
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6.0;
}

double extent(const std::vector<Triple>& mesh, std::size_t axis) {
  const auto [least, greatest] = std::minmax_element(
      mesh.begin(), mesh.end(), [axis](const Triple& a, const Triple& b) { return a[axis] < b[axis]; });
  return (*greatest)[axis] - (*least)[axis];
}

TEST(Hulls, AreClosedOfTheirSizeAndSeenFromOutside) {
  for (const char* shape : {"auv", "torpedo", "rov", "catamaran", "transport", "point"}) {
    const std::vector<Triple> mesh = hull_mesh(shape, 2.0, 0.5);
    ASSERT_GT(mesh.size(), 0U) << shape;
    EXPECT_EQ(mesh.size() % 3, 0U) << shape;
    EXPECT_GT(volume_of(mesh), 0.0) << shape;
    EXPECT_NEAR(extent(mesh, 0), 2.0, 1e-9) << shape;
  }
  // a box is what it says
  EXPECT_NEAR(volume_of(hull_mesh("transport", 2.0, 0.5)), 2.0 * 0.5 * 0.5, 1e-12);
}

TEST(FleetMarks, ShowHullsWhereTheVehiclesAreAndTheirSpheresNamesGoalsAndTrails) {
  FleetOptions options;
  options.scenario = std::string{FAIRWAY_SOURCE_DIR} + "/scenarios/head_on.yaml";
  options.autonomous = true;
  FleetHost fleet{options};
  FleetMarks marks{fleet};
  for (int i = 0; i < 200; ++i) {
    marks.see(fleet);
    fleet.step();
  }
  std::map<std::string, int> count;
  for (const Mark& mark : marks.draw(fleet)) {
    ++count[mark.meaning];
    if (mark.meaning == "detection") {
      EXPECT_EQ(mark.radius, 3.0);
    }
    if (mark.meaning != "vehicles") continue;
    EXPECT_GT(volume_of(mark.points), 0.0);
    EXPECT_NEAR(extent(mark.points, 0), 1.6, 0.01) << "a Sparus II that heads north or south";
  }
  EXPECT_EQ(
      count,
      (std::map<std::string, int>{
          {"vehicles", 2}, {"detection", 2}, {"safety", 2}, {"trails", 2}, {"names", 2}, {"goals", 4}}));
}

}  // namespace
}  // namespace fairway::bridge
