// SPDX-License-Identifier: Apache-2.0
// The claims of README.md, over patterns of loss: all of them in small models, many at random in large ones.
#include "fairway/avoidance/pledge/agreement.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "fairway/avoidance/pledge/testing/fleet.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::pledge {
namespace {

TEST(Agreement, OfThreeNeverBringsTwoTogetherWhateverIsLostInTheTurnsThatDecideAndWhoeverSpeaksFirst) {
  // every pattern of nine words lost or heard, in every order of turns, and nothing is heard after them for a
  // while
  constexpr unsigned words = 9;
  int all_departed = 0, some_departed = 0;
  for (const std::vector<std::size_t>& slots : orders_of_three()) {
    const Fleet begins = three_about_to_decide(slots);
    ASSERT_TRUE(std::ranges::any_of(begins.members, has_plan)) << "a plan was found";
    for (unsigned pattern = 0; pattern < 1U << words; ++pattern) {
      Fleet fleet = begins;
      unsigned word = 0;
      const auto by_pattern = [&](std::size_t, std::size_t) {
        const bool heard = word >= words || ((pattern >> word) & 1U) != 0;
        ++word;
        return heard;
      };
      const auto silence = [](std::size_t, std::size_t) { return false; };
      while (word < words) fleet.go_on(by_pattern);
      for (int i = 0; i < 350; ++i) fleet.go_on(silence);
      ASSERT_GE(fleet.least, 3.0 + 2.0) << pattern;
      const auto moved = std::ranges::count_if(fleet.members, [](const Agreement& m) {
        return m.status() != Status::held || m.member(0).version > 0;
      });
      all_departed += moved == 3 ? 1 : 0;
      some_departed += moved > 0 && moved < 3 ? 1 : 0;
    }
  }
  EXPECT_GT(all_departed, 0);
  EXPECT_GT(some_departed, 0) << "patterns that divide the group are among them";
}

TEST(Agreement, WhoIsTakenAlongByAPlanThatWasMadeFromItsOlderStateTellsTheNewOneUntilThatIsKnown) {
  Fleet fleet = three_about_to_decide();
  const auto author =
      static_cast<std::size_t>(std::ranges::find_if(fleet.members, has_plan) - fleet.members.begin());
  const std::size_t other = (author + 1) % 3;
  Member elsewhere = fleet.members[other].own();
  elsewhere.anchor.x() += 1.0;
  fleet.members[other].hold(elsewhere);
  fleet.places[other] = elsewhere.anchor;
  const double moved = fleet.time;
  while (!has_plan(fleet.members[other]) || fleet.time < moved + 1.5 * fleet.turn_period)
    fleet.go_on([&](std::size_t from, std::size_t) { return from != other; });
  ASSERT_TRUE(fleet.members[other].plan().participants[other]);
  for (const double turn : {0.0, fleet.turn_period}) {
    const double now = fleet.time + turn;
    if (now >= fleet.members[other].plan().start()) break;
    const auto word = decode(fleet.members[other].say(now, fleet.turn_period), Vec2::Zero(), now);
    const auto* state = word ? std::get_if<StateWord>(&*word) : nullptr;
    ASSERT_TRUE(state != nullptr) << "it passes a plan on that comes to nothing";
    EXPECT_NEAR(state->member.anchor.x(), elsewhere.anchor.x(), 0.1);
    EXPECT_TRUE((state->header.heard & fleet.members[other].plan().participants).none());
  }
  while (!fleet.is_done() && fleet.time < 300.0) fleet.go_on(always);
  EXPECT_TRUE(fleet.is_done());
  EXPECT_GE(fleet.least, 3.0 + 1.5);
}

TEST(Agreement, OfEightKeepsClearAndComesToItsEndAtAnyLoss) {
  for (const double loss : {0.0, 0.1, 0.5}) {
    double sum = 0.0;
    constexpr int seeds = 6;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      Rng rng = Rng{seed}.stream("fleet");
      Fleet fleet{cube(rng), 3.2};
      while (!fleet.is_done() && fleet.time < 2000.0)
        fleet.go_on([&](std::size_t, std::size_t) { return rng.uniform(0, 1) >= loss; });
      EXPECT_TRUE(fleet.is_done()) << "loss " << loss << ", seed " << seed;
      EXPECT_GE(fleet.least, 3.0 + 1.5) << "loss " << loss << ", seed " << seed;
      sum += fleet.time;
    }
    if (loss == 0.0) {
      EXPECT_LT(sum / seeds, 95.0);
    }
  }
}

