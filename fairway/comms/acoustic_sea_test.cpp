// SPDX-License-Identifier: Apache-2.0
// What goes wrong in the water: runs of losses, noise, packets that meet, shadows, clocks.
#include "fairway/comms/testing/acoustic_sea.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/comms/sound.hpp"
#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using namespace acoustic_sea;

/// Whoever is due at each tick is heard at the next.
AcousticParams at_once() {
  return {
      .update_rate_hz = 20, .slots = false, .sound_speed_mps = 1e9, .bit_rate_bps = 1e12, .quantised = false};
}

/// Two at the ends that speak twice a second, in packets of 0.32 s that meet at the one between them.
Sea talking_at_once(AcousticParams params, double nearer = 20.0) {
  params.update_rate_hz = 2;
  params.slots = false;
  Sea sea{params, {{0, -nearer, 0}, {0, 0, 0}, {0, 20, 0}}};
  sea.said[1].told = false;
  return sea;
}

std::int64_t fates(const AcousticCounts& counts) {
  return counts.received + counts.lost + counts.out_of_range + counts.drowned + counts.collided;
}

TEST(AcousticSea, LossesComeInRunsOfTheLengthAskedFor) {
  AcousticParams params = at_once();
  params.loss_ratio = 0.3;
  params.loss_run_count = 4.0;
  Sea sea{params, pair(10)};
  sea.said[1].told = false;
  constexpr int messages = 100000;
  int lost = 0, runs = 0;
  bool was_lost = false;
  for (int i = 0; i < messages; ++i) {
    const std::int64_t before = sea.counts().lost;
    sea.tick();
    const bool is_lost = sea.counts().lost > before;
    lost += is_lost ? 1 : 0;
    runs += is_lost && !was_lost ? 1 : 0;
    was_lost = is_lost;
  }
  // 7500 runs: of their mean length the standard error is 0.04, of the share of losses 0.0037
  EXPECT_NEAR(static_cast<double>(lost) / messages, 0.3, 0.012);
  EXPECT_NEAR(static_cast<double>(lost) / runs, 4.0, 0.15);
}

TEST(AcousticSea, RunsThatCannotBeSoShortAreRefused) {
  AcousticParams params;
  params.loss_ratio = 0.9;
  params.loss_run_count = 4.0;
  EXPECT_THAT(refusal_by([&] { Sea{params, pair(10)}; }), testing::HasSubstr("loses at least 9"));
}

TEST(AcousticSea, NoiseSpoilsWhatTheSonarEquationSays) {
  AcousticParams params = at_once();
  params.propagation = Propagation::sonar;
  params.range_m = 1e5;
  params.bit_rate_bps = 1e9;  // less than a tick, and the noise of a wide band
  const double absorption = francois_garrison_absorption(26.0, {});
  const double noise = ambient_noise(26.0, params.shipping_ratio, params.wind_mps);
  const auto error_at = [&](double distance) {
    const double level = 170.8 + 10 * std::log10(1.4) - transmission_loss(distance, 1.5, absorption);
    return packet_error_ratio(level - noise - 90.0 - 10.0, 512);
  };
  double near = 1.0, far = 1e5;  // where half is spoilt
  while (far - near > 1e-6) (error_at((near + far) / 2) < 0.5 ? near : far) = (near + far) / 2;

  constexpr int messages = 10000;
  const auto share_heard_at = [&](double distance) {
    Sea sea{params, pair(distance)};
    sea.said[1].told = false;
    for (int i = 0; i < messages; ++i) sea.tick();
    return static_cast<double>(sea.counts().received) / messages;
  };
  EXPECT_NEAR(share_heard_at(near), 0.5, 0.025) << "five standard errors";
  EXPECT_GT(share_heard_at(near / 2), 0.99);
  EXPECT_EQ(share_heard_at(2 * near), 0.0);
}

TEST(AcousticSea, PacketsThatMeetSpoilEachOther) {
  Sea polite = talking_at_once({});
  polite.run(20);
  EXPECT_GT(polite.counts().received, 70) << "without interference all are heard";

  Sea sea = talking_at_once({.interference = true});
  sea.run(20);
  EXPECT_FALSE(sea.heard(1, 0).told);
  EXPECT_FALSE(sea.heard(1, 2).told);
  EXPECT_GT(sea.counts().collided, 70);

  std::vector<MessageFlight> flights;
  sea.channel.add_under_way(flights);
  for (sea.run(0.4); flights.empty(); sea.run(0.05)) sea.channel.add_under_way(flights);
  EXPECT_TRUE(std::ranges::any_of(flights, &MessageFlight::unheard)) << "so it is shown";
}

