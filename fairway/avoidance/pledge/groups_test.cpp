// SPDX-License-Identifier: Apache-2.0
// More than eight: groups that move in turns, whatever is lost.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <vector>

#include "fairway/avoidance/pledge/agreement.hpp"
#include "fairway/avoidance/pledge/testing/fleet.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway::pledge {
namespace {

/// Everybody goes to the other side of a ring.
std::vector<Member> ring_of(int count, double radius) {
  std::vector<Member> all;
  for (int i = 0; i < count; ++i) {
    const double bearing = 2.0 * std::numbers::pi * i / count;
    const Vec3 from{radius * std::cos(bearing), radius * std::sin(bearing), 5.0};
    all.push_back(crossing(from, {-from.x(), -from.y(), 5.0}));
  }
  return all;
}

std::set<std::size_t> groups_that_move(const Fleet& fleet) {
  std::set<std::size_t> groups;
  for (std::size_t i = 0; i < fleet.members.size(); ++i)
    if (fleet.members[i].status() == Status::moving)
      groups.insert(fleet.members[i].rounds().groups().group_of(i));
  return groups;
}

TEST(PledgeGroups, OfMoreThanEightAllKeepClearAndArriveAtAnyLossAndGroupsDepartWhileOthersAreOnTheirWays) {
  std::size_t most = 0;
  for (const auto& [count, radius] : {std::pair{9, 20.0}, {12, 20.0}, {16, 24.0}, {24, 34.0}, {32, 44.0}}) {
    for (const double loss : {0.0, 0.3}) {
      Rng rng = Rng{static_cast<std::uint64_t>(count)}.stream("ring");
      Fleet fleet{ring_of(count, radius), 0.4 * count};
      while (!fleet.is_done() && fleet.time < 6000.0) {
        fleet.go_on([&](std::size_t, std::size_t) { return rng.uniform(0, 1) >= loss; });
        most = std::max(most, groups_that_move(fleet).size());
      }
      EXPECT_TRUE(fleet.is_done()) << count << ", loss " << loss;
      EXPECT_GE(fleet.least, 3.0 + 1.5) << count << ", loss " << loss;
    }
  }
  EXPECT_GT(most, 1U);
}

/// From drawn places to others, none of which is near another.
std::vector<Member> drawn(int count, Rng& rng) {
  std::vector<Vec3> places;
  while (static_cast<int>(places.size()) < 2 * count) {
    const Vec3 place{rng.uniform(-30, 30), rng.uniform(-30, 30), rng.uniform(3, 33)};
    if (std::ranges::all_of(places, [&](const Vec3& other) { return (place - other).norm() > 8.0; }))
      places.push_back(place);
  }
  std::vector<Member> all;
  for (std::size_t i = 0; i + 1 < places.size(); i += 2) all.push_back(crossing(places[i], places[i + 1]));
  return all;
}

TEST(PledgeGroups, AtDrawnPlacesAllKeepClearAndArriveThoughHalfIsLostInRuns) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng rng = Rng{seed}.stream("drawn");
    const int count = 9 + static_cast<int>(seed % 12);
    Fleet fleet{drawn(count, rng), 0.4 * count};
    LossesInRuns losses{rng};
    while (!fleet.is_done() && fleet.time < 7200.0) {
      fleet.go_on([&](std::size_t from, std::size_t to) { return losses(from, to); });
    }
    EXPECT_TRUE(fleet.is_done()) << "seed " << seed;
    EXPECT_GE(fleet.least, 3.0 + 1.5) << "seed " << seed;
  }
}

TEST(PledgeGroups, WhereWordsComeAtEveryStepAGroupStillHasTheTimeToFindAPlan) {
  Fleet fleet{ring_of(16, 24.0), step};
  while (!fleet.is_done() && fleet.time < 600.0) fleet.go_on(always);
  EXPECT_TRUE(fleet.is_done());
  EXPECT_GE(fleet.least, 3.0 + 1.5);
}

TEST(PledgeGroups, WhoWasLeftOutOfAPlanLooksForOneInItsNextRound) {
  std::vector<Member> wide = ring_of(16, 28.0);
  for (Member& member : wide) member.radius = 3.5;  // so that not all of a group can go at once
  Fleet fleet{wide, step};
  while (!fleet.is_done() && fleet.time < 500.0) fleet.go_on(always);
  EXPECT_TRUE(fleet.is_done()) << "it would take 643 s where rounds are given back until all have arrived";
  EXPECT_GE(fleet.least, 7.0 + 1.5);
}

TEST(PledgeGroups, NobodyAllocatesWhereOneHasRoundsToCountAndPlacesToKeepClearOf) {
  Fleet fleet{ring_of(16, 24.0), 6.4};
  fleet.said.reserve(64);
  const std::function<bool(std::size_t, std::size_t)> all_heard = always;
  const long before = allocation_count();
  while (!fleet.is_done() && fleet.time < 600.0) fleet.go_on(all_heard);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_TRUE(fleet.is_done());
}

TEST(PledgeGroups, WhileOneIsSilentNobodyMoves) {
  for (const std::size_t silent : {3U, 4U}) {
    Fleet fleet{ring_of(12, 20.0), 4.8};
    std::set<std::size_t> moved;
    while (fleet.time < 600.0) {
      fleet.go_on([&](std::size_t from, std::size_t) { return from != silent; });
      moved.merge(groups_that_move(fleet));
    }
    EXPECT_TRUE(moved.empty()) << "its own waits for its acknowledgement, and the other for its place";
  }
}

TEST(PledgeGroups, WhoIsOutOfTheReachOfSomebodyOfAnotherGroupIsHeardThroughOthers) {
  Fleet fleet{ring_of(12, 20.0), 4.8};
  while (!fleet.is_done() && fleet.time < 1200.0)
    fleet.go_on(
        [](std::size_t from, std::size_t to) { return from + to != 5 || from * to != 0; });  // 0 and 5
  EXPECT_TRUE(fleet.is_done());
  EXPECT_GE(fleet.least, 3.0 + 1.5);
}

TEST(PledgeGroups, WhoIsOfNoGroupIsNotListenedTo) {
  Agreement member{0, {.count = 9}};
  member.hold(crossing({0, 0, 5}, {20, 0, 5}));
  for (const std::size_t vehicle : {9U, 31U}) {
    Agreement stranger{vehicle, {.count = 32}};
    stranger.hold(crossing({10, 0, 5}, {-20, 0, 5}));
    EXPECT_EQ(member.hear(stranger.say(0.0, 3.6), 0.0, 0.0), Hearing::taken);
    EXPECT_EQ(member.rounds().heard_in(vehicle), -1) << vehicle;
    EXPECT_FALSE(member.others().bystanders()[vehicle].known) << vehicle;
  }
}

}  // namespace
}  // namespace fairway::pledge
