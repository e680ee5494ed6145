// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/tracker.hpp"

#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/perception/testing/ospa.hpp"
#include "fairway/perception/tracker/gate.hpp"

namespace fairway {
namespace {

constexpr double period = 1.0 / 15.0;

/// It looks everywhere.
Fan everywhere() { return {.half_field = 4.0, .half_aperture = 2.0, .max_range = 1e9}; }

Fan looking_astern() {
  Fan astern = everywhere();
  astern.half_field = 1.0;
  astern.q_nb = quaternion_of({.yaw = pi});
  return astern;
}

Contact contact(const Vec3& at, double sigma = 0.3) {
  return {.position = at, .covariance = sigma * sigma * Mat3::Identity(), .radius = 1.0, .radius_sigma = 0.2};
}

Contact noisy(const Vec3& at, Rng& rng, double sigma = 0.3) {
  return contact(at + sigma * Vec3{rng.normal(), rng.normal(), rng.normal()}, sigma);
}

std::vector<Track> reported(const Tracker& tracker, double time) {
  std::vector<Track> tracks;
  tracker.report(time, tracks);
  return tracks;
}

/// After `pings` contacts at one place.
Tracker following(const Vec3& place, int pings, const TrackerParams& params = {}) {
  Tracker tracker{params};
  for (int i = 0; i < pings; ++i) tracker.update(i * period, std::vector{contact(place)}, everywhere());
  return tracker;
}

TEST(Tracker, ATrackIsReportedAfterFiveContactsInEightPings) {
  Tracker tracker{{}};
  const std::vector<bool> hits{true, false, true, false, true, true, false, true};
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(reported(tracker, i * period).empty());
    tracker.update(i * period, hits[i] ? std::vector{contact({10, 0, 0})} : std::vector<Contact>{},
                   everywhere());
  }
  ASSERT_EQ(reported(tracker, 8 * period).size(), 1U);
  EXPECT_EQ(reported(tracker, 8 * period)[0].id, TrackId{first_tracker_id});
}

TEST(Tracker, FourContactsInEightPingsAreForgotten) {
  Tracker tracker{{}};
  int i = 0;
  for (const int hit : {1, 0, 1, 1, 0, 1, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1}) {
    tracker.update(i++ * period, hit != 0 ? std::vector{contact({10, 0, 0})} : std::vector<Contact>{},
                   everywhere());
    EXPECT_TRUE(reported(tracker, i * period).empty());
  }
}

TEST(Tracker, ATargetThatShouldBeSeenAndIsNotDies) {
  const TrackerParams params{.death_missed_count = 10};
  Tracker tracker = following({10, 0, 0}, 20, params);
  for (int i = 20; i < 29; ++i) tracker.update(i * period, {}, everywhere());
  EXPECT_EQ(reported(tracker, 29 * period).size(), 1U);
  tracker.update(29 * period, {}, everywhere());
  EXPECT_TRUE(reported(tracker, 29 * period).empty());
}

TEST(Tracker, WhatIsSeenOnlyNowAndThenDiesAndHalfTheTimeIsEnough) {
  for (const int every : {2, 6}) {
    Tracker tracker = following({10, 0, 0}, 60);
    const std::vector<Contact> seen{contact({10, 0, 0})};
    for (int i = 60; i < 160; ++i)
      tracker.update(i * period, i % every == 0 ? seen : std::vector<Contact>{}, everywhere());
    const auto tracks = reported(tracker, 160 * period);
    const bool same = !tracks.empty() && tracks[0].id == TrackId{first_tracker_id};
    EXPECT_EQ(same, every == 2);
  }
}

TEST(Tracker, ATargetOutOfViewLivesUntilItIsTooUncertain) {
  const TrackerParams params{.still_ratio = 0.0, .death_missed_count = 10, .death_sigma_m = 2.0};
  Tracker tracker = following({10, 0, 0}, 40, params);
  const Fan astern = looking_astern();
  int lived = 0;
  for (int i = 40; i < 2000 && !reported(tracker, i * period).empty(); ++i, ++lived) {
    const Track track = reported(tracker, i * period)[0];
    EXPECT_LT(track.position_covariance(0, 0), 4.0 + 0.1);
    EXPECT_NEAR(track.age, (i - 40) * period + period, 1e-9);
    tracker.update(i * period, {}, astern);
  }
  EXPECT_GT(lived, 45);
  EXPECT_LT(lived, 300);
}

TEST(Tracker, WhatStandsStillIsWhereItWasUntilItHasBeenOutOfViewForLong) {
  Rng rng{5};
  Tracker tracker{{.death_unseen_s = 180.0}};
  double time = 0.0;
  for (int i = 0; i < 300; ++i, time += period)
    tracker.update(time, std::vector{noisy({10, 3, 0}, rng)}, everywhere());
  for (int i = 0; i < 2600; ++i, time += period) tracker.update(time, {}, looking_astern());
  const auto tracks = reported(tracker, time);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_LT((tracks[0].position - Vec3{10, 3, 0}).norm(), 0.3);
  EXPECT_EQ(tracks[0].velocity, Vec3::Zero());
  EXPECT_LT(tracks[0].position_covariance(0, 0), 1.0);
  for (int i = 0; i < 120; ++i, time += period) tracker.update(time, {}, looking_astern());
  EXPECT_TRUE(reported(tracker, time).empty());
}

TEST(Tracker, WhatIsNearerThanTheSonarHearsIsNotMissed) {
  for (const double least_range : {0.9, 1.1}) {
    Tracker tracker = following({2, 0, 0}, 60);  // of a radius of 1 m
    Fan fan = everywhere();
    fan.min_range = least_range;
    for (int i = 60; i < 160; ++i) tracker.update(i * period, {}, fan);
    EXPECT_EQ(reported(tracker, 160 * period).size(), least_range > 1.0 ? 1U : 0U);
  }
}

TEST(Tracker, WhatSetsOutIsNoLongerBelievedToStandStill) {
  Rng rng{6};
  Tracker tracker{{}};
  double time = 0.0;
  for (int i = 0; i < 150; ++i, time += period)
    tracker.update(time, std::vector{noisy({10, 3, 0}, rng)}, everywhere());
  for (int i = 0; i < 60; ++i, time += period)
    tracker.update(time, std::vector{noisy({10 + 0.5 * period * i, 3, 0}, rng)}, everywhere());
  EXPECT_NEAR(reported(tracker, time)[0].velocity.x(), 0.5, 0.2);
}

TEST(Tracker, PositionAndVelocityComeTrueWithinTheirCovariance) {
  const Vec3 velocity{0.4, -0.3, 0.1};
  double nees = 0.0;
  const int runs = 200;
  for (int run = 0; run < runs; ++run) {
    Rng rng = Rng{1}.stream("run", run);
    Tracker tracker{{.velocity_change_mps = 0.001}};
    for (int i = 0; i < 100; ++i)
      tracker.update(i * period, std::vector{noisy(i * period * velocity, rng)}, everywhere());
    const double later = 100 * period + 0.5;
    const auto tracks = reported(tracker, later);
    ASSERT_EQ(tracks.size(), 1U);
    const Vec3 error = tracks[0].position - later * velocity;
    nees += error.dot(tracks[0].position_covariance.inverse() * error) / runs;
    EXPECT_LT((tracks[0].velocity - velocity).norm(), 0.2);
  }
  // 95 % of the mean of 200 runs with 3 degrees of freedom; a first velocity of zero errs within its 1 m/s
  EXPECT_GT(nees, 2.67);
  EXPECT_LT(nees, 3.35);
}

TEST(Tracker, TwoThatCrossKeepTheirIds) {
  int kept = 0;
  for (int run = 0; run < 20; ++run) {
    Rng rng = Rng{2}.stream("run", run);
    Tracker tracker{{}};
    // they pass the crossing 2 s, that is 2 m, apart
    const auto first = [](double t) { return Vec3{t - 10, 0, 0}; };
    const auto second = [](double t) { return Vec3{0, t - 12, 0}; };
    std::vector<Track> before;
    for (int i = 0; i < 330; ++i) {
      const double t = i * period;
      std::vector<Contact> contacts;
      if (rng.uniform(0, 1) > 0.1) contacts.push_back(noisy(second(t), rng));
      if (rng.uniform(0, 1) > 0.1) contacts.push_back(noisy(first(t), rng));
      tracker.update(t, contacts, everywhere());
      if (i == 50) before = reported(tracker, t);
    }
    const double end = 329 * period;
    const auto after = reported(tracker, end);
    ASSERT_EQ(before.size(), 2U);
    ASSERT_EQ(after.size(), 2U);
    const auto is_first = [&](const Track& track, double t) {
      return (track.position - first(t)).norm() < (track.position - second(t)).norm();
    };
    kept +=
        before[0].id == after[0].id && is_first(before[0], 50 * period) == is_first(after[0], end) ? 1 : 0;
  }
  EXPECT_EQ(kept, 20);
}

TEST(Tracker, FalseContactsMakeHardlyAnyTracks) {
  Rng rng{3};
  Tracker tracker{{}};
  int ghosts = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<Contact> contacts;
    for (int k = 0; k < 2; ++k) contacts.push_back(contact({rng.uniform(0, 100), rng.uniform(-60, 60), 0}));
    tracker.update(i * period, contacts, everywhere());
    ghosts += static_cast<int>(reported(tracker, i * period).size());
  }
  EXPECT_LT(ghosts / 3000.0, 0.02);
}

