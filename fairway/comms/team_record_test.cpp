// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/team_record.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

constexpr double period = 0.05;
constexpr std::int32_t last = std::numeric_limits<std::int32_t>::max();
constexpr double rounding = 1e-9;

Vec3 drawn(Rng& rng, const Vec3& span) {
  return {rng.uniform(-span.x(), span.x()), rng.uniform(-span.y(), span.y()),
          rng.uniform(-span.z(), span.z())};
}

/// Anything that the record holds.
Message ordinary(Rng& rng) {
  Message message{.from = VehicleId{static_cast<std::uint32_t>(rng.index(1024))},
                  .sent = Tick{static_cast<std::int64_t>(rng.index(2'000'000))}};
  message.position = drawn(rng, {83'000, 83'000, 20'000});
  message.velocity = drawn(rng, {20, 20, 20});
  message.yaw = rng.uniform(-pi, pi);
  message.radius = rng.uniform(0, 51);
  message.priority = static_cast<std::int32_t>(rng.index(1023)) - 512;
  if (rng.index(2) == 1) message.destination = message.position + drawn(rng, {2000, 2000, 500});
  return message;
}

/// As received without delay.
Message told(const Message& message) { return decode(encode(message, period), message.sent, period); }

double farthest_component(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

TEST(TeamRecord, TenThousandMessagesAreToldWithinHalfAStep) {
  Rng rng{11};
  for (int i = 0; i < 10'000; ++i) {
    const Message message = ordinary(rng);
    const Message read = told(message);
    SCOPED_TRACE(i);
    ASSERT_EQ(read.from, message.from);
    ASSERT_EQ(read.sent, message.sent);
    ASSERT_LE(farthest_component(read.position, message.position), 0.005 + rounding);
    ASSERT_LE(farthest_component(read.velocity, message.velocity), 0.005 + rounding);
    ASSERT_LE(std::fabs(wrap_angle(read.yaw - message.yaw)), pi / 256 + rounding);
    ASSERT_GE(read.radius, message.radius - rounding);
    ASSERT_LT(read.radius, message.radius + 0.1);
    ASSERT_EQ(read.priority, message.priority);
    ASSERT_EQ(read.destination.has_value(), message.destination.has_value());
    ASSERT_TRUE(read.told);
    if (message.destination) {
      ASSERT_LE(farthest_component(*read.destination, *message.destination), 0.125 + rounding);
    }
  }
}

TEST(TeamRecord, WhatWasToldIsToldAgainUnchanged) {
  Rng rng{12};
  for (int i = 0; i < 1000; ++i) {
    const TeamRecord record = encode(ordinary(rng), 0.02);
    ASSERT_EQ(encode(decode(record, Tick{2'000'000}, 0.02), 0.02), record) << i;
  }
}

TEST(TeamRecord, ItsTwentyFiveBytesAreThese) {
  Message message{.from = VehicleId{5}, .sent = Tick{0}};
  message.position = {-0.01, 0.01, 1.0};
  message.priority = last;
  const TeamRecord record = encode(message, period);
  // 10 bits of id, 16 of time, 24 of north: 0000000101 0000000000000000 111111111111111111111111
  const std::array<std::uint8_t, 7> beginning{0x01, 0x40, 0x00, 0x3F, 0xFF, 0xFF, 0xC0};
  EXPECT_TRUE(std::equal(beginning.begin(), beginning.end(), record.begin()));
  EXPECT_EQ(record.size(), 25U);
}

TEST(TeamRecord, APositionBeyondTheRecordIsTheNearestThatFits) {
  Message message;
  message.position = {1e7, -1e7, 1e6};
  EXPECT_LT(farthest_component(told(message).position, {83886.07, -83886.07, 20971.51}), rounding);
}

TEST(TeamRecord, ATooFastVelocityKeepsItsDirection) {
  Message message;
  message.velocity = {40.94, -20.47, 0};
  EXPECT_LT(farthest_component(told(message).velocity, {20.47, -10.235, 0}), 0.005 + rounding);
}

TEST(TeamRecord, AFarDestinationLiesOnTheLineToIt) {
  Message message;
  message.position = {100, 0, 10};
  message.destination = Vec3{100 + 4 * 2047.75, 2047.75, 10};
  EXPECT_LT(farthest_component(*told(message).destination, {100 + 2047.75, 511.9375, 10}), 0.125 + rounding);
}

TEST(TeamRecord, ARadiusIsNeverToldSmallerUnlessItDoesNotFit) {
  Message message;
  for (const double radius : {0.0, 1.1, 1.5, 2.0, 3.3, 51.1}) {
    message.radius = radius;
    EXPECT_DOUBLE_EQ(told(message).radius, radius);
  }
  message.radius = 1.11;
  EXPECT_DOUBLE_EQ(told(message).radius, 1.2);
  message.radius = 900;
  EXPECT_DOUBLE_EQ(told(message).radius, 51.1);
}

TEST(TeamRecord, PrioritiesKeepTheirOrderAndWhoHasArrivedIsLast) {
  Message message;
  const std::vector<std::pair<std::int32_t, std::int32_t>> expected{
      {std::numeric_limits<std::int32_t>::min(), -512},
      {-513, -512},
      {-512, -512},
      {0, 0},
      {510, 510},
      {511, 510},
      {last - 1, 510},
      {last, last}};
  for (const auto& [said, read] : expected) {
    message.priority = said;
    EXPECT_EQ(told(message).priority, read);
  }
}

TEST(TeamRecord, TheTimeIsThatBeforeNowUpToTwentyMinutesAgo) {
  Message message;
  for (const std::int64_t sent : {0, 26'213, 26'215, 1'000'000}) {
    message.sent = Tick{sent};
    const TeamRecord record = encode(message, period);
    for (const std::int64_t age : {0, 1, 200, 24'000}) {
      EXPECT_EQ(decode(record, Tick{sent + age}, period).sent, Tick{sent}) << sent << ' ' << age;
    }
  }
}

TEST(TeamRecord, WithTicksShorterThanItsStepTheTimeIsAtMostHalfAStepOff) {
  Message message;
  for (std::int64_t sent = 0; sent < 1000; ++sent) {
    message.sent = Tick{sent};
    const Tick read = decode(encode(message, 0.003), Tick{sent + 2}, 0.003).sent;
    EXPECT_LE(std::abs(count(read) - sent), 4);  // 10 ms are 3.3 ticks
    EXPECT_LE(count(read), sent + 2) << "not after now";
  }
}

TEST(TeamRecord, AnyTwentyFiveBytesAreAMessage) {
  Rng rng{13};
  for (int i = 0; i < 10'000; ++i) {
    TeamRecord record;
    for (std::uint8_t& byte : record) byte = static_cast<std::uint8_t>(rng.index(256));
    const Message read = decode(record, Tick{100'000}, period);
    ASSERT_TRUE(is_finite(read.position) && is_finite(read.velocity) && std::isfinite(read.yaw));
    ASSERT_TRUE(!read.destination || is_finite(*read.destination));
    ASSERT_LE(count(read.sent), 100'000);
    ASSERT_GE(count(read.sent), 100'000 - 26'215);  // 1310.72 s
  }
}

TEST(TeamRecord, WhatIsNotANumberIsToldAsTheLowestValue) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Message message{.yaw = nan, .radius = nan};
  message.position = message.velocity = Vec3::Constant(nan);
  message.destination = Vec3::Constant(nan);
  const Message read = told(message);
  EXPECT_DOUBLE_EQ(read.velocity.x(), -20.47);
  EXPECT_DOUBLE_EQ(read.position.z(), -20971.51);
  EXPECT_DOUBLE_EQ(read.yaw, -pi);
  EXPECT_EQ(read.radius, 0.0);
  EXPECT_TRUE(is_finite(*read.destination));
}

}  // namespace
}  // namespace fairway
