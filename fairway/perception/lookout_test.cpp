// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/lookout.hpp"

#include <gtest/gtest.h>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/perception/testing/quiet_sonar.hpp"

namespace fairway {
namespace {

constexpr double period = 0.05;
constexpr Reach reach{.vehicles = 1e9, .obstacles = 1e9};

Lookout sonar_lookout(const ParamValues& params = {}) { return {"sonar", params, reach, 8, Rng{1}}; }

/// The vehicle 0 stands at the origin; what is round it moves as said.
struct Waters {
  std::vector<Mover> movers = movers_round({}, {});
  std::vector<Obstacle> obstacles;
  Mailbox heard;

  Scene at(double time) {
    for (Mover& mover : movers) mover.position += (time - time_) * mover.velocity;
    time_ = time;
    return {.time = time, .period = period, .movers = movers, .obstacles = obstacles, .heard = heard};
  }

 private:
  double time_{};
};

struct Report {
  std::vector<Track> tracks;
  std::vector<Obstacle> obstacles;
};

const VehicleState at_rest;
const Viewpoint at_the_origin{at_rest, at_rest, 1.0};

/// After so many ticks of watching.
Report report_after(Lookout& lookout, Waters& waters, int ticks) {
  for (int i = 0; i <= ticks; ++i) lookout.sense(waters.at(i * period), at_the_origin);
  Report report;
  std::vector<Near> near;
  lookout.report(waters.at(ticks * period), at_the_origin, near, report.tracks, report.obstacles);
  return report;
}

std::string refusal(std::string_view kind, const ParamValues& params) {
  return refusal_by([&] { Lookout{kind, params, reach, 8, Rng{1}}; });
}

TEST(Lookout, WhatCannotBeIsRefusedWithOneLine) {
  EXPECT_EQ(refusal("sonar", {{"beams_count", 0.0}}),
            "beams_count: is 0; expected a whole number in [1, 1024]");
  EXPECT_EQ(refusal("sonar", {{"echo_range_sigma_m", -0.1}}),
            "echo_range_sigma_m: is -0.1; expected a number in [0, 100]");
  EXPECT_EQ(refusal("sonar", {{"echo_bearing_sigma_deg", -1.0}}),
            "echo_bearing_sigma_deg: is -1; expected a number in [0, 45]");
  EXPECT_EQ(refusal("sonar", {{"min_range_m", 100.0}}), "min_range_m: is not below max_range_m");
  EXPECT_EQ(refusal("sonar", {{"birth_hits_count", 9.0}}),
            "birth_hits_count: is more than birth_pings_count");
  EXPECT_EQ(refusal("sonar", {{"beam_count", 9.0}}),
            "beam_count: unknown parameter; did you mean beams_count?");
  EXPECT_EQ(refusal("sonnar", {}), "kind: unknown perception; did you mean sonar?");
  EXPECT_EQ(refusal("perfect", {{"beams_count", 9.0}}),
            "beams_count: perfect perception takes no parameter but range_m and obstacle_range_m");
}

TEST(Lookout, EveryParameterOfASonarIsDescribedOnce) {
  const auto kinds = perception_kinds();
  ASSERT_EQ(kinds.size(), 2U);
  std::vector<std::string> names;
  for (const ParamInfo& info : kinds[1].params) names.push_back(info.name);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
  EXPECT_EQ(names.size(), 30U);
}

TEST(SonarWatch, ASilentMoverBecomesATrackWithItsVelocity) {
  Waters waters;
  waters.movers.push_back(ball({40, -5, 0}, 2, {-0.5, 0.5, 0}));
  Lookout lookout = sonar_lookout();
  const auto [tracks, obstacles] = report_after(lookout, waters, 100);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_LT((tracks[0].position - waters.movers[1].position).norm(), 0.5);
  EXPECT_LT((tracks[0].velocity - Vec3(-0.5, 0.5, 0)).norm(), 0.25);
  EXPECT_NEAR(tracks[0].radius, 2.0, 0.3);
  EXPECT_FALSE(lookout.echoes().empty());
}

TEST(SonarWatch, WhoTellsIsKnownOnceAndWhoIsSilentToo) {
  Waters waters;
  waters.movers.push_back(ball({40, -10, 0}, 2));
  waters.movers.push_back(ball({40, 10, 0}, 2));
  waters.movers[2].id = TrackId{1};
  waters.movers[2].silent = false;
  waters.heard = {{.from = VehicleId{0}, .radius = 1.0},
                  {.from = VehicleId{1}, .position = {40.5, 10, 2}, .radius = 2.0, .priority = 4}};
  Lookout lookout = sonar_lookout();
  for (Message& message : waters.heard) message.sent = Tick{40};
  const auto tracks = report_after(lookout, waters, 40).tracks;
  ASSERT_EQ(tracks.size(), 2U);
  const auto told = std::ranges::find(tracks, TrackId{1}, &Track::id);
  ASSERT_NE(told, tracks.end());
  EXPECT_EQ(told->priority, 4);
  EXPECT_NEAR(told->position.x(), 40.0, 0.4);
  EXPECT_GT(told->position.z(), 1.5);  // the depth is only told
}

TEST(SonarWatch, ChartedObstaclesAreKnownAndTheOthersAreTracks) {
  Waters waters;
  waters.obstacles = {
      {.kind = Obstacle::Kind::sphere, .position = {30, 10, 0}, .radius = 2},
      {.kind = Obstacle::Kind::sphere, .position = {30, -10, 0}, .radius = 2, .charted = false}};
  Lookout lookout = sonar_lookout();
  const auto [tracks, obstacles] = report_after(lookout, waters, 40);
  ASSERT_EQ(obstacles.size(), 1U);
  EXPECT_TRUE(obstacles[0].charted);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_NEAR(tracks[0].position.y(), -10.0, 0.5);
  EXPECT_LT(tracks[0].velocity.norm(), 0.3);
}

TEST(SonarWatch, ItPingsAtItsRateWithoutDrift) {
  for (const double rate : {15.0, 7.0, 1.0, 20.0, 50.0}) {
    Waters waters;
    waters.movers.push_back(ball({30, 0, 0}, 2));
    Lookout lookout = sonar_lookout({{"rate_hz", rate}});
    std::vector<Echo> last;
    int pings = 0;
    for (int i = 0; i < 2000; ++i) {
      lookout.sense(waters.at(i * period), at_the_origin);
      const bool pinged = !std::ranges::equal(last, lookout.echoes());
      pings += pinged ? 1 : 0;
      last.assign(lookout.echoes().begin(), lookout.echoes().end());
    }
    EXPECT_EQ(pings, static_cast<int>(std::min(rate, 20.0) * 100)) << rate;
  }
}

TEST(SonarWatch, ACopyIsASnapshotThatGoesOnAlikeToTheBit) {
  Waters waters;
  waters.movers.push_back(ball({40, -5, 0}, 2, {-0.5, 0.5, 0}));
  Lookout original = sonar_lookout();
  report_after(original, waters, 50);
  Lookout copy = original;
  Waters same = waters;
  const auto a = report_after(original, waters, 90);
  const auto b = report_after(copy, same, 90);
  ASSERT_FALSE(a.tracks.empty());
  ASSERT_EQ(a.tracks.size(), b.tracks.size());
  for (std::size_t i = 0; i < a.tracks.size(); ++i) {
    EXPECT_EQ(a.tracks[i].position, b.tracks[i].position);
    EXPECT_EQ(a.tracks[i].velocity_covariance, b.tracks[i].velocity_covariance);
  }
  EXPECT_TRUE(std::ranges::equal(original.echoes(), copy.echoes()));
}

TEST(SonarWatch, InSteadyStateNothingIsAllocated) {
  Waters waters;
  for (int i = 0; i < 7; ++i) waters.movers.push_back(ball({20.0 + 5 * i, 8.0 * (i - 3), 0}, 1.5));
  waters.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {30, 20, 0}, .radius = 2}};
  waters.heard = {{.from = VehicleId{1}, .position = {20, -24, 0}}};
  Lookout lookout{"sonar", {{"false_echoes_count", 5.0}}, reach, 8, Rng{1}};
  auto [tracks, obstacles] = report_after(lookout, waters, 20);
  std::vector<Near> near;
  const long before = allocation_count();
  for (int i = 21; i < 400; ++i) {
    lookout.sense(waters.at(i * period), at_the_origin);
    lookout.report(waters.at(i * period), at_the_origin, near, tracks, obstacles);
  }
  EXPECT_EQ(allocation_count() - before, 0);
  EXPECT_GE(tracks.size(), 7U);
}

TEST(SonarWatch, CoincidentWithEverythingNothingIsNotANumber) {
  Waters waters;
  for (int i = 0; i < 4; ++i) waters.movers.push_back(ball({0, 0, 0}, i));
  waters.heard = {{.from = VehicleId{1}}, {.from = VehicleId{2}}};
  Lookout lookout = sonar_lookout({{"min_range_m", 0.0}});
  const auto tracks = report_after(lookout, waters, 100).tracks;
  EXPECT_FALSE(tracks.empty());
  for (const Track& track : tracks) {
    EXPECT_TRUE(is_finite(track.position));
    EXPECT_TRUE(track.position_covariance.allFinite());
  }
}

}  // namespace
}  // namespace fairway
