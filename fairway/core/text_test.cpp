// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fairway {
namespace {

TEST(Text, IsUtf8UpToTheFirstByteThatIsNoneOfIt) {
  for (const char* text :
       {"", "plain", "\xC3\xA9t\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x9A\xA2", "\xED\x9F\xBF"})
    EXPECT_EQ(not_utf8(text), std::nullopt) << text;
  // a stray byte, a character cut short, an overlong one, half of a pair, beyond the last, none at all
  for (const char* text :
       {"ab\xE9z", "ab\xE2\x82", "ab\xC0\xAF", "ab\xED\xA0\x80", "ab\xF4\x90\x80\x80", "ab\xFF", "ab\x80"})
    EXPECT_EQ(not_utf8(text), 2U) << text;
}

TEST(Text, ANumberToSixDigitsIsTheNearestThatHasNoMore) {
  EXPECT_EQ(to_six_digits(1.0 / 3.0), 0.333333);
  EXPECT_EQ(to_six_digits(-123456789.0), -123457000.0);
  EXPECT_EQ(to_six_digits(1.2345678e-310), 1.23457e-310) << "of a number that has no six digits itself";
  EXPECT_EQ(to_six_digits(0.1), 0.1);
  EXPECT_TRUE(std::isinf(to_six_digits(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(to_six_digits(std::numeric_limits<double>::quiet_NaN())));
}

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
