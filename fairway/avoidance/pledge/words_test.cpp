// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/words.hpp"

#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"

namespace fairway::pledge {
namespace {

const Vec2 datum{100.0, -50.0};

Member any_member(Rng& rng) {
  const auto place = [&] {
    return Vec3{datum.x() + rng.uniform(-160, 160), datum.y() + rng.uniform(-160, 160), rng.uniform(0, 300)};
  };
  return {.anchor = place(),
          .destination = place(),
          .arrival = rng.uniform(0, 7),
          .radius = rng.uniform(0.1, 10),
          .speed = rng.uniform(0.1, 1.2),
          .climb = rng.uniform(0.05, 0.6),
          .descent = rng.uniform(0.05, 0.6),
          .turn = rng.uniform(0, 15)};
}

Header any_header(Rng& rng, double now) {
  return {.sender = static_cast<std::uint8_t>(rng.uniform(0, 32)),
          .round = static_cast<std::uint8_t>(rng.uniform(0, 4)),
          .epoch = {static_cast<std::int64_t>(10.0 * now + rng.uniform(-300'000, 10'000)),
                    static_cast<std::uint8_t>(rng.uniform(0, 8))},
          .sent = now - rng.uniform(0, 200),
          .status = Status::moving,
          .acknowledged = static_cast<unsigned>(rng.uniform(0, 256)),
          .departed = static_cast<unsigned>(rng.uniform(0, 256)),
          .heard = static_cast<unsigned>(rng.uniform(0, 256))};
}

void expect_same(const Header& a, const Header& b) {
  EXPECT_EQ(a.sender, b.sender);
  EXPECT_EQ(a.round, b.round);
  EXPECT_EQ(a.epoch, b.epoch);
  EXPECT_NEAR(a.sent, b.sent, 0.0501);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.acknowledged, b.acknowledged);
  EXPECT_EQ(a.departed, b.departed);
  EXPECT_EQ(a.heard, b.heard);
}

TEST(Words, AStateComesOutAsItWentInUpToItsSteps) {
  Rng rng = Rng{1}.stream("words");
  for (int i = 0; i < 1000; ++i) {
    const double now = rng.uniform(0, 5000);
    const StateWord said{any_header(rng, now), any_member(rng)};
    const Speech speech = encode(said, datum);
    EXPECT_LE(speech.size, Speech::most_bytes);
    const std::optional<Word> heard = decode(speech, datum, now);
    ASSERT_TRUE(heard && std::holds_alternative<StateWord>(*heard));
    const auto& word = std::get<StateWord>(*heard);
    expect_same(word.header, said.header);
    EXPECT_LT((word.member.anchor - said.member.anchor).norm(), 0.018);
    EXPECT_LT((word.member.destination - said.member.destination).norm(), 0.09);
    EXPECT_NEAR(word.member.speed, said.member.speed, 0.0101);
    EXPECT_GE(word.member.radius, said.member.radius - 1e-6) << "nobody is told to be smaller than it is";
    EXPECT_LT(word.member.radius, said.member.radius + 0.25);
    EXPECT_EQ(as_told(word.member, datum), word.member) << "what was told once is told alike for ever";
  }
}

TEST(Words, ASpeedIsToldAsTheNearestUnlessThatIsMoreThanMayBe) {
  for (const double speed : {0.02, 0.06, 0.3, 0.5, 0.58, 1.0, 1.2}) {
    EXPECT_NEAR(speed_as_told(speed, speed), speed, 1e-12);
    EXPECT_NEAR(speed_as_told(speed + 0.0099, 2.0), speed, 1e-12);
    EXPECT_NEAR(speed_as_told(speed - 0.0099, speed), speed, 1e-12);
    EXPECT_NEAR(speed_as_told(speed - 0.0099, speed - 0.005), speed - 0.02, 1e-12);
  }
  for (const double rate : {0.03, 0.07, 0.29, 0.57}) {
    EXPECT_NEAR(climb_as_told(rate, rate), rate, 1e-12);
    EXPECT_NEAR(climb_as_told(rate - 0.004, rate - 0.001), rate - 0.01, 1e-12);
  }
  EXPECT_EQ(speed_as_told(0.015, 0.015), 0.0);
  EXPECT_EQ(speed_as_told(-0.1, 0.0), 0.0);
}

TEST(Words, APlanComesOutAsItWentIn) {
  Rng rng = Rng{2}.stream("words");
  for (int i = 0; i < 1000; ++i) {
    const double now = rng.uniform(0, 5000);
    PlanWord said{any_header(rng, now),
                  {.scale = static_cast<std::uint8_t>(rng.uniform(0, 4)), .to_port = i % 2 == 0}};
    said.plan.epoch = said.header.epoch;
    said.plan.centre = centre_as_told(datum + Vec2{rng.uniform(-150, 150), rng.uniform(-150, 150)}, datum);
    said.plan.participants = static_cast<unsigned>(rng.uniform(0, 256));
    for (Code& code : said.plan.codes) code = Code::of(static_cast<std::uint8_t>(rng.uniform(0, 256)));
    said.plan.digest = static_cast<std::uint32_t>(rng.uniform(0, 0x1000000));
    const std::optional<Word> heard = decode(encode(said, datum), datum, now);
    ASSERT_TRUE(heard && std::holds_alternative<PlanWord>(*heard));
    const auto& word = std::get<PlanWord>(*heard);
    expect_same(word.header, said.header);
    EXPECT_LT((word.plan.centre - said.plan.centre).norm(), 1e-9);
    Plan plan = word.plan;
    plan.centre = said.plan.centre;
    EXPECT_EQ(plan, said.plan);
  }
}

TEST(Words, AnEpochComesOutAsItWentInHoweverLongItHasBeen) {
  for (const double now : {0.0, 209'715.1, 209'715.3, 1e6, 31'557'600.0, -5000.0}) {
    for (const double ahead : {-35'000.0, -0.1, 0.0, 0.1, 100.0, 990.0}) {
      const Epoch epoch{static_cast<std::int64_t>(10.0 * (now + ahead)), 5};
      const std::optional<Word> word =
          decode(encode(StateWord{{.epoch = epoch, .sent = now}, {}}, datum), datum, now);
      ASSERT_TRUE(word) << now << " " << ahead;
      EXPECT_EQ(std::get<StateWord>(*word).header.epoch, epoch) << now << " " << ahead;
    }
    const Epoch too_far{static_cast<std::int64_t>(10.0 * (now + 2000.0)), 5};
    EXPECT_FALSE(decode(encode(StateWord{{.epoch = too_far, .sent = now}, {}}, datum), datum, now));
  }
  const std::optional<Word> none = decode(encode(StateWord{}, datum), datum, 0.0);
  ASSERT_TRUE(none);
  EXPECT_FALSE(std::get<StateWord>(*none).header.epoch);
  EXPECT_LT(Epoch{}, (Epoch{-100, 0})) << "no plan is before any";
  EXPECT_LT((Epoch{100, 7}), (Epoch{101, 0}));
  EXPECT_LT((Epoch{100, 6}), (Epoch{100, 7}));
}

TEST(Words, WhatWasDamagedOrIsNoneIsRefused) {
  Rng rng = Rng{3}.stream("words");
  const StateWord said{any_header(rng, 10.0), any_member(rng)};
  const Speech whole = encode(said, datum);
  for (std::size_t one = 0; one < 8 * Speech::most_bytes; ++one) {
    Speech damaged = whole;
    damaged.bytes[one / 8] ^= static_cast<std::uint8_t>(1U << one % 8);
    EXPECT_FALSE(decode(damaged, datum, 10.0)) << one;
    for (std::size_t two = 0; two < one; ++two) {
      Speech more = damaged;
      more.bytes[two / 8] ^= static_cast<std::uint8_t>(1U << two % 8);
      EXPECT_FALSE(decode(more, datum, 10.0)) << one << " and " << two;
    }
  }
  Speech shorter = whole;
  --shorter.size;
  EXPECT_FALSE(decode(shorter, datum, 10.0));
  EXPECT_FALSE(decode(Speech{}, datum, 10.0));
  int taken = 0;
  for (int i = 0; i < 100'000; ++i) {
    Speech noise{.size = Speech::most_bytes};
    for (std::uint8_t& byte : noise.bytes) byte = static_cast<std::uint8_t>(rng.uniform(0, 256));
    taken += decode(noise, datum, 10.0) ? 1 : 0;
  }
  EXPECT_LT(taken, 100)
      << "of bytes at random, 1 in 4 is of this version and of them 1 in 256 has the right sum";
}

TEST(Words, TooFarFromTheDatumTooLargeOrTooSlowDoesNotFit) {
  Member member{
      .anchor = {datum.x(), datum.y(), 10}, .destination = {datum.x() + 50, datum.y(), 10}, .speed = 0.3};
  EXPECT_TRUE(fits(member, datum));
  member.radius = 15.75;
  EXPECT_TRUE(fits(member, datum));
  member.radius = 15.8;
  EXPECT_FALSE(fits(member, datum));
  member.radius = 1.5;
  member.turn = 15.5;
  EXPECT_TRUE(fits(member, datum));
  member.turn = 32.9;
  EXPECT_FALSE(fits(member, datum));
  member.turn = 8.0;
  member.destination.z() = 12;
  EXPECT_FALSE(fits(member, datum)) << "it cannot dive";
  member.descent = 0.1;
  EXPECT_TRUE(fits(member, datum));
  member.speed = 0.0;
  EXPECT_FALSE(fits(member, datum));
  member.speed = 0.3;
  member.destination.x() = datum.x() + 163;
  EXPECT_TRUE(fits(member, datum));
  member.destination.x() = datum.x() + 170;
  EXPECT_FALSE(fits(member, datum)) << "it will be held there";
  member.destination.x() = datum.x() + 50;
  member.anchor.x() += 200;
  EXPECT_FALSE(fits(member, datum));
}

}  // namespace
}  // namespace fairway::pledge