TEST(Agreement, WhereTheGroupIsDividedAgainAndAgainAllKeepClear) {
  int divided = 0;
  for (std::uint64_t seed = 1; seed <= 104; ++seed) {
    Rng rng = Rng{seed}.stream("fleet");
    Fleet fleet{cube(rng), 8.0};
    LossesInRuns losses{rng};
    bool was_divided = false;
    while (!fleet.is_done() && fleet.time < 800.0) {
      fleet.go_on([&](std::size_t from, std::size_t to) { return losses(from, to); });
      was_divided = was_divided || (fleet.moving() == 1 && fleet.members[0].status() == Status::held);
    }
    EXPECT_GE(fleet.least, 3.0 + 1.5) << "seed " << seed;
    divided += was_divided ? 1 : 0;
  }
  EXPECT_GT(divided, 0) << "or nothing was tried";
}

TEST(Agreement, ThoughAWordTakesAWholeSlotAllDepartByTheFirstPlan) {
  // who speaks next has said its word before it has heard the one before it
  constexpr double cycle = 9.6;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Rng rng = Rng{seed}.stream("fleet");
    Fleet fleet{cube(rng), cycle};
    fleet.on_the_air = cycle / 8.0;
    while (fleet.moving() == 0 && fleet.time < 100.0) fleet.go_on(always);
    EXPECT_EQ(fleet.moving(), 8) << "seed " << seed;
    EXPECT_LT(fleet.time, 3.2 * cycle)
        << "all have told their states, then a plan, then a turn and two slots";
  }
}

TEST(Agreement, WhoDecidesMoreRarelyThanItIsToldAgreesAllTheSame) {
  Fleet fleet{three_in_a_plane(), 3.0};
  fleet.period = 0.25 * step;
  while (fleet.moving() == 0 && fleet.time < 100.0) fleet.go_on(always);
  EXPECT_EQ(fleet.moving(), 3);
  EXPECT_LT(fleet.time, 20.0);
}

TEST(Agreement, WhereHalfIsLostAndThereIsPatienceHardlyAnyGroupIsDivided) {
  int divided = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Rng rng = Rng{seed}.stream("fleet");
    Fleet fleet{cube(rng), 10.0};
    fleet.patience = 4.0;
    while (fleet.moving() == 0 && fleet.time < 1000.0)
      fleet.go_on([&](std::size_t, std::size_t) { return rng.uniform(0, 1) >= 0.5; });
    divided += fleet.moving() < 8 ? 1 : 0;
  }
  EXPECT_LE(divided, 1) << "five in a hundred and more, if they acknowledged to the last moment";
}

/// Two of three who are out of each other's reach, and one between them.
TEST(Agreement, WhoDoesNotHearSomebodyIsToldItsStateByWhoDoes) {
  Fleet fleet{three_in_a_plane(), 3.0};
  const auto by_the_middle = [](std::size_t from, std::size_t to) { return from == 1 || to == 1; };
  while (!fleet.is_done() && fleet.time < 900.0) fleet.go_on(by_the_middle);
  EXPECT_TRUE(fleet.is_done());
  EXPECT_GT(fleet.least, 3.0);
}

/// Whether a member that turns round in so long acknowledges a plan so long before its start.
bool acknowledges(double turn, double ahead) {
  std::vector<Member> all = three_in_a_plane();
  for (Member& member : all) member.turn = turn;
  Fleet fleet{all, 3.0}, before = fleet;
  while (std::ranges::none_of(fleet.members, has_plan)) {
    before = fleet;
    fleet.go_on(always);
  }
  const auto proposer = std::ranges::find_if(fleet.members, has_plan);
  // its state in an even turn, and in an odd one the plan
  const Speech state = proposer->say(fleet.time, fleet.time / 2.5);
  const Speech word = proposer->say(fleet.time + 0.1, fleet.time / 1.5);
  const double time = proposer->plan().start() - ahead;
  Agreement member = before.members[proposer == fleet.members.begin() ? 1 : 0];
  member.hear(state, time, time);
  member.hear(word, time, time);
  member.go_on(time, step, {{}, 3.0, time + 2.5}, 0.0);
  EXPECT_EQ(member.plan().epoch, proposer->plan().epoch);
  return !member.promised(time).empty();
}