TEST(Tracker, AnEstablishedTrackChoosesBeforeANewOne) {
  Tracker tracker = following({10, 0, 0}, 30);
  tracker.update(30 * period, std::vector{contact({10, 0, 0}), contact({10.5, 0, 0})}, everywhere());
  // now a newborn stands beside; the one contact is nearer to it, and yet the old one gets it
  for (int i = 31; i < 60; ++i) tracker.update(i * period, std::vector{contact({10.3, 0, 0})}, everywhere());
  const auto tracks = reported(tracker, 60 * period);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, TrackId{first_tracker_id});
}

TEST(Tracker, CoincidentContactsAndMoreThanItHasRoomForAreFine) {
  Tracker tracker{{.max_tracks_count = 4}};
  const std::vector<Contact> many(20, contact({10, 0, 0}));
  for (int i = 0; i < 30; ++i) tracker.update(i * period, many, everywhere());
  const auto tracks = reported(tracker, 30 * period);
  EXPECT_EQ(tracks.size(), 4U);
  for (const Track& track : tracks) EXPECT_TRUE(is_finite(track.position));
}

TEST(Tracker, TheRadiusIsASlowAverage) {
  Tracker tracker = following({10, 0, 0}, 200);
  Contact large = contact({10, 0, 0});
  large.radius = 1.5;
  tracker.update(200 * period, std::vector{large}, everywhere());
  // in steady state the share s of a new radius keeps s^2 / (1 - s) = q / r
  const double noise = 0.05 * 0.05 * period / (0.2 * 0.2);
  const double share = 0.5 * (std::sqrt(noise * noise + 4.0 * noise) - noise);
  EXPECT_NEAR(reported(tracker, 200 * period)[0].radius, 1.0 + share * 0.5, 1e-4);
}

