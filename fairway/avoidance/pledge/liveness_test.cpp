// SPDX-License-Identifier: Apache-2.0
// Claim C4 of README.md: while all live and some words come through, everybody arrives.
#include <gtest/gtest.h>

#include <vector>

#include "fairway/avoidance/pledge/agreement.hpp"
#include "fairway/avoidance/pledge/testing/fleet.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::pledge {
namespace {

TEST(PledgeLiveness, OfThreeAllArriveWhateverWasLostInTheTurnsThatDecideAndWhoeverSpeaksFirst) {
  constexpr unsigned words = 9;
  int divided = 0, beside_another = 0;
  for (const std::vector<std::size_t>& slots : orders_of_three()) {
    const Fleet begins = three_about_to_decide(slots);
    for (unsigned pattern = 0; pattern < 1U << words; ++pattern) {
      Fleet fleet = begins;
      unsigned word = 0;
      const auto by_pattern = [&](std::size_t, std::size_t) { return ((pattern >> word++) & 1U) != 0; };
      while (word < words) fleet.go_on(by_pattern);
      while (fleet.time < begins.time + 12.0) fleet.go_on([](std::size_t, std::size_t) { return false; });
      divided += fleet.moving() > 0 && fleet.moving() < 3 ? 1 : 0;
      const std::ptrdiff_t moved_first = fleet.moving();
      std::ptrdiff_t moved_at_once = moved_first;
      while (!fleet.is_done() && fleet.time < begins.time + 400.0) {
        fleet.go_on(always);
        moved_at_once = std::max(moved_at_once, fleet.moving());
      }
      beside_another += moved_first > 0 && moved_at_once > moved_first ? 1 : 0;
      ASSERT_TRUE(fleet.is_done()) << pattern;
      ASSERT_GE(fleet.least, 3.0 + 2.0) << pattern;
      ASSERT_EQ(fleet.beside_plans, 0) << "a gate is all that stops anybody, pattern " << pattern;
      ASSERT_LT(fleet.time, begins.time + 250.0) << pattern;
    }
  }
  EXPECT_GT(divided, 0) << "patterns that divide the group are among them";
  EXPECT_GT(beside_another, 2 * divided / 5) << "who stayed goes while the others are on their ways";
}

TEST(PledgeLiveness, OfTwoToEightNobodyIsLeftAfterHalfAnHourThoughHalfIsLostInRuns) {
  int divided = 0, beside_plans = 0;
  for (std::uint64_t seed = 1; seed <= 480; ++seed) {
    Rng rng = Rng{seed}.stream("fleet");
    std::vector<Member> all = cube(rng);
    all.resize(2 + seed % 7);
    Fleet fleet{all, seed % 3 == 0 ? 8.0 : 3.2};
    LossesInRuns losses{rng};
    bool was_divided = false;
    while (!fleet.is_done() && fleet.time < 1800.0) {
      fleet.go_on([&](std::size_t from, std::size_t to) { return losses(from, to); });
      was_divided = was_divided || (fleet.moving() == 1 && fleet.members[0].status() == Status::held);
    }
    EXPECT_TRUE(fleet.is_done()) << "seed " << seed;
    EXPECT_GE(fleet.least, 3.0 + 2.0) << "seed " << seed;
    beside_plans += fleet.beside_plans;
    divided += was_divided ? 1 : 0;
  }
  EXPECT_GT(divided, 20) << "or little was tried";
  EXPECT_LE(beside_plans, 5) << "it is a gate that stops nearly all";
}

TEST(PledgeLiveness, AfterAnyNumberOfPlansThatCameToNothingTheNextOneCounts) {
  Fleet fleet{three_in_a_plane(), 3.0};
  while (fleet.time < 2.5) fleet.go_on(always);  // all states are known
  Epoch last;
  int plans = 0;
  const auto without_2 = [](std::size_t from, std::size_t) { return from != 2; };
  while (plans < 100 && fleet.time < 5000.0) {
    fleet.go_on(without_2);
    plans += fleet.members[0].plan().epoch > last ? 1 : 0;
    last = fleet.members[0].plan().epoch;
  }
  ASSERT_EQ(plans, 100);
  const double heard_again = fleet.time;
  while (!fleet.is_done() && fleet.time < heard_again + 400.0) fleet.go_on(always);
  EXPECT_TRUE(fleet.is_done());
  EXPECT_GE(fleet.least, 5.0);
}

TEST(PledgeLiveness, TwoWhoLieTooNearGoWithoutComingNearer) {
  for (int centimetres = 10; centimetres <= 500; centimetres += 70) {
    const double lie = 0.01 * centimetres;
    Fleet fleet{{crossing({0, 0, 5}, {20, 5, 5}), crossing({0, lie, 5}, {-20, 2, 5})}, 3.0};
    while (!fleet.is_done() && fleet.time < 300.0) fleet.go_on(always);
    EXPECT_TRUE(fleet.is_done()) << lie << " m apart";
    EXPECT_GE(fleet.least, lie - 0.03);
    EXPECT_EQ(fleet.beside_plans, 0) << lie << " m apart";
  }
}

}  // namespace
}  // namespace fairway::pledge
