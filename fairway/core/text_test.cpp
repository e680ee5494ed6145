// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/text.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(ShellWord, LeavesPlainWordsAsTheyAre) {
  for (const char* plain : {"scenarios/head_on.yaml", "exam.crit_dist_m=-6.5", "apf+saw", "a@b:c,d%"})
    EXPECT_EQ(shell_word(plain), plain);
}

TEST(ShellWord, QuotesWhatAShellWouldTakeForMore) {
  EXPECT_EQ(shell_word("vehicles[*].radius_m=1"), "'vehicles[*].radius_m=1'");
  EXPECT_EQ(shell_word("{algorithm: apf}"), "'{algorithm: apf}'");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("it's $HOME"), "'it'\\''s $HOME'");
}

}  // namespace
}  // namespace fairway
