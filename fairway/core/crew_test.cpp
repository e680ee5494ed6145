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

TEST(Crew, GivesEachHandTheSameShareFirst) {
  Crew crew{3};
  if (crew.hands() < 3) GTEST_SKIP() << "the system gives no threads";
  std::atomic<int> own{0};
  for (int turn = 0; turn < 200; ++turn) {
    std::atomic<int> at_work{0};
    crew.go_through(3, [&](std::size_t part, std::size_t hand) {
      own += part == hand ? 1 : 0;
      ++at_work;
      while (at_work < 3) std::this_thread::yield();  // nobody has time for another's
    });
  }
  EXPECT_EQ(own, 600);
}

TEST(Crew, LeavesNothingUndoneOfOneWhoIsKeptBusy) {
  Crew crew{2};
  if (crew.hands() < 2) GTEST_SKIP() << "the system gives no threads";
  std::atomic<int> done{0};
  crew.go_through(100, [&](std::size_t part, std::size_t /*hand*/) {
    if (part == 0)
      while (done < 99) std::this_thread::yield();
    ++done;
  });
  EXPECT_EQ(done, 100);
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
