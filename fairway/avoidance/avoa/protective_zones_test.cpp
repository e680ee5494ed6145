// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/protective_zones.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fairway/avoidance/avoa/testing/direct_evaluation.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::avoa {
namespace {

/// Anywhere within 20 m, one in eight over own position, at up to 1.5 m/s along each axis.
MovingDisc any_disc(Rng& rng) {
  MovingDisc disc;
  const double range = rng.uniform(0.0, 1.0) < 0.125 ? 1.0 : 20.0;
  disc.position = {rng.uniform(-range, range), rng.uniform(-range, range)};
  disc.velocity = {rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)};
  disc.radius = rng.uniform(0.1, 3.0);
  return disc;
}

/// Compares the picture of several discs with a direct evaluation of every cell of 200 scenes.
void expect_zones_as_evaluated(TimeToContact contact) {
  long forbidden = 0;
  ProtectiveZones zones;
  for (std::uint64_t scene = 0; scene < 200; ++scene) {
    Rng rng = Rng{3}.stream("zones", scene);
    const VelocityGrid grid{static_cast<int>(20 + rng.index(82)), rng.uniform(0.5, 3.0)};
    const double window = rng.uniform(1.0, 15.0);
    std::vector<MovingDisc> discs;
    zones.clear(grid);
    for (std::uint64_t i = 0; i <= scene % 8; ++i) {
      discs.push_back(any_disc(rng));
      zones.add(discs.back(), window, contact);
    }
    for (int cell = 0; cell < grid.cell_count(); ++cell) {
      const bool expected = std::ranges::any_of(
          discs, [&](const MovingDisc& disc) { return forbids(disc, grid.velocity(cell), window, contact); });
      forbidden += expected ? 1 : 0;
      ASSERT_EQ(zones.forbidden()[static_cast<std::size_t>(cell)] != 0, expected)
          << "scene " << scene << ", v = " << grid.velocity(cell).transpose();
    }
  }
  EXPECT_GT(forbidden, 50000);
}

TEST(ProtectiveZones, AreCellByCellWhatEquations1And2Say) { expect_zones_as_evaluated(TimeToContact::bound); }

TEST(ProtectiveZones, WithTheExactTimeAreCellByCellWhatTheRaySays) {
  expect_zones_as_evaluated(TimeToContact::exact);
}

int count(const ProtectiveZones& zones) {
  return static_cast<int>(std::ranges::count(zones.forbidden(), std::uint8_t{1}));
}

TEST(ProtectiveZones, TheExactTimeForbidsLess) {
  Rng rng{4};
  ProtectiveZones bound, exact;
  int less = 0;
  for (int i = 0; i < 100; ++i) {
    const MovingDisc disc = any_disc(rng);
    bound.clear({51, 1.5});
    exact.clear({51, 1.5});
    bound.add(disc, 8.0, TimeToContact::bound);
    exact.add(disc, 8.0, TimeToContact::exact);
    EXPECT_LE(count(exact), count(bound));
    less += count(exact) < count(bound) ? 1 : 0;
  }
  EXPECT_GT(less, 20);
}

TEST(ProtectiveZones, OfWhatIsTooFarForTheWindowAreEmpty) {
  ProtectiveZones zones;
  zones.clear({101, 1.5});
  // 1 m across, 8 s at 1.5 m/s is 12 m; in the corners of the picture, 17 m
  zones.add({.position = {18.1, 0.0}, .radius = 1.0}, 8.0, TimeToContact::bound);
  EXPECT_TRUE(zones.empty());
  zones.add({.position = {12.9, 0.0}, .radius = 1.0}, 8.0, TimeToContact::bound);
  EXPECT_FALSE(zones.empty());
  zones.clear({101, 1.5});
  EXPECT_TRUE(zones.empty());
  EXPECT_EQ(count(zones), 0);
}

TEST(ProtectiveZones, AroundOwnPositionOnlyForbidWhatLeadsFurtherIn) {
  ProtectiveZones zones;
  const VelocityGrid grid{101, 1.5};
  zones.clear(grid);
  zones.add({.position = {0.5, 0.0}, .radius = 1.0}, 8.0, TimeToContact::bound);
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    EXPECT_EQ(zones.forbidden()[static_cast<std::size_t>(cell)] != 0, grid.velocity(cell).x() > 0.0);
  }
}

TEST(ProtectiveZones, OfWhatIsExactlyHereForbidTheWayThatIsCalledInward) {
  ProtectiveZones zones;
  const VelocityGrid grid{101, 1.5};
  zones.clear(grid);
  zones.add({.radius = 1.0, .velocity = {0.3, 0.0}, .inward = {-1.0, 0.0}}, 8.0, TimeToContact::bound);
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    if (std::abs(grid.velocity(cell).x() - 0.3) < 1e-9) continue;  // the boundary
    EXPECT_EQ(zones.forbidden()[static_cast<std::size_t>(cell)] != 0, grid.velocity(cell).x() < 0.3);
  }
}

TEST(ProtectiveZones, AnswerNumbersBeyondAllSense) {
  ProtectiveZones zones;
  zones.clear({101, 1.5});
  for (const double huge : {1e9, 1e154, 1e300}) {
    for (const TimeToContact contact : {TimeToContact::bound, TimeToContact::exact}) {
      zones.add({.position = {huge, 1.0}, .radius = 1.0, .velocity = {-huge, huge}}, 8.0, contact);
      zones.add({.position = {1.0, 0.0}, .radius = huge, .velocity = {-huge, huge}}, 8.0, contact);
      zones.add({.position = {5e-324, 0.0}, .radius = 0.0}, 8.0, contact);
      zones.add({.position = {huge, 0.0}, .radius = huge}, 8.0, contact);
    }
  }
  EXPECT_LE(count(zones), 101 * 101);
}

}  // namespace
}  // namespace fairway::avoa