TEST(Agreement, NobodyAcknowledgesWhatNotAllMightHearOf) {
  EXPECT_TRUE(acknowledges(1.0, 3.2));
  EXPECT_FALSE(acknowledges(1.0, 2.8)) << "its next turn may be after the start";
}

TEST(Agreement, NobodyAcknowledgesWhatLeavesItNoTimeToTurn) {
  EXPECT_TRUE(acknowledges(7.0, 7.2 - set_off));
  EXPECT_FALSE(acknowledges(7.0, 6.8 - set_off)) << "it has to have turned to its way when that goes";
}

TEST(Agreement, NobodyMovesWhileOneIsSilent) {
  Rng rng = Rng{1}.stream("fleet");
  Fleet fleet{cube(rng), 3.2};
  for (int i = 0; i < 3000; ++i) fleet.go_on([](std::size_t from, std::size_t) { return from != 5; });
  for (const Agreement& member : fleet.members) EXPECT_EQ(member.status(), Status::held);
}

/// Two of three that cross, and a third that is where the ways lead.
Fleet two_and_one_between() {
  std::vector<Member> all = three_in_a_plane();
  all[2].anchor = {-5.0, 14.0, 5.0};
  return Fleet{all, 3.0};
}

/// The least distance of the two to a place on what they do until `time`.
double least_to(Fleet& fleet, const Vec3& place, double time) {
  double nearest = never;
  while (fleet.time < time) {
    fleet.go_on(always);
    for (std::size_t i = 0; i < 2; ++i) nearest = std::min(nearest, (fleet.places[i] - place).norm());
  }
  return nearest;
}

TEST(Agreement, WhoHasArrivedNeedNotAcknowledgeAndIsKeptClearOf) {
  Fleet fleet = two_and_one_between();
  const Vec3 place{0.0, 1.0, 5.0};
  fleet.members[2].arrive(place);
  fleet.places[2] = fleet.members[2].member(2).anchor;
  EXPECT_GE(least_to(fleet, place, 200.0), 5.0);
  EXPECT_EQ(fleet.members[0].status(), Status::arrived);
  EXPECT_EQ(fleet.members[1].status(), Status::arrived);
}

TEST(Agreement, WhoIsLostDoesNotHoldTheOthersAndIsKeptClearOf) {
  Fleet fleet = two_and_one_between();
  const Vec3 place{0.0, 1.0, 5.0};
  fleet.members[2].lose(place, Vec3::Zero());
  EXPECT_GE(least_to(fleet, place, 200.0), 6.0) << "a metre more, since it promises nothing";
  EXPECT_EQ(fleet.members[0].status(), Status::arrived);
  EXPECT_EQ(fleet.members[1].status(), Status::arrived);
  EXPECT_EQ(fleet.members[2].status(), Status::lost);
}

TEST(Agreement, WhoIsHeldElsewhereTellsWhereBeforeAnythingElse) {
  for (int steps = 1; steps <= 60; ++steps) {
    Fleet fleet{three_in_a_plane(), 12.0};  // a search ends long before a turn
    const auto all_heard = [](std::size_t, std::size_t) { return true; };
    while (fleet.moving() < 3 && fleet.time < 200.0) fleet.go_on(all_heard);
    ASSERT_EQ(fleet.moving(), 3);
    for (int i = 0; i < steps; ++i) fleet.go_on(all_heard);
    Member stopped = fleet.members[0].member(0);
    stopped.anchor = fleet.places[0];
    fleet.members[0].hold(stopped);
    for (const double told = fleet.time + fleet.turn_period + 2.0 * step; fleet.time < told;)
      fleet.go_on(all_heard);
    EXPECT_LT((fleet.members[1].member(0).anchor - fleet.places[0]).norm(), 0.05)
        << "stopped " << steps << " steps after it set out";
  }
}

