// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/mission.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(Mission, TellsTheNextTransitFromThePresentLegOn) {
  Mission mission{{{.kind = LegKind::go_to, .position = {10, 0, 0}},
                   {.kind = LegKind::rendezvous},
                   {.kind = LegKind::transit, .position = {20, 0, 0}},
                   {.kind = LegKind::rendezvous},
                   {.kind = LegKind::transit, .position = {30, 0, 0}}},
                  10.0};
  const auto goes_to = [&](const Vec3& place, bool everyone_ready) {
    mission.advance({.position = place}, 0.0, everyone_ready);
    const Leg* next = mission.next_transit();
    return next != nullptr ? next->position.x() : 0.0;
  };
  EXPECT_EQ(goes_to({0, 0, 0}, false), 20.0) << "while it is on its way to the rendezvous";
  EXPECT_EQ(goes_to({10, 0, 0}, false), 20.0) << "while it waits there";
  EXPECT_EQ(goes_to({10, 0, 0}, true), 20.0) << "while it is under way";
  EXPECT_EQ(mission.phase(), Phase::under_way);
  EXPECT_EQ(goes_to({20, 0, 0}, false), 30.0) << "at the next rendezvous";
  EXPECT_EQ(goes_to({20, 0, 0}, true), 30.0);
  EXPECT_EQ(goes_to({30, 0, 0}, true), 0.0) << "after the last there is none";
}

TEST(Mission, ChangedLegsLeadElsewhereFromThePresentOneOn) {
  const auto legs = [](double east) {
    return std::vector<Leg>{{.kind = LegKind::go_to, .position = {10, east, 0}},
                            {.kind = LegKind::transit, .position = {20, east, 0}}};
  };
  Mission mission{legs(0), 10.0};
  mission.advance({.position = {10, 0, 0}}, 5.0, false);
  ASSERT_EQ(mission.phase(), Phase::under_way);
  mission.change(legs(50), {.position = {12, 0, 0}}, 6.0);
  EXPECT_EQ(mission.leg()->position, Vec3(20, 50, 0)) << "the leg that it was on";
  mission.advance({.position = {20, 0, 0}}, 30.0, false);
  EXPECT_EQ(mission.phase(), Phase::under_way) << "it is no longer there";
  mission.advance({.position = {20, 50, 0}}, 40.0, false);
  EXPECT_EQ(mission.phase(), Phase::arrived);
  mission.change(legs(-50), {.position = {20, 50, 0}}, 50.0);
  EXPECT_EQ(mission.phase(), Phase::under_way) << "whoever has arrived sets out again";
  EXPECT_EQ(mission.leg()->position, Vec3(20, -50, 0));
}

}  // namespace
}  // namespace fairway
