// SPDX-License-Identifier: Apache-2.0
// Where a member goes whose destination somebody of another group has taken.
#include "fairway/avoidance/pledge/making_room.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "fairway/avoidance/pledge/testing/fleet.hpp"

namespace fairway::pledge {
namespace {

/// Vehicle 0 of nine, which has heard the eight others: all far away but 1 and 2, the first of the other
/// group and a mate.
struct Nine {
  std::vector<Member> all;
  std::array<Obstacle, most_vehicles> room;
  Limits limits{.max_speed = 0.5, .max_climb_rate = 0.3, .min_depth = 0.0};

  Nine() {
    for (int i = 0; i < 9; ++i) all.push_back(crossing({60.0, 12.0 * i, 20}, {60.0, 12.0 * i, 40}));
    all[0] = crossing({0, 0, 20}, {0, 40, 20});
  }

  Agreement heard() const {
    Agreement own{0, {.count = 9, .tubes = {.radius = 1.0, .told = 0.1}}};
    own.hold(all[0]);
    for (std::size_t i = 1; i < 9; ++i) {
      Agreement other{i, own.terms()};
      other.hold(all[i]);
      own.hear(other.say(0.0, 3.6), 0.0, 0.0);
    }
    return own;
  }
  Aim aim() {
    const Agreement own = heard();
    return aim_of(own, all[0].destination, own.chart({}, room), limits);
  }
};

constexpr double between_two = 1.5 + 1.5 + 2.0 + 0.1;  // radii, tubes and what is told [m]

TEST(MakingRoom, WhoseDestinationIsFreeGoesThere) {
  Nine nine;
  nine.all[1].destination = nine.all[0].anchor;
  EXPECT_EQ(nine.aim().kind, Aim::Kind::goal);
  EXPECT_EQ(nine.aim().place, nine.all[0].destination);
}

TEST(MakingRoom, WhoseDestinationIsTakenAndWhoIsInNobodysWayStays) {
  Nine nine;
  nine.all[1].anchor = nine.all[0].destination;
  EXPECT_EQ(nine.aim().kind, Aim::Kind::none);
}

TEST(MakingRoom, TwoWhoHaveEachOthersPlaceOneGoesAsideNearItsGoalAndClearOfAll) {
  Nine nine;
  nine.all[1] = crossing(nine.all[0].destination, nine.all[0].anchor);
  const Aim aim = nine.aim();
  ASSERT_EQ(aim.kind, Aim::Kind::aside);
  EXPECT_LT((aim.place - nine.all[0].destination).norm(), 8.0);
  for (std::size_t i = 1; i < 9; ++i) {
    EXPECT_GE((aim.place - nine.all[i].anchor).norm(), between_two) << i;
    EXPECT_GE((aim.place - nine.all[i].destination).norm(), between_two) << i;
  }
}

TEST(MakingRoom, AMateThatIsToGoToOnesPlaceIsMadeRoomForToo) {
  Nine nine;
  nine.all[1].anchor = nine.all[0].destination;
  nine.all[2].destination = nine.all[0].anchor;
  EXPECT_EQ(nine.aim().kind, Aim::Kind::aside);
}

TEST(MakingRoom, WhoIsStuckGoesAsideNearWhereItLies) {
  Nine nine;
  const Agreement own = nine.heard();
  const Aim aim = aim_of(own, nine.all[0].destination, own.chart({}, nine.room), nine.limits, 0);
  ASSERT_EQ(aim.kind, Aim::Kind::aside);
  EXPECT_LT((aim.place - nine.all[0].anchor).norm(), 8.0);
  const Aim next = aim_of(own, nine.all[0].destination, own.chart({}, nine.room), nine.limits, 1);
  ASSERT_EQ(next.kind, Aim::Kind::aside);
  EXPECT_GT((next.place - aim.place).norm(), 4.0) << "another side";
}

TEST(MakingRoom, NobodyGoesAsideAboveTheSurfaceOrIntoWhatStands) {
  Nine nine;
  nine.all[0] = crossing({0, 0, 2}, {0, 40, 2});
  nine.all[1] = crossing(nine.all[0].destination, nine.all[0].anchor);
  nine.limits.max_depth = 3.0;
  EXPECT_NEAR(nine.aim().place.z(), 2.0, 1e-9);
  const Agreement own = nine.heard();
  const std::vector<Obstacle> rocks{
      {.kind = Obstacle::Kind::sphere, .position = nine.aim().place, .radius = 2.0}};
  const Aim other = aim_of(own, nine.all[0].destination, own.chart(rocks, nine.room), nine.limits);
  ASSERT_EQ(other.kind, Aim::Kind::aside);
  EXPECT_GE((other.place - rocks[0].position).norm(), 2.0 + 1.5 + 1.0);
}

}  // namespace
}  // namespace fairway::pledge
