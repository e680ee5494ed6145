// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/vicinity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

using ::testing::UnorderedElementsAreArray;

constexpr double everywhere = std::numeric_limits<double>::infinity();

Vec3 anywhere(double most, Rng& rng) {
  return {rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most)};
}

/// Points that wander by up to `stride` along each axis at a time, some of them at one place; one in
/// fifty is nowhere for a while.
struct Wanderers {
  std::vector<Vec3> points;
  Vicinity vicinity;
  Rng rng;
  Crew crew;

  Wanderers(std::size_t count, double size, const Vicinity::Lists& lists, std::size_t hands = 1)
      : points(count), vicinity{lists}, rng{count}, crew{hands} {
    for (Vec3& point : points) point = anywhere(size, rng);
    for (std::size_t i = 0; i + 1 < count; i += 9) points[i + 1] = points[i];
  }

  void wander(double stride) {
    for (Vec3& point : points) point += anywhere(stride, rng);
    if (!points.empty()) {
      Vec3& one = points[rng.index(points.size())];
      if (rng.index(50) == 0) one = is_finite(one) ? Vec3::Constant(std::nan("")) : Vec3::Zero();
    }
    vicinity.update(
        points.size(), [&](std::size_t i) { return points[i]; }, &crew);
  }

  std::vector<std::size_t> compared(const Vec3& place, double reach, std::size_t but) const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i != but && (points[i] - place).squaredNorm() <= reach * reach) all.push_back(i);
    }
    return all;
  }
};

void hold_to_comparison(Wanderers& wanderers, std::size_t index, const Vec3& place, double reach) {
  std::vector<std::size_t> all, others;
  const Vicinity& vicinity = wanderers.vicinity;
  vicinity.visit(place, reach, [&](std::size_t i, double) { all.push_back(i); });
  vicinity.visit_others(index, place, reach, [&](std::size_t i, double distance2) {
    EXPECT_EQ(distance2, (wanderers.points[i] - place).squaredNorm());
    others.push_back(i);
  });
  ASSERT_THAT(all, UnorderedElementsAreArray(wanderers.compared(place, reach, wanderers.points.size())));
  ASSERT_THAT(others, UnorderedElementsAreArray(wanderers.compared(place, reach, index)));

  for (const std::size_t count : {1U, 5U}) {
    const double enough = vicinity.reach_of(count, index, place);
    const std::size_t found = wanderers.compared(place, enough, index).size();
    ASSERT_TRUE(found >= count || std::isinf(enough)) << found << " within " << enough;
  }
}

TEST(Vicinity, FindsWhatAComparisonWithEveryPointFindsAsTheyMove) {
  for (const Vicinity::Lists& lists :
       {Vicinity::Lists{}, Vicinity::Lists{.least = 6.0}, Vicinity::Lists{.most = 15.0, .usual_count = 14.0},
        Vicinity::Lists{.most = 0.0}}) {
    for (const std::size_t count : {0U, 1U, 24U, 25U, 300U}) {
      for (const double stride : {0.0, 0.05, 5.0}) {
        Wanderers wanderers{count, 40.0, lists};
        for (int step = 0; step < 15; ++step) {
          wanderers.wander(stride);
          if (count == 0) continue;
          const std::size_t index = wanderers.rng.index(count);
          for (const double reach : {0.0, 5.0, 12.0, everywhere}) {
            hold_to_comparison(wanderers, index, wanderers.points[index], reach);
            hold_to_comparison(wanderers, index, wanderers.points[index] + anywhere(2.0, wanderers.rng),
                               reach);
          }
        }
      }
    }
  }
}

TEST(Vicinity, FindsTheSameWhoeverSortsThem) {
  for (const double stride : {0.05, 5.0}) {
    Wanderers alone{300, 40.0, {.least = 6.0}}, shared{300, 40.0, {.least = 6.0}, 3};
    for (int step = 0; step < 40; ++step) {
      alone.wander(stride);
      shared.wander(stride);
      hold_to_comparison(shared, 17, shared.points[17], 12.0);
      for (std::size_t i = 0; i < 300; ++i)
        ASSERT_EQ(alone.vicinity.sure_reach(i, alone.points[i]),
                  shared.vicinity.sure_reach(i, shared.points[i]));
    }
  }
}

TEST(Vicinity, ACrowdTooDenseForListsIsFoundAllTheSame) {
  Wanderers wanderers{200, 0.1, {.least = 6.0}};
  wanderers.wander(0.01);
  EXPECT_LT(wanderers.vicinity.sure_reach(0, wanderers.points[0]), 0.0);
  hold_to_comparison(wanderers, 7, wanderers.points[7], 0.05);
}