TEST(Tracker, AnEchoOfNoSizeIsNotTakenForAThingOfSize) {
  Tracker tracker = following({10, 0, 0}, 30, {.death_missed_count = 1000});
  Contact speck = contact({10, 0, 0});
  speck.radius = 0.05;
  speck.radius_sigma = 0.05;
  tracker.update(30 * period, std::vector{speck}, everywhere());
  EXPECT_NEAR(reported(tracker, 30 * period)[0].age, period, 1e-9);
}

TEST(Tracker, ErrorsThatLastAreNotAveragedAway) {
  Contact blind = contact({10, 0, 0});
  blind.lasting(2, 2) = 9.0;
  blind.covariance(2, 2) += 9.0;
  Tracker tracker{{}};
  for (int i = 0; i < 500; ++i) tracker.update(i * period, std::vector{blind}, everywhere());
  const Track track = reported(tracker, 500 * period)[0];
  EXPECT_GT(track.position_covariance(2, 2), 9.0);
  EXPECT_LT(track.position_covariance(0, 0), 0.09);
}

TEST(Tracker, WhatIsSeenIsNotCountedOnUnlessSaidSo) {
  const Track stranger = reported(following({10, 0, 0}, 5), 5 * period)[0];
  EXPECT_FALSE(stranger.reacts);
  EXPECT_EQ(stranger.priority, std::numeric_limits<std::int32_t>::min());
  EXPECT_TRUE(reported(following({10, 0, 0}, 5, {.contacts_react = true}), 5 * period)[0].reacts);
}

