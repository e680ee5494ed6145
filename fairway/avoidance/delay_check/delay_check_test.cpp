// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/delay_check/delay_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::delay_check {
namespace {

using encounters::OwnedSituation;

TEST(DelayCheck, AWordComesOutAsItWentInUpToItsSteps) {
  Rng rng = Rng{1}.stream("words");
  const Vec2 datum{100.0, -50.0};
  for (int i = 0; i < 1000; ++i) {
    const double now = rng.uniform(0, 5000);
    const auto place = [&] {
      return Vec3{100 + rng.uniform(-160, 160), -50 + rng.uniform(-160, 160), rng.uniform(0, 300)};
    };
    Word said{.radius = 1.5, .committed = {place(), place(), now - 20.0, now + rng.uniform(1, 100)}};
    said.next = Trajectory{.to = place(), .departs = now + 30.0, .ends = now + 90.0};
    const Speech speech = encode(said, datum, now);
    EXPECT_LE(speech.size, Speech::most_bytes);
    const std::optional<Word> heard = decode(speech, datum, now + 3.0);
    ASSERT_TRUE(heard && heard->next);
    EXPECT_EQ(heard->radius, 1.5);
    EXPECT_LT((heard->committed.from - said.committed.from).norm(), 0.018);
    EXPECT_LT((heard->committed.to - said.committed.to).norm(), 0.018);
    EXPECT_NEAR(heard->committed.departs, said.committed.departs, 0.0501);
    EXPECT_NEAR(heard->committed.ends, said.committed.ends, 0.0501);
    EXPECT_LT((heard->next->to - said.next->to).norm(), 0.018);
    EXPECT_EQ(heard->next->from, heard->committed.reference().at(heard->next->departs));
    EXPECT_EQ(as_told(*heard, datum, now).committed, heard->committed)
        << "what was told once is told so again";
  }
}

TEST(DelayCheck, NobodyIsToldSmallerThanItIs) {
  for (const double radius : {0.12, 1.0, 1.12, 1.37, 1.5, 15.7}) {
    const Word told = as_told({.radius = radius, .committed = {}}, Vec2::Zero(), 0.0);
    EXPECT_GE(told.radius, radius - 1e-6);
    EXPECT_LT(told.radius, radius + 0.25);
  }
}

TEST(DelayCheck, WhatHasEndedIsToldAsStandingHoweverLongAgo) {
  const Word said{.radius = 1.0, .committed = {{0, 0, 5}, {10, 0, 5}, 100.0, 130.0}};
  const Word told = as_told(said, Vec2::Zero(), 5000.0);
  EXPECT_LT((told.committed.reference().at(5000.0) - Vec3{10, 0, 5}).norm(), 0.02);
  EXPECT_EQ(told.committed.from, told.committed.to);
}

TEST(DelayCheck, WhoWasNotAskedForLongStandsWhereItIsNow) {
  const Link link{.heard = {}, .turn_period = 3.2, .next_turn = 1e9};
  fairway::DelayCheck method;
  fairway::DelayCheck::Memory memory;
  Rng rng{1};
  Context context{rng};
  Situation s{.time = 10.0, .period = 0.1};
  s.own = {.id = VehicleId{0}, .position = {0, 0, 5}, .radius = 1.0};
  s.goal = {.position = {40, 0, 5}, .cruise_speed = 0.5, .arrival = 1.0};
  s.limits = {.max_speed = 0.5, .max_climb_rate = 0.3};
  s.link = &link;
  s.attendance = Attendance::under_way;
  const auto stands_at = [&](double time, const Vec3& place) {
    s.time = time;
    s.own.position = place;
    method.decide(s, memory, context);
    return memory.own.committed.to;
  };
  EXPECT_LT((stands_at(10.0, {0, 0, 5}) - Vec3{0, 0, 5}).norm(), 0.05);
  EXPECT_LT((stands_at(10.5, {1, 0, 5}) - Vec3{0, 0, 5}).norm(), 0.05) << "it is set aside, and comes back";
  EXPECT_LT((stands_at(60.0, {0, 80, 5}) - Vec3{0, 80, 5}).norm(), 0.05) << "it was taken there by hand";
}

TEST(DelayCheck, AWordIsOfTheTimeAtWhichItWasSentHoweverLateItIsHeard) {
  const Word said{.radius = 1.0, .committed = {{60, 0, 5}, {0, 0, 5}, 1.0, 100.0}};
  std::array<Heard, 1> heard{
      {{.from = VehicleId{1}, .sent = 1.0, .speech = encode(said, Vec2::Zero(), 1.0)}}};
  const Link link{.heard = heard, .turn_period = 3.2, .next_turn = 1e9};
  for (const double begins : {110.0, 310.0, 420.0}) {
    fairway::DelayCheck method;
    fairway::DelayCheck::Memory memory;
    Rng rng{1};
    Context context{rng};
    Situation s{.time = begins, .period = 0.1};
    s.own = {.id = VehicleId{0}, .position = {0, 10, 5}, .radius = 1.0};
    s.goal = {.position = {40, 10, 5}, .cruise_speed = 0.5, .arrival = 1.0};
    s.limits = {.max_speed = 0.5, .max_climb_rate = 0.3};
    s.link = &link;
    s.attendance = Attendance::under_way;
    method.decide(s, memory, context);
    ASSERT_EQ(memory.count, 1U);
    const Vec3 there = memory.others[0].word.committed.reference().at(begins);
    EXPECT_LT((there - Vec3{0, 0, 5}).norm(), 0.05) << begins;
  }
}

TEST(DelayCheck, ADamagedWordIsRefused) {
  Speech speech = encode({.radius = 1.0}, Vec2::Zero(), 0.0);
  for (std::size_t bit = 0; bit < 8 * Speech::most_bytes; ++bit) {
    Speech damaged = speech;
    damaged.bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(decode(damaged, Vec2::Zero(), 0.0)) << bit;
  }
  speech.size = 24;
  EXPECT_FALSE(decode(speech, Vec2::Zero(), 0.0));
}

TEST(DelayCheckWord, IsReadInPlainWords) {
  const DelayCheck method{};
  const auto read = [&](const Word& word, double now) {
    return method.reading({VehicleId{1}, now, encode(word, Vec2::Zero(), now)}).text;
  };
  const Word word{.radius = 1.0, .committed = Trajectory::standing({1, 2, 5}, 10.0)};
  EXPECT_EQ(read(word, 10.0), "stands at [1, 2, 5] m NED");
  EXPECT_EQ(
      read({.radius = 1.0,
            .committed = {{0, 0, 5}, {10, 0, 5}, 12.0, 32.0},
            .next = Trajectory{{10, 0, 5}, {10, 8, 5}, 32.0, 48.0}},
           10.0),
      "has committed itself to go to [10, 0, 5] m NED from 12 s to 32 s; will go to [10, 8, 5] m NED from "
      "32 s to 48 s if nothing speaks against it");
  EXPECT_EQ(method.reading({VehicleId{1}, 0.0, {.bytes = {1, 2}, .size = 2}}).text,
            "not a word of delay_check");
}

/// Two points that do what they are told and swap places, and a modem that loses what it is told to.
struct Pair {
  static constexpr double period = 0.2, turn_period = 4.0;
  std::vector<Avoider> avoiders{Avoider{DelayCheck{}, Rng{1}}, Avoider{DelayCheck{}, Rng{2}}};
  std::vector<OwnedSituation> seen{encounters::open_water(0.0), encounters::open_water(0.0)};
  std::vector<std::vector<Heard>> heard{2};
  double time{0.0};
  double least{1e9};
  bool at_once{false};  ///< both speak at every decision, instead of in turns

