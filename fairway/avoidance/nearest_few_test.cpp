// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/nearest_few.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

TEST(NearestFew, AsLongAsThereIsRoomPlacesAreInOrder) {
  NearestFew<3> few;
  EXPECT_EQ(few.place_for(9.0), 0U);
  EXPECT_EQ(few.place_for(1.0), 1U);
  EXPECT_EQ(few.place_for(5.0), 2U);
  EXPECT_FALSE(few.left_out());
  EXPECT_EQ(few.place_for(9.0), 3U) << "it is no nearer than the farthest";
  EXPECT_TRUE(few.left_out());
  EXPECT_EQ(few.place_for(2.0), 0U);
  EXPECT_EQ(few.place_for(3.0), 2U);
  EXPECT_EQ(few.place_for(3.0), 3U);
}

TEST(NearestFew, OfAnyNumberTheNearestAreLeft) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    Rng rng = Rng{5}.stream("gaps", i);
    std::vector<double> all(1 + rng.index(60)), left(8, 1e9);
    NearestFew<8> few;
    for (double& gap : all) {
      gap = rng.uniform(-1.0, 9.0);
      if (const std::size_t place = few.place_for(gap); place < 8) left[place] = gap;
    }
    std::ranges::sort(all);
    left.resize(few.count());
    std::ranges::sort(left);
    all.resize(std::min<std::size_t>(all.size(), 8));
    EXPECT_EQ(left, all) << i;
  }
}

TEST(NearestFew, WhoIsKeptIsNotGivenUp) {
  NearestFew<3> few;
  (void)few.place_for(9.0);
  (void)few.place_for(8.0);
  few.keep(1);
  (void)few.place_for(7.0);
  EXPECT_EQ(few.place_for(1.0), 1U);
  EXPECT_EQ(few.place_for(1.5), 2U);
  few.keep();
  EXPECT_EQ(few.place_for(0.0), 3U);
}

}  // namespace
}  // namespace fairway