TEST(AcousticSea, TheNearerIsHeardThroughTheFarther) {
  Sea sea = talking_at_once({.interference = true}, 1.0);  // as 20^1.5 = 89 is more than 10
  sea.run(20);
  EXPECT_TRUE(sea.heard(1, 0).told);
  EXPECT_FALSE(sea.heard(1, 2).told);
}

TEST(AcousticSea, ALostPacketIsStillInTheOthersWay) {
  // each loses nine of ten by chance, and nevertheless nothing gets through
  Sea sea = talking_at_once({.loss_ratio = 0.9, .interference = true});
  sea.run(100);
  EXPECT_FALSE(sea.heard(1, 0).told);
  EXPECT_FALSE(sea.heard(1, 2).told);
}

TEST(AcousticSea, WhoListensFirstIsHeard) {
  Sea sea = talking_at_once({.interference = true, .carrier_sense = true});
  sea.run(200);
  EXPECT_TRUE(sea.heard(1, 0).told);
  EXPECT_TRUE(sea.heard(1, 2).told);
  // 40 m are 0.027 s: in less than one tick of 0.05 s nobody can know that another has begun
  EXPECT_LT(sea.counts().collided * 5, sea.counts().received);
  EXPECT_GT(sea.counts().sent, 300) << "of 625 for which there is time";
}

TEST(AcousticSea, EveryReceptionIsCountedOnce) {
  AcousticParams params{.loss_ratio = 0.2, .loss_run_count = 2, .interference = true, .carrier_sense = true};
  params.slots = false;
  params.update_rate_hz = 1;
  Sea sea{params, row(6)};
  sea.run(100);
  for (Message& said : sea.said) said.told = false;
  sea.run(2);  // until all has arrived
  EXPECT_GT(sea.counts().collided, 0);
  EXPECT_GT(sea.counts().lost, 0);
  EXPECT_EQ(fates(sea.counts()), 5 * sea.counts().sent);
}

TEST(AcousticSea, NobodyHearsThroughARock) {
  const std::vector<Obstacle> rocks{{.kind = Obstacle::Kind::sphere, .position = {0, 20, 0}, .radius = 5}};
  const auto hears = [&](bool shadow, Vec3 place) {
    Sea sea{{.update_rate_hz = 1, .shadow = shadow}, {{0, 0, 0}, std::move(place)}};
    for (int i = 0; i < 100; ++i) {
      sea.channel.pass_on(sea.now, sea.said, sea.places, rocks);
      sea.now = next(sea.now);
    }
    return sea.heard(1, 0).told;
  };
  EXPECT_FALSE(hears(true, {0, 40, 0}));
  EXPECT_TRUE(hears(true, {0, 40, 12})) << "passes 5.7 m below the middle";
  EXPECT_TRUE(hears(true, {0, 10, 0})) << "before it";
  EXPECT_TRUE(hears(false, {0, 40, 0}));
}

TEST(AcousticSea, AClockThatIsWrongMakesAMessageLookOlderButNeverOfTheFuture) {
  AcousticParams params = at_once();
  params.clock_offset_s = 1.0;
  Sea sea{params, pair(10)};
  sea.run(100);
  const std::int64_t now = count(sea.now) - 1;
  const std::int64_t one = now - count(sea.heard(1, 0).sent), other = now - count(sea.heard(0, 1).sent);
  EXPECT_EQ(std::min(one, other), 0) << "the one that is ahead is not believed";
  EXPECT_GT(std::max(one, other), 1) << "the other's seem old";

  params.clock_offset_s = 0.0;
  params.clock_drift_ratio = 1e-3;
  Sea drifting{params, pair(10)};
  drifting.run(1000);
  const auto age = [&](std::size_t to, std::size_t from) {
    return count(drifting.now) - 1 - count(drifting.heard(to, from).sent);
  };
  EXPECT_GT(age(0, 1) + age(1, 0), 2);
}

TEST(AcousticSea, AClockJumpsOnceWithinTheTime) {
  AcousticParams params = at_once();
  params.clock_jump_s = 2.0;
  params.clock_jump_within_s = 50.0;
  Sea sea{params, pair(10)};
  std::array<double, 2> shown{};
  std::array<int, 2> jumps{};
  while (seconds(sea.now, tick_s) < 60.0) {
    for (std::size_t i = 0; i < 2; ++i) {
      const double ahead = sea.channel.clock_ahead(i, sea.now);
      if (ahead != shown[i]) ++jumps[i];
      shown[i] = ahead;
    }
    sea.now = next(sea.now);
  }
  EXPECT_EQ(jumps, (std::array{1, 1}));
  EXPECT_NE(shown[0], shown[1]);
  sea.run(100);
  EXPECT_NE(count(sea.heard(1, 0).sent), count(sea.now) - 1);
}

}  // namespace
}  // namespace fairway
