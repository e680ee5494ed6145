// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/acoustic_channel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/comms/exchange.hpp"
#include "fairway/comms/testing/acoustic_sea.hpp"
#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using namespace acoustic_sea;

TEST(AcousticChannel, AMessageArrivesAfterItsTransmissionAndTheWayOfSound) {
  // 64 bytes at 1600 bit/s are 0.32 s, 75 m at 1500 m/s 0.05 s: 0.37 s, first whole tick at 0.4 s
  Sea sea{{}, pair(75)};
  for (int i = 0; i < 8; ++i) sea.tick();
  EXPECT_FALSE(sea.heard(1, 0).told);
  sea.tick();
  EXPECT_TRUE(sea.heard(1, 0).told);
  EXPECT_EQ(sea.heard(1, 0).sent, Tick{0});
  EXPECT_EQ(sea.heard(1, 0).from, VehicleId{0});
  EXPECT_FALSE(sea.heard(0, 0).told) << "nobody hears itself";
}

TEST(AcousticChannel, TellsWhatIsUnderWayUntilItHasArrived) {
  // as above, of the first alone: sent at 0, heard from 0.05 s to 0.37 s
  Sea sea{{}, pair(75)};
  sea.said[1].told = false;
  const auto under_way = [&] {
    std::vector<MessageFlight> flights;
    sea.channel.add_under_way(flights);
    return flights;
  };
  EXPECT_TRUE(under_way().empty());
  sea.tick();
  ASSERT_EQ(under_way().size(), 1U);
  const MessageFlight flight = under_way()[0];
  EXPECT_EQ(flight.from, 0U);
  EXPECT_EQ(flight.to, 1U);
  EXPECT_EQ(flight.sent, 0.0);
  EXPECT_NEAR(flight.begins, 0.05, 1e-12);
  EXPECT_NEAR(flight.arrives, 0.37, 1e-12);
  EXPECT_FALSE(flight.unheard);
  for (int i = 1; i < 8; ++i) sea.tick();
  EXPECT_EQ(under_way(), std::vector{flight});
  sea.tick();
  EXPECT_TRUE(under_way().empty());
}

TEST(AcousticChannel, WhatTakesAsLongAsATickArrivesOnIt) {
  // 0.32 s are 6.4 ticks; 45 m at 1500 m/s the 0.6 that are missing from 7
  Sea sea{{}, pair(45)};
  for (int i = 0; i < 7; ++i) sea.tick();
  EXPECT_FALSE(sea.heard(1, 0).told);
  sea.tick();
  EXPECT_TRUE(sea.heard(1, 0).told);
}

TEST(AcousticChannel, NobodyFartherAwayThanTheRangeHears) {
  Sea near{{}, pair(80)};
  near.run(10);
  EXPECT_TRUE(near.heard(1, 0).told);
  EXPECT_EQ(near.counts().out_of_range, 0);
  Sea far{{}, pair(80.001)};
  far.run(10);
  EXPECT_FALSE(far.heard(1, 0).told);
  EXPECT_EQ(far.counts().out_of_range, far.counts().sent);
}

TEST(AcousticChannel, TheDistanceCountsThatWasWhenSent) {
  Sea sea{{}, pair(79)};
  sea.tick();
  sea.places[1] = {0, 500, 0};
  sea.run(1);
  EXPECT_TRUE(sea.heard(1, 0).told);
}

TEST(AcousticChannel, WhoKeepsSilentIsNotHeard) {
  Sea sea{{}, pair(10)};
  sea.said[0].told = false;
  sea.run(30);
  EXPECT_FALSE(sea.heard(1, 0).told);
  EXPECT_TRUE(sea.heard(0, 1).told);
}