TEST(Agreement, WhoHearsThatSomebodyIsLostPassesItOnOnce) {
  Fleet fleet{three_in_a_plane(), 3.0};
  while (fleet.moving() < 3 && fleet.time < 200.0) fleet.go_on(always);
  ASSERT_EQ(fleet.moving(), 3);
  fleet.members[2].lose(fleet.places[2], Vec3::Zero());
  const auto not_from_2_to_0 = [](std::size_t from, std::size_t to) { return from != 2 || to != 0; };
  for (const double end = fleet.time + 2.0 * fleet.turn_period; fleet.time < end;) {
    fleet.go_on(not_from_2_to_0);
    if (!fleet.members[1].is_lost(2)) EXPECT_FALSE(fleet.members[0].is_lost(2));
  }
  EXPECT_TRUE(fleet.members[0].is_lost(2));
  const auto is_own = [&](double time) {
    const Agreement& member = fleet.members[1];
    return header_of(*decode(member.say(time, fleet.turn_period), member.terms().datum, time)).sender == 1;
  };
  EXPECT_TRUE(is_own(fleet.time) || is_own(fleet.time + fleet.turn_period)) << "of two turns one is its own";
}

TEST(Agreement, WhereALostMemberDriftsIsForetold) {
  Fleet fleet = two_and_one_between();
  const Vec3 here = fleet.members[0].member(0).anchor;
  fleet.members[2].lose(here + Vec3{0, 20, 0}, {0, -0.5, 0});
  for (int i = 0; i < 20; ++i) fleet.go_on(always);
  const Agreement& member = fleet.members[0];
  ASSERT_TRUE(member.is_lost(2));
  const Reference own{here};
  EXPECT_FALSE(member.meets_lost(own, fleet.time, fleet.time + 10.0));
  EXPECT_TRUE(member.meets_lost(own, fleet.time, fleet.time + 40.0));
}

TEST(Agreement, WhoHasNotBeenHeardSinceItMayHaveDepartedIsReckonedWithOnItsWay) {
  Fleet fleet{three_in_a_plane(), 3.0};
  const auto until_2_moves = [&](std::size_t from, std::size_t to) {
    return to != 0 || from != 2 || fleet.members[2].status() != Status::moving;
  };
  while (fleet.moving() < 3 && fleet.time < 200.0) fleet.go_on(until_2_moves);
  ASSERT_EQ(fleet.moving(), 3);
  for (int i = 0; i < 40; ++i) fleet.go_on([](std::size_t, std::size_t to) { return to != 0; });
  const Agreement& member = fleet.members[0];
  EXPECT_LT((member.whereabouts(2).at(fleet.time) - fleet.places[2]).norm(), 0.1);
  const Reference ahead{fleet.members[2].way()->at(fleet.time + 5.0)};
  EXPECT_TRUE(member.meets_moving(ahead, fleet.time, fleet.time + 10.0));
  // until it tells that it has stopped
  Member stopped = fleet.members[2].own();
  stopped.anchor = fleet.places[2];
  fleet.members[2].hold(stopped);
  for (int i = 0; i < 40; ++i) fleet.go_on(always);
  EXPECT_LT((member.whereabouts(2).at(fleet.time) - stopped.anchor).norm(), 0.1);
}

TEST(Agreement, KeepsTheFartherOffWhoIsLostTheLongerAgoThatToldWhereItIs) {
  Fleet fleet = two_and_one_between();
  const double told = fleet.members[0].evades_by(2, fleet.time);
  fleet.members[2].lose(fleet.places[2], Vec3::Zero());
  for (int i = 0; i < 20; ++i) fleet.go_on(always);
  ASSERT_TRUE(fleet.members[0].is_lost(2));
  const double soon = fleet.members[0].evades_by(2, fleet.time);
  EXPECT_GT(soon, told);
  EXPECT_NEAR(fleet.members[0].evades_by(2, fleet.time + 10.0), soon + 1.0, 1e-9);
  EXPECT_LT(fleet.members[0].evades_by(2, fleet.time + 1000.0), soon + 3.1) << "it is not kept off for ever";
}

