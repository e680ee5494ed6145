// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/crew.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

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

/// While it lives the system makes no thread: each would have a stack larger than all memory there can be.
struct NoMoreThreads {
  NoMoreThreads() {
    pthread_getattr_default_np(&usual);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, std::size_t{1} << 56);
    pthread_setattr_default_np(&attributes);
    pthread_attr_destroy(&attributes);
  }
  ~NoMoreThreads() {
    pthread_setattr_default_np(&usual);
    pthread_attr_destroy(&usual);
  }
  pthread_attr_t usual;
};

TEST(Crew, GoesThroughEveryPartByAsManyHandsAsThereAre) {
  const NoMoreThreads none;
  Crew crew{4};
  EXPECT_EQ(crew.hands(), 1U);
  int done = 0;
  crew.go_through(10, [&](std::size_t, std::size_t hand) { done += hand == 0 ? 1 : 100; });
  EXPECT_EQ(done, 10);
  EXPECT_EQ(Crew{crew}.hands(), 1U);
}

}  // namespace
}  // namespace fairway
