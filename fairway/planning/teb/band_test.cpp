// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/band.hpp"

#include <gtest/gtest.h>

#include "fairway/core/angles.hpp"

namespace fairway::teb {
namespace {

const TebParams teb_params;  // dt_ref 0.3 s, hysteresis 0.1 s, 0.4 m/s, 0.3 rad/s

Band band_of(std::vector<double> times) {
  Band band;
  times.push_back(0.0);
  for (std::size_t i = 0; i < times.size(); ++i) {
    band.knots.push_back({static_cast<double>(i), 0.0, 0.0, times[i]});
  }
  return band;
}

std::vector<double> times_of(const Band& band) {
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < band.size(); ++i) times.push_back(band.time(i));
  return times;
}

TEST(Band, AlongALineTakesTheTimeOfTheSpeedLimit) {
  const std::vector<Vec2> path{{0, 0}, {2, 0}, {2, 1}};
  const Band band = band_along(teb_params, path, {{0, 0}, 0.0}, {{2, 1}, pi / 2});
  EXPECT_EQ(band.position(0), Vec2(0, 0));
  EXPECT_EQ(band.position(band.size() - 1), Vec2(2, 1));
  EXPECT_EQ(band.pose(band.size() - 1).heading, pi / 2);
  // 3 m at 0.4 m/s; at the corner the step of 2 / 17 m is shorter than the quarter turn at 0.3 rad/s
  EXPECT_NEAR(band.duration(), 3.0 / 0.4 - 2.0 / 17.0 / 0.4 + pi / 2 / 0.3, 1e-9);
}

TEST(Band, HasAtLeastThreePosesHoweverShortTheWay) {
  const std::vector<Vec2> path{{0, 0}, {0.01, 0}};
  EXPECT_EQ(band_along(teb_params, path, {{0, 0}, 0.0}, {{0.01, 0}, 0.0}).size(), 3U);
  const std::vector<Vec2> point{{1, 1}, {1, 1}};
  const Band band = band_along(teb_params, point, {{1, 1}, 0.0}, {{1, 1}, 0.0});
  for (const double time : times_of(band)) EXPECT_GT(time, 0.0);
}

TEST(Band, ResizingHalvesWhatIsLongerThanTwiceTheReference) {
  Band band = band_of({0.3, 0.7, 0.3});
  band.knots[1][heading_of] = 3.0;
  band.knots[2][heading_of] = -3.0;
  resize(teb_params, band);
  EXPECT_EQ(times_of(band), (std::vector{0.3, 0.35, 0.35, 0.3}));
  EXPECT_EQ(band.position(2), Vec2(1.5, 0.0));
  EXPECT_NEAR(std::abs(wrap_angle(band.pose(2).heading)), pi, 1e-12) << "the short way round";
}

TEST(Band, ResizingHandsOnWhatIsOverTheReference) {
  Band band = band_of({0.3, 0.45, 0.2, 0.3});
  resize(teb_params, band);
  ASSERT_EQ(band.size(), 5U);
  EXPECT_NEAR(band.time(1), 0.3, 1e-12);
  EXPECT_NEAR(band.time(2), 0.35, 1e-12);
  EXPECT_EQ(band.position(2), Vec2(2.0, 0.0));
}

TEST(Band, ResizingMergesWhatIsShort) {
  Band band = band_of({0.3, 0.09, 0.09, 0.09, 0.3, 0.05});
  resize(teb_params, band);
  ASSERT_EQ(band.size(), 4U);
  EXPECT_NEAR(band.time(1), 0.27, 1e-12);
  EXPECT_NEAR(band.time(2), 0.35, 1e-12);
  EXPECT_EQ(band.position(band.size() - 1), Vec2(6.0, 0.0));
}

TEST(Band, ResizingKeepsTheDurationAndTheEnds) {
  for (const bool dynamic : {false, true}) {
    TebParams p;
    p.include_dynamic_obstacles = dynamic;
    Band band = band_of({0.02, 2.7, 0.45, 0.11, 0.1, 0.9, 0.05});
    const double duration = band.duration();
    resize(p, band);
    EXPECT_NEAR(band.duration(), duration, 1e-12);
    EXPECT_EQ(band.position(0), Vec2(0, 0));
    EXPECT_EQ(band.position(band.size() - 1), Vec2(7, 0));
  }
}

TEST(Band, ResizingMergesATimeThatIsNotPositive) {
  Band band = band_of({0.3, -0.1, 0.4, 0.3});
  resize(teb_params, band);
  for (const double time : times_of(band)) EXPECT_GT(time, 0.0);
}

TEST(Band, AdvancingDropsThePosesThatWerePassed) {
  Band band = band_of({0.3, 0.3, 0.3, 0.3, 0.3, 0.3});
  advance(teb_params, band, {{2.1, 0.1}, 0.2}, {{6.5, 0.0}, 0.1});
  ASSERT_EQ(band.size(), 5U);
  EXPECT_EQ(band.position(0), Vec2(2.1, 0.1));
  EXPECT_EQ(band.pose(0).heading, 0.2);
  EXPECT_EQ(band.position(1), Vec2(3, 0));
  EXPECT_EQ(band.position(4), Vec2(6.5, 0.0));
}

TEST(Band, AdvancingLeavesTheLeastNumberOfPoses) {
  Band band = band_of({0.3, 0.3, 0.3});
  advance(teb_params, band, {{2.9, 0.0}, 0.0}, {{3.0, 0.0}, 0.0});
  EXPECT_EQ(band.size(), 3U);
}

TEST(Band, LeadsElsewhereWhenItsEndMovedOrTurned) {
  const Band band = band_of({0.3, 0.3, 0.3});  // ends at (3, 0), heading north
  EXPECT_TRUE(still_leads_to(teb_params, band, {{3.9, 0.0}, 0.7}));
  EXPECT_FALSE(still_leads_to(teb_params, band, {{4.1, 0.0}, 0.0}));
  EXPECT_FALSE(still_leads_to(teb_params, band, {{3.0, 0.0}, -0.8}));
}

}  // namespace
}  // namespace fairway::teb