/// What each of the fleet of `fairway bench --fleet` has to look at in a step: vehicles on a lattice of 11 m,
/// up to 2 m off, each under way at 0.5 m/s and 20 Hz, who look round as far as 15 m.
struct LooksOfALattice {
  double on_a_list{};  ///< of each, on the average of all steps
  double most_on_one{};
  int sorted{};        ///< how often all were sorted anew, of 200 steps
  bool by_list{true};  ///< nobody had to look beyond the list

  explicit LooksOfALattice(std::size_t count) {
    constexpr int steps = 200;
    Rng rng{1};
    std::size_t side = 1;
    while (side * side * side < count) ++side;
    std::vector<Vec3> points, strides;
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector<std::size_t, 3> cell{i % side, i / side % side, i / (side * side)};
      points.push_back(11.0 * cell.cast<double>() + anywhere(2.0, rng));
      const double angle = rng.uniform(-3.14, 3.14);
      strides.push_back(0.5 / 20.0 * Vec3{std::cos(angle), std::sin(angle), 0.0});
    }
    Vicinity vicinity{{.most = 15.0, .usual_count = 14.0}};
    double reach_before = 0.0;
    for (int step = 0; step < steps; ++step) {
      for (std::size_t i = 0; i < count; ++i) points[i] += strides[i];
      vicinity.update(count, [&](std::size_t i) { return points[i]; });
      // what a list surely holds shrinks as they move, until all are sorted again
      const double reach = vicinity.sure_reach(0, points[0]);
      sorted += reach > reach_before ? 1 : 0;
      reach_before = reach;
      for (std::size_t i = 0; i < count; ++i) {
        by_list = by_list && vicinity.sure_reach(i, points[i]) >= 15.0;
        double found = 0.0;
        vicinity.visit_others(i, points[i], vicinity.sure_reach(i, points[i]),
                              [&](std::size_t, double) { found += 1.0; });
        on_a_list += found / static_cast<double>(steps * count);
        most_on_one = std::max(most_on_one, found);
      }
    }
  }
};

TEST(Vicinity, WhatEachLooksAtDoesNotGrowWithTheFleet) {
  const LooksOfALattice few{256}, many{4000};
  for (const LooksOfALattice& each : {few, many}) {
    EXPECT_TRUE(each.by_list);
    // a list reaches 15 m and a margin of a tenth: a ball of 18 800 m3, of which each has 11^3
    EXPECT_LT(each.on_a_list, 14.2);
    EXPECT_LT(each.most_on_one, 2 * 14.2);
    EXPECT_LE(each.sorted, 200 / 10);  // half of the margin of 1.5 m is gone in thirty steps
  }
  EXPECT_LT(many.on_a_list, 1.5 * few.on_a_list);  // more of the few are at the rim, where half is empty
}

TEST(Vicinity, AsManyAsAreMeantAreOnAListHoweverFarApartTheyAre) {
  for (const double size : {4.0, 40.0, 4000.0}) {
    Wanderers wanderers{1000, size, {.least = 0.001 * size, .usual_count = 8.0}};
    double on_lists = 0.0;
    for (int step = 0; step < 200; ++step) wanderers.wander(0.0005 * size);
    for (std::size_t i = 0; i < 1000; ++i) {
      const Vec3& place = wanderers.vicinity.place(i);
      wanderers.vicinity.visit_others(i, place, wanderers.vicinity.sure_reach(i, place),
                                      [&](std::size_t, double) { on_lists += 0.001; });
    }
    EXPECT_GT(on_lists, 5.0) << size;
    EXPECT_LT(on_lists, 1.1 * 1.1 * 1.1 * 8.0 * 1.25) << size;
  }
}

TEST(Vicinity, WhoeverComesFromNowhereIsFound) {
  Wanderers wanderers{100, 40.0, {}};
  const std::vector<Vec3> places = wanderers.points;
  for (Vec3& point : wanderers.points) point = Vec3::Constant(std::nan(""));
  for (int step = 0; step < 5; ++step) wanderers.wander(0.0);
  wanderers.points = places;
  wanderers.wander(0.0);
  for (std::size_t i = 0; i < 100; ++i) hold_to_comparison(wanderers, i, wanderers.points[i], 10.0);
}

TEST(Vicinity, WhereAllCrowdTogetherItFindsThemWithoutMoreMemory) {
  Wanderers wanderers{300, 120.0, {.least = 15.0}};
  wanderers.wander(0.5);
  for (int step = 0; step < 25; ++step) {
    for (Vec3& point : wanderers.points) point *= 0.9;
    const long before = allocation_count();
    wanderers.wander(0.01);
    ASSERT_EQ(allocation_count(), before) << step;
    hold_to_comparison(wanderers, 7, wanderers.points[7], 15.0);
  }
}

TEST(Vicinity, DoesNotAllocateOnceItHasSeenThemAll) {
  Wanderers wanderers{500, 40.0, {.most = 15.0}};
  wanderers.wander(0.5);
  const long before = allocation_count();
  for (int step = 0; step < 50; ++step) wanderers.wander(0.5);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace fairway