TEST(AcousticChannel, MessagesAreLostAsOftenAsAskedFor) {
  Sea sea{{.update_rate_hz = 1000, .slots = false, .loss_ratio = 0.3, .bit_rate_bps = 1e12}, pair(10)};
  sea.run(1000);
  const auto [sent, received, lost, out_of_range, drowned, collided] = sea.counts();
  EXPECT_EQ(collided, 0);
  EXPECT_EQ(sent, 40'000);  // 20 a second each
  // 4 standard deviations of the binomial: 4 sqrt(40000 0.3 0.7) = 367
  EXPECT_NEAR(static_cast<double>(lost), 12'000, 367);
  EXPECT_EQ(out_of_range + drowned, 0);

  Sea again{{.update_rate_hz = 1000, .slots = false, .loss_ratio = 0.3, .bit_rate_bps = 1e12}, pair(10)};
  again.run(1000);
  EXPECT_EQ(again.counts().lost, lost);
  Sea other{{.update_rate_hz = 1000, .slots = false, .loss_ratio = 0.3, .bit_rate_bps = 1e12}, pair(10), 2};
  other.run(1000);
  EXPECT_NE(other.counts().lost, lost);
}

TEST(AcousticChannel, AllOrNothingIsLostAtTheEnds) {
  for (const double ratio : {0.0, 1.0}) {
    Sea sea{{.loss_ratio = ratio}, pair(10)};
    sea.run(60);
    EXPECT_EQ(sea.counts().lost, ratio == 0.0 ? 0 : sea.counts().sent);
  }
}

/// The ticks at which 1 heard from 0 of late, at each tick.
std::vector<Tick> history(Sea sea, double duration) {
  std::vector<Tick> ticks;
  for (int i = 0; i < std::lround(duration / tick_s); ++i) {
    sea.tick();
    ticks.push_back(sea.heard(1, 0).sent);
  }
  return ticks;
}

TEST(AcousticChannel, AnotherVehicleShiftsNobodysDraws) {
  // without slots and with all phases on one tick, only the draws could change
  const AcousticParams params{
      .update_rate_hz = 1000, .slots = false, .loss_ratio = 0.5, .bit_rate_bps = 1e12};
  EXPECT_EQ(history(Sea{params, row(2)}, 30), history(Sea{params, row(5)}, 30));
}

TEST(AcousticChannel, DrawsDoNotDependOnWhoIsInRange) {
  const AcousticParams params{
      .update_rate_hz = 1000, .slots = false, .loss_ratio = 0.5, .bit_rate_bps = 1e12};
  Sea stayed{params, pair(10)};
  Sea strayed{params, pair(10)};
  stayed.run(10);
  strayed.places = pair(500);
  strayed.run(10);
  strayed.places = pair(10);
  for (Sea* sea : {&stayed, &strayed}) sea->run(5);  // until both have heard anew
  EXPECT_EQ(history(stayed, 20), history(strayed, 20));
}

/// When the message that `receiver` knows of `sender` was sent, whenever it changed [ticks].
std::vector<std::int64_t> sendings(Sea sea, double duration, std::size_t receiver, std::size_t sender) {
  std::vector<std::int64_t> ticks;
  for (int i = 0; i < std::lround(duration / tick_s); ++i) {
    sea.tick();
    const Message& message = sea.heard(receiver, sender);
    if (message.told && (ticks.empty() || ticks.back() != count(message.sent)))
      ticks.push_back(count(message.sent));
  }
  return ticks;
}

TEST(AcousticChannel, InSlotsVehiclesTakeTurnsAndNobodyDrowns) {
  // 0.32 s and 80 m of sound, 0.0533 s, are 0.3733 s: 8 ticks or 0.4 s; eight take 3.2 s, so 0.3125 Hz
  Sea sea{{.update_rate_hz = 1000}, row(8)};
  EXPECT_NEAR(sea.channel.slot_time(), 0.4, 1e-12);
  EXPECT_NEAR(sea.channel.transmission_time(), 0.32, 1e-12);
  for (std::size_t sender = 1; sender < 8; ++sender) {
    const std::vector<std::int64_t> ticks = sendings(sea, 320, 0, sender);
    ASSERT_EQ(ticks.size(), 100U) << sender;
    for (std::size_t k = 0; k < ticks.size(); ++k)
      ASSERT_EQ(ticks[k], 64 * static_cast<std::int64_t>(k) + 8 * static_cast<std::int64_t>(sender));
  }
  sea.run(320);
  EXPECT_EQ(sea.counts().sent, 800);
  EXPECT_EQ(sea.counts().drowned, 0);
}

TEST(AcousticChannel, SlotsNeverOverlapWhateverTheNumbersAre) {
  Rng rng{5};
  for (int i = 0; i < 100; ++i) {
    const AcousticParams params{
        .update_rate_hz = 1000, .range_m = rng.uniform(20, 5000), .bit_rate_bps = rng.uniform(100, 20'000)};
    // the farthest that hear
    Sea sea{params, {{0, 0, 0}, {params.range_m, 0, 0}, {0.5 * params.range_m, 0, 0}}};
    EXPECT_GE(sea.channel.slot_time() + 1e-6,
              sea.channel.transmission_time() + params.range_m / params.sound_speed_mps);
    sea.run(12 * sea.channel.slot_time());
    EXPECT_EQ(sea.counts().drowned, 0) << i;
    EXPECT_EQ(sea.counts().out_of_range, 0) << i;
    EXPECT_EQ(sea.counts().sent, 12) << i;
  }
}

TEST(AcousticChannel, NobodyTellsMoreOftenThanTheUpdateRate) {
  for (const bool slots : {false, true}) {
    const std::vector<std::int64_t> ticks = sendings({{.slots = slots}, row(8)}, 1000, 0, 5);
    EXPECT_EQ(ticks.size(), 100U) << slots;  // 0.1 Hz, in slots too, whose cycle is 3.2 s
  }
}

TEST(AcousticChannel, AfterASilenceNothingIsMadeUpFor) {
  Sea sea{{}, pair(10)};
  for (Message& message : sea.said) message.told = false;
  sea.run(100);
  for (Message& message : sea.said) message.told = true;
  sea.run(30);
  EXPECT_EQ(sea.counts().sent, 2 * 3);
}

TEST(AcousticChannel, WithoutSlotsVehiclesBeginAtDifferentTimes) {
  const AcousticParams params{.slots = false};
  for (std::size_t sender = 1; sender < 8; ++sender) {
    // every 10 s, an eighth of that apart
    EXPECT_EQ(sendings({params, row(8)}, 9.9, 0, sender),
              (std::vector<std::int64_t>{25 * std::int64_t(sender)}));
  }
}

TEST(AcousticChannel, WithoutSlotsEveryTickIsToldIfTheRateAllows) {
  const std::vector<std::int64_t> ticks =
      sendings({{.update_rate_hz = 20, .slots = false, .bit_rate_bps = 1e6}, pair(10)}, 100, 1, 0);
  EXPECT_EQ(ticks.size(), 1999U) << "that of the last tick is on its way";
}

TEST(AcousticChannel, NobodyTransmitsFasterThanAMessageTakes) {
  Sea sea{{.update_rate_hz = 1000, .slots = false}, {{0, 0, 0}}};
  sea.run(70);
  EXPECT_EQ(sea.counts().sent, 200);  // 0.32 s are 6.4, so 7 ticks
}

TEST(AcousticChannel, WhoTransmitsDoesNotHearMeanwhile) {
  // three share 1.5 s: each is due 0.5 s after the one before, whose 0.32 s are over by then
  Sea apart{{.update_rate_hz = 1.0 / 1.5, .slots = false}, row(3)};
  apart.run(15);
  EXPECT_EQ(apart.counts().drowned, 0);
  EXPECT_GT(apart.counts().received, 0);

  // three share 1 s: due at 0, 0.3 and 0.65 s, so the second begins while the first still transmits
  Sea close{{.update_rate_hz = 1.0, .slots = false}, row(3)};
  close.run(1.05);
  EXPECT_FALSE(close.heard(1, 0).told);
  EXPECT_FALSE(close.heard(0, 1).told);
  EXPECT_TRUE(close.heard(0, 2).told);
  close.run(20);
  EXPECT_GT(close.counts().drowned, 0);
}

TEST(AcousticChannel, WhoeverTransmitsAllTheTimeHearsNothing) {
  // a packet takes 0.9 ticks, sound 0.8: each arrives while the receiver sends its own
  Sea sea{{.update_rate_hz = 20, .slots = false, .bit_rate_bps = 64 * 8 / (0.9 * tick_s)}, pair(60)};
  sea.run(10);
  EXPECT_EQ(sea.counts().received, 0);
  EXPECT_EQ(sea.counts().drowned, 2 * 198);  // the last two of 200 are on their way
}

TEST(AcousticChannel, AMessageThatOvertakesIsNotReplacedByTheOlder) {
  Sea sea{{.update_rate_hz = 20, .slots = false, .range_m = 1e4, .bit_rate_bps = 1e12, .quantised = false},
          pair(1500)};
  sea.run(0.5);  // the ten that are sent now take a second
  sea.places = pair(15);
  sea.run(0.1);
  for (Message& message : sea.said) message.told = false;
  sea.run(2);
  EXPECT_EQ(sea.counts().received, 2 * 12);
  EXPECT_EQ(sea.heard(1, 0).sent, Tick{11});
}

TEST(AcousticChannel, TheMeasuredRateIsThePublishedOneOnTheMean) {
  for (const auto& [distance, rate] : {std::pair{20.0, 0.59664}, {50.0, 0.336}, {80.0, 0.21504}}) {
    Sea sea{{.update_rate_hz = 1000, .rate_law = RateLaw::measured}, pair(distance)};
    sea.run(10'000);
    const double each = 0.5 * static_cast<double>(sea.counts().received) / 10'000;
    EXPECT_NEAR(measured_rate(distance), rate, 1e-12);
    EXPECT_NEAR(each, rate, 2e-4) << distance;  // two messages in ten thousand seconds
  }
  EXPECT_NEAR(measured_rate(200), measured_rate(91), 1e-4) << "the parabola does not rise again";
}

TEST(AcousticChannel, TheMeasuredRateLetsNoMoreThroughThanIsSent) {
  Sea sea{{.update_rate_hz = 0.1, .rate_law = RateLaw::measured}, pair(20)};
  sea.run(1000);
  EXPECT_EQ(sea.counts().lost, 0);
  EXPECT_EQ(sea.counts().sent, 200);
}

TEST(AcousticChannel, WhatIsToldIsRoundedUnlessAskedNotTo) {
  for (const bool quantised : {false, true}) {
    Sea sea{{.quantised = quantised}, pair(10)};
    for (Message& message : sea.said) message.yaw = 0.01;
    sea.run(1);
    EXPECT_EQ(sea.heard(1, 0).yaw, quantised ? 0.0 : 0.01);
  }
}

TEST(AcousticChannel, EveryMessageIsAccountedFor) {
  Sea sea{{.update_rate_hz = 1.0, .rate_law = RateLaw::measured, .slots = false, .loss_ratio = 0.2},
          {{0, 0, 0}, {0, 30, 0}, {0, 60, 0}, {0, 100, 0}}};
  sea.run(600);
  for (Message& message : sea.said) message.told = false;
  sea.run(2);  // nothing is left under way
  const auto [sent, received, lost, out_of_range, drowned, collided] = sea.counts();
  EXPECT_EQ(collided, 0);
  for (const std::int64_t some : {received, lost, out_of_range, drowned}) EXPECT_GT(some, 0);
  EXPECT_EQ(3 * sent, received + lost + out_of_range + drowned);
}

TEST(AcousticChannel, ACopyIsASnapshot) {
  Sea sea{{.update_rate_hz = 5, .slots = false, .loss_ratio = 0.3, .bit_rate_bps = 13'900}, row(4)};
  sea.run(3.03);
  const Sea snapshot = sea;
  const std::vector<Tick> once = history(sea, 20);
  sea.run(20);
  EXPECT_EQ(history(snapshot, 20), once);
}

TEST(AcousticChannel, AfterTheFirstTickNothingIsAllocated) {
  for (const bool slots : {false, true}) {
    Sea original{{.update_rate_hz = 1, .slots = slots, .loss_ratio = 0.1, .bit_rate_bps = 13'900}, row(20)};
    original.tick();
    Sea sea = original;
    const long before = allocation_count();
    sea.run(60);
    EXPECT_EQ(allocation_count(), before) << slots;
    EXPECT_GT(sea.counts().received, 100);
  }
}

/// What such a choice is refused with.
std::string refusal(const ParamValues& params, std::size_t vehicle_count = 2) {
  return refusal_by([&] { (void)Exchange{"acoustic", params, vehicle_count, tick_s, Rng{1}}; });
}

TEST(AcousticChannel, WhatDoesNotGoTogetherIsRefused) {
  EXPECT_EQ(refusal({}), "accepted");
  EXPECT_EQ(refusal({{"message_bytes_count", 80.0}}),
            "message_bytes_count: 80 bytes and 39 of overhead are more than the 64 that the modem takes");
  EXPECT_EQ(refusal({{"message_bytes_count", 24.0}}),
            "message_bytes_count: 24 bytes are less than the 25 of the team record; quantised: false does "
            "without it");
  EXPECT_EQ(refusal({{"message_bytes_count", 24.0}, {"quantised", false}}), "accepted");
  EXPECT_EQ(refusal({{"loss_ratio", 1.5}}), "loss_ratio: is 1.5; expected a number in [0, 1]");
  EXPECT_THAT(refusal({{"update_rate_hz", 0.0}}), testing::StartsWith("update_rate_hz: is 0; expected"));
  EXPECT_THAT(refusal({{"range_m", 0.0}}), testing::StartsWith("range_m: is 0; expected"));
  EXPECT_THAT(refusal({{"sound_sped_mps", 1.0}}), testing::HasSubstr("did you mean sound_speed_mps?"));
  EXPECT_EQ(refusal({}, 256), "accepted");
  EXPECT_EQ(refusal({}, 257), "kind: acoustic exchange is for at most 256 vehicles, not 257");
  EXPECT_THAT(
      refusal({{"slots", false}, {"update_rate_hz", 1000.0}, {"bit_rate_bps", 1e6}, {"range_m", 1e5}}, 200),
      testing::StartsWith("update_rate_hz: more than a million"));
}

}  // namespace
}  // namespace fairway