TEST(Tracker, IdsAreGivenInOrderAndNeverAgain) {
  Tracker tracker{{.death_missed_count = 3}};
  std::uint32_t last = first_tracker_id - 1;
  for (int round = 0; round < 5; ++round) {
    for (int i = 0; i < 6; ++i)
      tracker.update((10 * round + i) * period, std::vector{contact({10.0 + 20 * round, 0, 0})},
                     everywhere());
    const auto tracks = reported(tracker, (10 * round + 6) * period);
    EXPECT_EQ(number(tracks.back().id), ++last);
  }
}

TEST(Tracker, ACopyGoesOnAsTheOriginalDoesAndNeitherAllocates) {
  Rng rng{4};
  Tracker original{{}};
  const auto pinged = [&](int count) {
    std::vector<std::vector<Contact>> pings;
    for (int i = 0; i < count; ++i) {
      pings.emplace_back();
      for (int k = 0; k < 12; ++k)
        pings.back().push_back(noisy({10.0 * k, rng.uniform(-1, 1) > 0.9 ? 30.0 : 0.0, 0}, rng));
    }
    return pings;
  };
  int i = 0;
  for (const auto& contacts : pinged(100)) original.update(i++ * period, contacts, everywhere());
  Tracker copy = original;
  const auto more = pinged(100);
  std::vector<Track> tracks;
  tracks.reserve(200);
  const long before = allocation_count();
  for (int k = 0; k < 100; ++k) original.update((i + k) * period, more[k], everywhere());
  original.report((i + 100) * period, tracks);
  EXPECT_EQ(allocation_count() - before, 0);
  for (int k = 0; k < 100; ++k) copy.update((i + k) * period, more[k], everywhere());
  const auto others = reported(copy, (i + 100) * period);
  ASSERT_EQ(tracks.size(), others.size());
  ASSERT_FALSE(tracks.empty());
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    EXPECT_EQ(tracks[k].position, others[k].position);
    EXPECT_EQ(tracks[k].position_covariance, others[k].position_covariance);
  }
}

TEST(Tracker, ContradictionsAreRefused) {
  EXPECT_EQ(refusal_by([] { Tracker{{.birth_hits_count = 9}}; }),
            "birth_hits_count: is more than birth_pings_count");
}

TEST(Tracker, TheGateIsTheQuantileOfChiSquare) {
  EXPECT_NEAR(gate_of(0.95, 3), 7.8147, 1e-4);
  EXPECT_NEAR(gate_of(0.99, 3), 11.3449, 1e-4);
  EXPECT_NEAR(gate_of(0.95, 1), 3.8415, 1e-4);
  EXPECT_NEAR(gate_of(0.99, 4), 13.2767, 1e-4);
  Rng rng{5};
  int inside = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 error{2.0 * rng.normal(), rng.normal(), 0.5 * rng.normal()};
    inside += distance2(error, Vec3{4, 1, 0.25}.asDiagonal(), gate_of(0.9, 3)) < gate_of(0.9, 3) ? 1 : 0;
  }
  EXPECT_NEAR(inside / 4000.0, 0.9, 3.0 * std::sqrt(0.9 * 0.1 / 4000));
}

TEST(Ospa, IsZeroForTheSameAndTheCutoffForNothing) {
  const std::vector<Vec3> points{{0, 0, 0}, {5, 5, 0}};
  EXPECT_EQ(ospa(points, points, 10), 0.0);
  EXPECT_EQ(ospa(points, {}, 10), 10.0);
  EXPECT_EQ(ospa({}, {}, 10), 0.0);
  // one is 3 m off, the other missing: sqrt((9 + 100) / 2)
  EXPECT_NEAR(ospa(points, {{3, 0, 0}}, 10), std::sqrt(54.5), 1e-12);
}

}  // namespace
}  // namespace fairway
