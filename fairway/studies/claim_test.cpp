// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/claim.hpp"

#include <gtest/gtest.h>

#include <array>

#include "fairway/studies/study.hpp"

namespace fairway {
namespace {

MeanEstimate between(double low, double high) {
  return {.mean = 0.5 * (low + high), .low = low, .high = high};
}

TEST(Claim, AComparisonIsDecidedWhereTheIntervalsDoNotOverlap) {
  EXPECT_EQ(is_less(between(1, 2), between(3, 4)), Standing::holds);
  EXPECT_EQ(is_less(between(3, 4), between(1, 2)), Standing::reversed);
  EXPECT_EQ(is_less(between(1, 3), between(2, 4)), Standing::undecided);
  EXPECT_EQ(is_less(exactly(1.0), exactly(2.0)), Standing::holds);
  EXPECT_EQ(is_less(exactly(1.0), exactly(1.0)), Standing::undecided);
}

TEST(Claim, NothingIsSaidOfWhatIsMissing) {
  EXPECT_EQ(is_less(exactly(std::nan("")), exactly(1.0)), Standing::not_measured);
  EXPECT_EQ(is_less(exactly(1.0), exactly(std::nan(""))), Standing::not_measured);
  EXPECT_EQ(is_less(estimate_mean({}), exactly(1.0)), Standing::not_measured);  // nobody arrived
  const std::array one{1.0};
  EXPECT_EQ(is_less(estimate_mean(one), exactly(2.0)), Standing::not_measured);  // no interval of one draw
  EXPECT_EQ(all_are(0, 0), Standing::not_measured);
}

TEST(Claim, AllIsAll) {
  EXPECT_EQ(all_are(8, 8), Standing::holds);
  EXPECT_EQ(all_are(7, 8), Standing::does_not_hold);
}

TEST(Claim, NumbersStandBesideTheWordAndNotBesideNothing) {
  EXPECT_EQ(stated("\"It is\"", Standing::reversed, "3 against 2"), "\"It is\": reversed (3 against 2).");
  EXPECT_EQ(stated("\"It is\"", Standing::not_measured, "nan against 2"), "\"It is\": not measured.");
}

TEST(Verdict, WhatWasNotMeasuredOrHasNoSpreadIsNotWithinIt) {
  StudyRow row{.published = 33.0, .measured = std::nan("")};  // without an interval
  judge(row, false);
  EXPECT_EQ(row.verdict, Verdict::not_reproduced);
  row.measured = 99.0;
  judge(row, false);
  EXPECT_EQ(row.verdict, Verdict::not_reproduced);
  row.low = 30.0;
  row.high = 168.0;
  judge(row, false);
  EXPECT_EQ(row.verdict, Verdict::within_spread);
}

}  // namespace
}  // namespace fairway
