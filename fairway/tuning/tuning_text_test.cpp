// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/tuning_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

TEST(TuningDocument, OfALargerBudgetIsNotReplacedByASmallerOne) {
  TuningResult result;
  result.budget = 800;
  result.runs = 780;
  nlohmann::json document = to_json(TuningFile{}, result);
  const auto refusal = [&](std::size_t budget) {
    return refusal_by([&] { refuse_smaller_budget(document, "tuned/tuning.json", budget); });
  };
  EXPECT_EQ(refusal(799),
            "tuned/tuning.json: was made with a budget of 800 runs, and --budget 799 is smaller; expected at "
            "least 800 to go on from there, another --out, or --force to replace it");
  EXPECT_EQ(refusal(800), "accepted");
  EXPECT_EQ(refusal(1600), "accepted");

  document.erase("budget");
  EXPECT_EQ(refusal(779),
            "tuned/tuning.json: was made with a budget of at least 780 runs, and --budget 779 is smaller; "
            "expected at least 780 to go on from there, another --out, or --force to replace it");
  EXPECT_EQ(refusal(780), "accepted");
  document["runs"] = "many";
  EXPECT_EQ(refusal(1), "accepted") << "whoever writes into it by hand is not held to it";
}

}  // namespace
}  // namespace fairway
