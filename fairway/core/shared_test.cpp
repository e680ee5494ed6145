// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/shared.hpp"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace fairway {
namespace {

const std::string long_text = "a text that is too long to stand in a string by itself";

TEST(Shared, ACopyIsTheSameTextAndNoSecondOne) {
  const Shared<std::string> text{long_text};
  Shared<std::string> copy{text}, moved{Shared<std::string>{copy}};
  EXPECT_EQ(&*copy, &*text);
  EXPECT_EQ(&*moved, &*text);
  copy = "another";
  EXPECT_EQ(*copy, "another");
  EXPECT_EQ(*text, long_text);
  copy = moved;
  moved.clear();
  EXPECT_TRUE(moved.empty());
  EXPECT_EQ(*copy, long_text);
  EXPECT_EQ(sizeof text, sizeof(void*));
}

TEST(Shared, IsEqualByWhatItSays) {
  EXPECT_EQ(Shared<std::string>{long_text}, Shared<std::string>{long_text});
  EXPECT_EQ(Shared<std::string>{}, Shared<std::string>{""});
  EXPECT_FALSE(Shared<std::string>{"a"} == Shared<std::string>{"b"});
}

TEST(Shared, OfNothingIsAnEmptyOne) {
  const Shared<std::vector<int>> none, some{1, 2, 3};
  EXPECT_EQ(none.size(), 0U);
  EXPECT_EQ(some.size(), 3U);
  EXPECT_EQ(some[2], 3);
  const std::vector<int>& all = some;
  EXPECT_EQ(all, (std::vector{1, 2, 3}));
}

TEST(Shared, IsFreedByTheLastOfManyThreads) {
  Shared<std::string> text{long_text};
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([text] {
      for (int k = 0; k < 1000; ++k) {
        const Shared<std::string> copy = text;
        ASSERT_EQ(*copy, long_text);
      }
    });
  }
  text.clear();
}

}  // namespace
}  // namespace fairway