  Pair() {
    for (std::size_t i = 0; i < 2; ++i) {
      Situation& s = seen[i].situation;
      const double side = i == 0 ? -15.0 : 15.0;
      s.own.id = VehicleId{static_cast<std::uint32_t>(i)};
      s.own.position = {side, 0, 5};
      s.goal = {.position = {-side, 0, 5}, .cruise_speed = 0.5, .arrival = 1.0};
      s.limits.max_speed = 0.5;
      s.period = period;
    }
  }

  double next_turn(std::size_t i) const {
    const double first = 0.5 * turn_period * static_cast<double>(i);
    return first + turn_period * std::ceil((time - first) / turn_period + 1e-6);
  }

  void go_on(const std::function<bool(std::size_t from)>& gets_through) {
    for (std::size_t i = 0; i < 2; ++i) {
      const bool is_in_turn = time > 0.0 && next_turn(i) - turn_period > time - period - 1e-6;
      const bool has_turn = at_once || is_in_turn;
      const Speech speech = avoiders[i].speech();
      if (has_turn && !speech.empty() && gets_through(i))
        heard[1 - i] = {{VehicleId{static_cast<std::uint32_t>(i)}, time, speech}};
    }
    for (std::size_t i = 0; i < 2; ++i) {
      Situation s = seen[i];
      const Link link{heard[i], at_once ? period : turn_period, at_once ? time : next_turn(i)};
      s.link = &link;
      s.time = time;
      const Command command = avoiders[i].decide(s);
      Ownship& own = seen[i].situation.own;
      own.velocity = command.velocity;
      own.position += period * command.velocity;
      own.yaw += period * command.turn_rate.value_or(0.0);
    }
    least = std::min(least, (seen[0].situation.own.position - seen[1].situation.own.position).norm());
    time += period;
  }

