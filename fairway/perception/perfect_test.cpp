// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/perfect.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/random_obstacles.hpp"

namespace fairway {
namespace {

Message message(std::uint32_t id, const Vec3& at) {
  Message m{.from = VehicleId{id}};
  m.position = at;
  m.radius = 1.0;
  return m;
}

Mover vehicle(std::uint32_t id, const Vec3& at) { return {.id = TrackId{id}, .position = at, .radius = 1.0}; }

Mover drifter(const Vec3& at) {
  return {.id = TrackId{0x8000'0003U},
          .position = at,
          .velocity = {0, 1, 0},
          .radius = 2.0,
          .priority = -1,
          .reacts = false,
          .silent = true,
          .is_vehicle = false};
}

std::vector<Track> perceived(const Scene& scene, const Reach& reach = {.vehicles = 100, .obstacles = 100}) {
  const VehicleState x{.p_n = scene.movers[scene.own_index].position};
  std::vector<Near> near;
  std::vector<Track> tracks;
  perceive_movers(scene, {x, x, 1.0}, reach, near, tracks);
  return tracks;
}

constexpr double endless = std::numeric_limits<double>::infinity();

/// What an obstacle is known by.
using Mark = std::tuple<double, double, const Vec3*, bool>;

/// The obstacles that somebody at `place` with a sphere of 3 m knows of.
std::vector<Mark> known_from(const Vec3& place, const Scene& scene, const Reach& reach,
                             double farthest = endless) {
  const VehicleState x{.p_n = place};
  std::vector<Near> near;
  std::vector<Obstacle> known;
  perceive_obstacles(scene, {.truth = x, .estimate = x, .radius = 3.0, .farthest_obstacle = farthest}, reach,
                     near, known);
  std::vector<Mark> marks;
  for (const Obstacle& o : known)
    marks.emplace_back(o.position.sum(), o.from.sum(), o.vertices.data(), o.charted);
  return marks;
}

TEST(PerfectPerception, DriftersAreTracksAmongTheOthersNearestFirst) {
  const Mailbox heard{message(0, {0, 0, 0}), message(1, {10, 0, 0}), message(2, {30, 0, 0})};
  const std::vector<Mover> movers{vehicle(0, {0, 0, 0}), vehicle(1, {10, 0, 0}), vehicle(2, {30, 0, 0}),
                                  drifter({20, 0, 0})};
  const std::vector<Track> tracks = perceived({.movers = movers, .heard = heard});

  ASSERT_EQ(tracks.size(), 3U);
  EXPECT_TRUE(tracks[0].reacts);
  EXPECT_FALSE(tracks[1].reacts);
  EXPECT_EQ(tracks[1].position, Vec3(20, 0, 0));
  EXPECT_EQ(tracks[1].velocity, Vec3(0, 1, 0));
  EXPECT_LT(tracks[1].priority, tracks[0].priority);
}

TEST(PerfectPerception, WhereAllAreHeardDriftersAloneAreAmongTheMovers) {
  const Mailbox heard{message(0, {0, 0, 0}), message(1, {10, 0, 0})};
  const std::vector<Mover> movers{drifter({20, 0, 0})};
  Vicinity places;
  places.update(heard.size(), [&](std::size_t i) { return heard[i].position; });
  const VehicleState x;
  std::vector<Near> near;
  std::vector<Track> tracks;
  perceive_movers(
      {.own_index = 0, .movers = movers, .heard = heard, .places = &places, .heard_at_once = true},
      {x, x, 1.0}, {.vehicles = 100, .obstacles = 100}, near, tracks);
  ASSERT_EQ(tracks.size(), 2U);
  EXPECT_EQ(tracks[0].id, TrackId{1});
  EXPECT_EQ(tracks[1].id, movers[0].id);
}

TEST(PerfectPerception, ADrifterIsPerceivedFromSurfaceToSurface) {
  const auto is_seen = [](double distance) {
    const std::vector<Mover> movers{vehicle(0, {0, 0, 0}), drifter({distance, 0, 0})};
    return !perceived({.movers = movers}, {.vehicles = 1e9, .obstacles = 5}).empty();
  };
  EXPECT_TRUE(is_seen(8.0));  // 5 + 1 + 2
  EXPECT_FALSE(is_seen(8.001));
}

TEST(PerfectPerception, ASilentVehicleIsSeenFromCentreToCentreAndOneThatTellsIsNot) {
  std::vector<Mover> movers{vehicle(0, {0, 0, 0}), vehicle(1, {10, 0, 0})};
  EXPECT_TRUE(perceived({.movers = movers}).empty());
  movers[1].silent = true;
  ASSERT_EQ(perceived({.movers = movers}).size(), 1U);
  EXPECT_EQ(perceived({.movers = movers})[0].position, Vec3(10, 0, 0));
  EXPECT_TRUE(perceived({.movers = movers}, {.vehicles = 9.9, .obstacles = 100}).empty());
}

TEST(PerfectPerception, AnOldMessageIsPredictedAndItsUncertaintyGrows) {
  Mailbox heard{message(0, {0, 0, 0}), message(1, {10, 0, 0})};
  heard[1].sent = Tick{20};
  heard[1].velocity = {0, 0.5, 0};
  const std::vector<Mover> movers{vehicle(0, {0, 0, 0}), vehicle(1, {99, 0, 0})};
  const std::vector<Track> tracks = perceived(
      {.time = 5.0, .period = 0.05, .movers = movers, .heard = heard, .unforeseen_acceleration = 0.1});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_DOUBLE_EQ(tracks[0].age, 4.0);
  EXPECT_TRUE(tracks[0].position.isApprox(Vec3(10, 2, 0)));
  EXPECT_NEAR(tracks[0].position_covariance(0, 0), 0.64, 1e-12);  // (0.1 4^2 / 2)^2
  EXPECT_NEAR(tracks[0].velocity_covariance(1, 1), 0.16, 1e-12);  // (0.1 4)^2
}

TEST(PerfectPerception, WhatIsChartedIsKnownAndTheRestOnceNear) {
  Obstacle charted{.kind = Obstacle::Kind::sphere, .position = {100, 0, 0}, .radius = 1};
  Obstacle uncharted = charted;
  uncharted.charted = false;
  const std::vector<Obstacle> all{charted, uncharted};
  const std::vector<Mark> known = known_from({0, 0, 0}, {.obstacles = all}, {.obstacles = 10});
  ASSERT_EQ(known.size(), 1U);
  EXPECT_TRUE(std::get<bool>(known[0]));
  EXPECT_EQ(known_from({86, 0, 0}, {.obstacles = all}, {.obstacles = 10}).size(), 2U);
}

TEST(PerfectPerception, WhoLooksNoFartherIsShownNoObstacleThatIs) {
  const Obstacle charted{.kind = Obstacle::Kind::sphere, .position = {100, 0, 0}, .radius = 1};
  const std::vector<Obstacle> all{charted};
  EXPECT_EQ(known_from({0, 0, 0}, {.obstacles = all}, {}, 99.0).size(), 1U);
  EXPECT_EQ(known_from({0, 0, 0}, {.obstacles = all}, {}, 98.9).size(), 0U);
  EXPECT_EQ(known_from({100, 0, 0}, {.obstacles = all}, {}, -endless).size(), 0U);
}

TEST(PerfectPerception, FoundByIndexesTheSameObstaclesAreKnownInTheSameOrder) {
  Rng rng{11};
  for (const std::size_t count : {20U, 100U, 1000U}) {
    const RandomObstacles scene{count, 1000.0, Rng{count}};
    const auto index_where = [&](bool charted) {
      return ObstacleIndex{
          count, [&](std::size_t i) { return scene.all[i].charted == charted ? &scene.all[i] : nullptr; }};
    };
    const FixedIndexes indexes{index_where(true), index_where(false)};
    std::size_t seen = 0;
    for (int look = 0; look < 50; ++look) {
      const Vec3 place = RandomObstacles::place(1200.0, rng);
      for (const double range : {-endless, 0.0, 30.0, 300.0, endless}) {
        for (const double farthest : {-endless, 5.0, 40.0, 1e4, endless}) {
          const Reach reach{.obstacles = range};
          const auto known = known_from(place, {.obstacles = scene.all}, reach, farthest);
          ASSERT_EQ(known_from(place, {.obstacles = scene.all, .indexes = &indexes}, reach, farthest), known)
              << count << ", range " << range << ", farthest " << farthest;
          seen += known.size();
        }
      }
    }
    EXPECT_GT(seen, 0U);
  }
}

/// A crowd in which some are silent, some at one place and many equally far, and two things drift.
struct Crowd {
  std::vector<Mover> movers;
  Mailbox heard;
  Vicinity places;

  Crowd(std::size_t count, Rng rng) {
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 at{std::round(rng.uniform(-20, 20)), std::round(rng.uniform(-20, 20)), rng.uniform(0, 10)};
      movers.push_back(vehicle(static_cast<std::uint32_t>(i), at));
      movers.back().silent = rng.index(3) == 0;
      heard.push_back(message(static_cast<std::uint32_t>(i), at + Vec3{0.5, 0, 0}));
      heard.back().told = !movers.back().silent;
    }
    movers.push_back(drifter({3, 3, 3}));
    movers.push_back(drifter({-3, 3, 3}));
    movers.back().id = TrackId{0x8000'0004U};
    places.update(count,
                  [&](std::size_t i) { return movers[i].silent ? movers[i].position : heard[i].position; });
  }

  Scene seen_by(std::size_t index) const { return {.own_index = index, .movers = movers, .heard = heard}; }
};

std::vector<TrackId> ids_of(const Scene& scene, const Reach& reach,
                            std::size_t most = std::numeric_limits<std::size_t>::max()) {
  const VehicleState x{.p_n = scene.movers[scene.own_index].position};
  std::vector<Near> near;
  std::vector<Track> tracks;
  perceive_movers(scene, {x, x, 1.0, most}, reach, near, tracks);
  std::vector<TrackId> ids;
  for (const Track& track : tracks) ids.push_back(track.id);
  return ids;
}

TEST(PerfectPerception, SortedByPlaceTheSameAreSeenInTheSameOrder) {
  for (const std::size_t count : {2U, 20U, 300U}) {
    const Crowd crowd{count, Rng{count}};
    for (const double range : {0.0, 4.0, 15.0, 1e9}) {
      for (std::size_t own = 0; own < count; own += 1 + count / 10) {
        const Reach reach{.vehicles = range, .obstacles = 6.0};
        const std::vector<TrackId> all = ids_of(crowd.seen_by(own), reach);
        Scene sorted = crowd.seen_by(own);
        sorted.places = &crowd.places;
        sorted.heard_at_once = true;
        ASSERT_EQ(ids_of(sorted, reach), all) << count << " within " << range;

        // of whoever looks at a few alone, the first ones
        for (const std::size_t most : {0U, 1U, 10U}) {
          const std::vector<TrackId> first{all.begin(),
                                           all.begin() + static_cast<long>(std::min(most, all.size()))};
          ASSERT_EQ(ids_of(sorted, reach, most), first) << most << " of " << count << " within " << range;
          ASSERT_EQ(ids_of(crowd.seen_by(own), reach, most), first);
        }
      }
    }
  }
}

}  // namespace
}  // namespace fairway
