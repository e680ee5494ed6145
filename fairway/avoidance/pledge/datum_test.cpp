// SPDX-License-Identifier: Apache-2.0
// Who is not where it says is found out by the distances that modems measure.
#include "fairway/avoidance/pledge/datum.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "fairway/avoidance/pledge/testing/fleet.hpp"

namespace fairway::pledge {
namespace {

/// Members that are off where they say by an error of their own, and measure how far the others are whenever
/// those speak.
struct Measuring {
  Fleet fleet;
  std::vector<Vec3> errors;
  double noise;
  std::vector<DatumWatch> watches;
  std::vector<std::vector<Vec3>> true_places;  ///< by step, then member
  std::vector<double> spoke;                   ///< when each did last [s]
  std::vector<std::vector<AcousticRange>> ranges;
  std::vector<Members> ever_doubted;
  Rng rng{1};

  Measuring(std::vector<Member> all, std::vector<Vec3> off, double deviation = 0.0)
      : fleet{all, 3.2},
        errors{std::move(off)},
        noise{deviation},
        watches(all.size()),
        spoke(all.size(), 0.0),
        ranges(all.size()),
        ever_doubted(all.size()) {}

  Vec3 place(std::size_t i, double time) const {
    return true_places[static_cast<std::size_t>(time / step + 0.5)][i];
  }

  void measure(std::size_t by, std::size_t to, double now) {
    const auto distance = [&](double time) { return (place(to, time) - place(by, time)).norm(); };
    std::erase_if(ranges[by], [&](const AcousticRange& r) { return number(r.to) == to; });
    ranges[by].push_back({.to = VehicleId{static_cast<std::uint32_t>(to)},
                          .distance = 0.5 * (distance(spoke[by]) + distance(now)) + noise * rng.normal(),
                          .deviation = noise,
                          .out = spoke[by],
                          .back = now});
  }

  void go_on() {
    const double now = fleet.time;
    std::vector<bool> speaks;
    for (std::size_t i = 0; i < watches.size(); ++i) speaks.push_back(fleet.has_turn(i));
    fleet.go_on(always);
    true_places.emplace_back();
    for (std::size_t i = 0; i < watches.size(); ++i)
      true_places.back().push_back(fleet.places[i] + errors[i]);
    for (std::size_t to = 0; to < watches.size(); ++to) {
      if (!speaks[to]) continue;
      for (std::size_t by = 0; by < watches.size(); ++by)
        if (by != to && now > 10.0) measure(by, to, now);
      spoke[to] = now;
    }
    for (std::size_t i = 0; i < watches.size(); ++i) {
      watches[i].look(fleet.members[i], ranges[i], true, 0.0);
      ever_doubted[i] |= watches[i].doubted();
    }
  }

  void cross() {
    while (!fleet.is_done() && fleet.time < 600.0) go_on();
    EXPECT_TRUE(fleet.is_done());
  }
};

std::vector<Vec3> none_off(std::size_t count) { return std::vector<Vec3>(count, Vec3::Zero()); }

TEST(DatumWatch, DoubtsNobodyWhoIsWithinItsTube) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Rng rng{seed};
    std::vector<Member> all = cube(rng);
    std::vector<Vec3> off;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vec3 way{rng.normal(), rng.normal(), rng.normal()};
      off.push_back(way.normalized() * rng.uniform(0.0, 1.0));
    }
    Measuring fleet{all, off, 0.2};
    fleet.cross();
    for (const Members& doubted : fleet.ever_doubted) EXPECT_TRUE(doubted.none()) << doubted;
  }
}

TEST(DatumWatch, FindsWhoTellsItsPlaceFromAnotherDatum) {
  Rng rng{1};
  const std::vector<Member> all = cube(rng);
  std::vector<Vec3> off = none_off(all.size());
  off[3] = {5.0, 0.0, 0.0};
  Measuring fleet{all, off, 0.2};
  while (!fleet.watches[0].doubted().test(3) && fleet.fleet.time < 40.0) fleet.go_on();
  EXPECT_TRUE(fleet.watches[0].doubted().test(3)) << "much of the error is along the way";
  fleet.cross();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == 3) continue;
    Members others = fleet.ever_doubted[i];
    others.reset(3);
    EXPECT_TRUE(others.none()) << i << " doubts " << others;
    EXPECT_EQ(fleet.ever_doubted[3].test(i), fleet.ever_doubted[i].test(3)) << "both see the same distance";
  }
}

TEST(DatumWatch, OneMisfitOrADistanceByOneWordIsNoCause) {
  Fleet fleet{three_in_a_plane(), 3.2};
  while (fleet.time < 20.0) fleet.go_on(always);
  DatumWatch watch;
  double unsure = 0.0;
  AcousticRange range{.to = VehicleId{1}, .distance = 1.0, .deviation = 0.1, .out = 20.0, .back = 20.0};
  const auto look = [&] { watch.look(fleet.members[0], std::vector{range}, true, unsure); };
  for (int i = 0; i < 5; ++i, range.out = range.back += 3.2) look();
  EXPECT_TRUE(watch.doubted().none()) << "clocks are in it";
  range.out = range.back - 3.0;
  look();
  look();
  EXPECT_TRUE(watch.doubted().none()) << "it is still the first";
  range.back += 3.2;
  look();
  EXPECT_TRUE(watch.doubted().test(1));
  unsure = 100.0;
  range.back += 3.2;
  look();
  EXPECT_TRUE(watch.doubted().none()) << "whose own place may be that far off blames nobody";
}

}  // namespace
}  // namespace fairway::pledge
