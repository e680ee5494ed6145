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

  Wanderers(std::size_t count, double size, const Vicinity::Lists& lists)
      : points(count), vicinity{lists}, rng{count} {
    for (Vec3& point : points) point = anywhere(size, rng);
    for (std::size_t i = 0; i + 1 < count; i += 9) points[i + 1] = points[i];
  }

  void wander(double stride) {
    for (Vec3& point : points) point += anywhere(stride, rng);
    if (!points.empty()) {
      Vec3& one = points[rng.index(points.size())];
      if (rng.index(50) == 0) one = is_finite(one) ? Vec3::Constant(std::nan("")) : Vec3::Zero();
    }
    vicinity.update(points.size(), [&](std::size_t i) { return points[i]; });
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

TEST(Vicinity, ACrowdTooDenseForListsIsFoundAllTheSame) {
  Wanderers wanderers{200, 0.1, {.least = 6.0}};
  wanderers.wander(0.01);
  EXPECT_LT(wanderers.vicinity.sure_reach(0, wanderers.points[0]), 0.0);
  hold_to_comparison(wanderers, 7, wanderers.points[7], 0.05);
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
