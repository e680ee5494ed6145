// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/shared.hpp"

#include <gtest/gtest.h>

#include <string>

#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

using Text = Shared<std::string>;

const std::string& text_of(const std::string& text) { return text; }

TEST(Shared, CopiesAreOneInMemoryUntilOneOfThemIsEdited) {
  const Text original{std::string("a text that is too long to be kept in place")};
  const long before = allocation_count();
  Text copy = original;
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(&*copy, &*original);

  copy.edit() += ", and longer";
  EXPECT_EQ(*original, "a text that is too long to be kept in place");
  EXPECT_EQ(*copy, *original + ", and longer");
  EXPECT_NE(copy, original);
}

TEST(Shared, NothingIsKeptOfAPlainValue) {
  const Text first;
  EXPECT_TRUE(first->empty());  // which makes the one that all plain ones have in common
  const long before = allocation_count();
  const Text plain;
  EXPECT_TRUE(plain->empty());
  EXPECT_EQ(&text_of(plain), &*plain);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(plain, Text{std::string()});
}

TEST(Shared, WhatIsTheSameIsMadeOne) {
  const Text one{std::string("same")};
  Text same{std::string("same")}, other{std::string("other")};
  share_if_same(same, one);
  share_if_same(other, one);
  EXPECT_EQ(&*same, &*one);
  EXPECT_EQ(*other, "other");
}

}  // namespace
}  // namespace fairway
