// SPDX-License-Identifier: Apache-2.0
#include "fairway/onboard/policy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "fairway/core/text.hpp"

namespace fairway {
namespace {

std::string text_of(const ParamValue& value) {
  if (const double* number = std::get_if<double>(&value)) return number_text(*number);
  return std::get<std::string>(value);
}

TEST(OnboardPolicy, ThePageHasEveryFieldWithItsDefaultAndMeaning) {
  std::ifstream file{FAIRWAY_SOURCE_DIR "/docs/onboard.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  for (const ParamInfo& field : describe_params<OnboardPolicy>()) {
    const std::string row = "| `" + field.name + "` | " + text_of(field.value) + " | " + field.meaning + " |";
    EXPECT_THAT(page, ::testing::HasSubstr(row));
  }
  for (const char* const name : EnumNames<LostPolicy>::names)
    EXPECT_THAT(page, ::testing::HasSubstr(std::string("`") + name + "`"));
}

}  // namespace
}  // namespace fairway