TEST(Agreement, AClockThatJumpsOverAStartHoldsItsMember) {
  Fleet fleet{three_in_a_plane(), 3.0};
  while (!fleet.members[0].plan().epoch) fleet.go_on(always);
  const double start = fleet.members[0].plan().start();
  while (fleet.time < start - 0.5) fleet.go_on(always);
  Agreement jumped = fleet.members[0], punctual = fleet.members[0];
  punctual.go_on(start + 0.1, step, {{}, 3.0, start + 1.0}, 0.0);
  EXPECT_EQ(punctual.status(), Status::moving);
  jumped.go_on(start + 5.0, step, {{}, 3.0, start + 6.0}, 0.0);
  EXPECT_EQ(jumped.status(), Status::held);
}

TEST(Agreement, WhoIsSilentAfterItHasGoneIsTakenToHaveArrivedWhereItsWayEnds) {
  Fleet fleet{three_in_a_plane(), 3.0};
  const auto without_2 = [&](std::size_t from, std::size_t) {
    return from != 2 || fleet.members[2].status() != Status::arrived;
  };
  while (!fleet.is_done() && fleet.time < 300.0) fleet.go_on(without_2);
  ASSERT_TRUE(fleet.is_done());
  for (int i = 0; i < 200; ++i) fleet.go_on(without_2);
  const Reference known = fleet.members[0].whereabouts(2);
  ASSERT_FALSE(known.empty());
  EXPECT_LT((known.at(fleet.time) - fleet.places[2]).norm(), 0.9) << "it arrives that long before its end";
  // and nobody waits for its acknowledgement any more
  const Vec3 down = fleet.places[0] + Vec3{0, 0, 10};
  fleet.members[0].hold(crossing(fleet.places[0], down));
  for (int i = 0; i < 500; ++i) fleet.go_on(without_2);
  EXPECT_LT((fleet.places[0] - down).norm(), 3.1);
}

TEST(Agreement, AWordIsOfTheTimeAtWhichItWasSentAndNotHeardWhenThatIsLongAgo) {
  const std::vector<Member> all = three_in_a_plane();
  const Terms terms{.count = all.size()};
  Agreement speaker{1, terms};
  speaker.hold(all[1]);
  const Speech word = speaker.say(10.0, 3.0);
  const auto heard_at = [&](double now) {
    Agreement listener{0, terms};
    listener.hold(all[0]);
    EXPECT_EQ(listener.hear(word, 10.0, now), Hearing::taken);
    return !listener.whereabouts(1).empty();
  };
  EXPECT_TRUE(heard_at(10.5));
  EXPECT_TRUE(heard_at(150.0));
  for (const double now : {300.0, 419.0, 420.0, 829.0}) EXPECT_FALSE(heard_at(now)) << now;
}

TEST(Agreement, WhoIsLostIsSpokenOfInEveryOtherTurnByWhoeverIsOnItsWay) {
  Fleet fleet{three_in_a_plane(), 3.0};
  while (fleet.moving() < 3) fleet.go_on(always);
  const double lost_at = fleet.time;
  int own = 0, passed_on = 0;
  while (fleet.time < lost_at + 24.0) {
    fleet.members[0].lose(fleet.places[0], {0.0, 0.0, 0.1});
    fleet.go_on(always);
    const double now = fleet.time;
    if (now < lost_at + 6.0 || !fleet.has_turn(1)) continue;
    const auto word = decode(fleet.members[1].say(now, 3.0), Vec2::Zero(), now);
    ASSERT_TRUE(word.has_value());
    ASSERT_EQ(fleet.members[1].status(), Status::moving);
    const Header& header = header_of(*word);
    ++(header.sender == 0 && header.status == Status::lost ? passed_on : own);
  }
  EXPECT_GE(own, 2);
  EXPECT_GE(passed_on, 2);
  EXPECT_LE(std::abs(own - passed_on), 1);
}

TEST(Agreement, IsTheSameWheneverItIsCopied) {
  Rng rng = Rng{2}.stream("fleet");
  Fleet fleet{cube(rng), 3.2};
  for (int i = 0; i < 60; ++i) fleet.go_on(always);
  Fleet copy = fleet;
  for (int i = 0; i < 400; ++i) {
    fleet.go_on(always);
    copy.go_on(always);
  }
  EXPECT_EQ(fleet.places, copy.places);
}

}  // namespace
}  // namespace fairway::pledge
