// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/crew.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace fairway {
namespace {

TEST(Crew, GoesThroughEveryPartOnce) {
  for (const std::size_t hands : {1U, 2U, 4U}) {
    Crew crew{hands};
    EXPECT_EQ(crew.hands(), hands);
    for (const std::size_t parts : {0U, 1U, 2U, 100U}) {
      for (int turn = 0; turn < 200; ++turn) {
        std::vector<int> done(parts);
        std::vector<std::size_t> by(hands);
        crew.go_through(parts, [&](std::size_t part, std::size_t hand) {
          ++done[part];
          ++by[hand];
        });
        ASSERT_EQ(done, std::vector<int>(parts, 1));
        ASSERT_EQ(std::accumulate(by.begin(), by.end(), std::size_t{0}), parts);
      }
    }
  }
}

}  // namespace
}  // namespace fairway