  double to_goal(std::size_t i) const {
    return (seen[i].situation.goal.position - seen[i].situation.own.position).norm();
  }
};

TEST(DelayCheck, TwoThatHearEachOtherSwapPlacesAndKeepApart) {
  Pair pair;
  while (pair.time < 600.0) pair.go_on([](std::size_t) { return true; });
  EXPECT_GE(pair.least, 2.0 + 1.0);
  EXPECT_LT(pair.to_goal(0), 2.0);
  EXPECT_LT(pair.to_goal(1), 2.0);
}

TEST(DelayCheck, WhoIsKeptOnItsWayStandsAndSaysSo) {
  Pair pair;
  const auto all = [](std::size_t) { return true; };
  while (pair.seen[0].situation.own.velocity.norm() < 0.3) pair.go_on(all);
  Situation& s = pair.seen[0].situation;
  s.attendance = Attendance::kept;
  const Vec3 stopped = s.own.position;
  while (pair.time < 120.0) pair.go_on(all);
  EXPECT_LT((s.own.position - stopped).norm(), 2.0);
  const std::optional<Word> word = decode(pair.heard[1][0].speech, Vec2::Zero(), pair.time);
  ASSERT_TRUE(word);
  EXPECT_EQ(word->committed.from, word->committed.to);
  EXPECT_LT((word->committed.to - s.own.position).norm(), 0.5);
  EXPECT_FALSE(word->next);
}

TEST(DelayCheck, NobodyPromisesALegThatTakesLongerThanAWordCanTell) {
  Pair pair;
  for (std::size_t i = 0; i < 2; ++i) {
    Situation& s = pair.seen[i].situation;
    s.own.position *= 4.0;
    s.goal.position *= 4.0;
    s.own.position.z() = s.goal.position.z() = 5.0;
  }
  while (pair.time < 900.0) {
    pair.go_on([](std::size_t) { return true; });
    const auto word = decode(pair.avoiders[0].speech(), Vec2::Zero(), pair.time);
    if (!word || !word->next) continue;
    EXPECT_GT(word->next->ends, word->next->departs) << pair.time;
  }
  EXPECT_GE(pair.least, 2.0 + 1.0);
  EXPECT_LT(pair.to_goal(0), 2.0);
  EXPECT_LT(pair.to_goal(1), 2.0);
}

TEST(DelayCheck, WhoHearsOfMoreThanItKeepsInMindPlansNothing) {
  for (const std::size_t others : {DelayCheck::most_others, DelayCheck::most_others + 1}) {
    Pair pair;
    for (std::size_t i = 0; i < others; ++i) {
      const Vec3 place{100.0, static_cast<double>(i), 5.0};
      const Word word{.radius = 1.0, .committed = Trajectory::standing(place, 0.0)};
      pair.heard[0].push_back(
          {VehicleId{static_cast<std::uint32_t>(i + 1)}, 0.0, encode(word, Vec2::Zero(), 0.0)});
    }
    while (pair.time < 60.0) pair.go_on([](std::size_t) { return false; });
    EXPECT_EQ(pair.to_goal(0) < 25.0, others == DelayCheck::most_others) << others;
  }
}

TEST(DelayCheck, TwoWhoSpeakAtOncePlanOneAfterTheOther) {
  Pair pair;
  pair.at_once = true;
  std::array<bool, 2> had{};
  int plans = 0;
  while (pair.time < 300.0) {
    pair.go_on([](std::size_t) { return true; });
    std::array<bool, 2> begins{};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto word = decode(pair.avoiders[i].speech(), Vec2::Zero(), pair.time);
      const bool has = word && word->next;
      begins[i] = has && !had[i];
      had[i] = has;
      plans += begins[i] ? 1 : 0;
    }
    EXPECT_FALSE(begins[0] && begins[1]) << pair.time;
  }
  EXPECT_GT(plans, 1);
  EXPECT_LT(pair.to_goal(0), 2.0);
  EXPECT_LT(pair.to_goal(1), 2.0);
}

TEST(DelayCheck, TwoThatDoNotHearEachOtherCommitAndMeet) {
  Pair pair;
  while (pair.time < 200.0) pair.go_on([](std::size_t) { return false; });
  EXPECT_LT(pair.least, 2.0) << "no word, no conflict: what is safe rests on the delay alone";
}

TEST(DelayCheck, WhoCommitsHasSaidSoAsLongBefore) {
  Pair pair;
  double said = 0.0, went = 0.0;
  while (pair.time < 60.0 && went == 0.0) {
    pair.go_on([](std::size_t) { return true; });
    const auto word = decode(pair.avoiders[0].speech(), Vec2::Zero(), pair.time);
    if (said == 0.0 && word && word->next) said = pair.time;
    if (pair.seen[0].situation.own.velocity.norm() > 0.2) went = pair.time;
  }
  ASSERT_GT(said, 0.0);
  EXPECT_GE(went - said, 1.3 * Pair::turn_period - Pair::period);
}

}  // namespace
}  // namespace fairway::delay_check
