// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/envelope_numbers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"

namespace fairway {
namespace {

using Numbers = std::vector<std::pair<std::string, std::string>>;

const Numbers least_known{{"ahead_mps", "1.6"},
                          {"acceleration_mps2", "0.3"},
                          {"deceleration_mps2", "0.2"},
                          {"turn_acceleration_radps2", "0.4"},
                          {"turn_rates_radps", "0.2, 0.3, 0.4 0.5"}};

/// Of those with one more; empty if there is nothing to say.
std::string refusal(const Numbers& more, const std::string& without = "") {
  Numbers numbers = least_known;
  std::erase_if(numbers, [&](const auto& number) { return number.first == without; });
  numbers.insert(numbers.end(), more.begin(), more.end());
  try {
    envelope_of_numbers(numbers, "envelope.");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(EnvelopeNumbers, EveryMemberIsGivenByTheNameThatIsShown) {
  Numbers numbers;
  double next = 0.125;
  for_each_member<Envelope>([&](const auto& m) {
    std::string text;
    const std::size_t count = sizeof(m.at) > 0 ? sizeof(Envelope{}.*(m.at)) / sizeof(double) : 0;
    for (std::size_t i = 0; i < count; ++i)
      text += (i > 0 ? ", " : "") + number_text(2.0 - (next += 0.03125));
    numbers.emplace_back(m.name_with_unit(), text);
  });
  const Envelope envelope = envelope_of_numbers(numbers);
  EXPECT_EQ(envelope.ahead, 1.84375);
  EXPECT_EQ(envelope.turn_rates[3], envelope.turn_rates[0] - 3 * 0.03125);
  EXPECT_EQ(envelope.following_errors[5], 2.0 - next);
  int members = 0;
  for_each_member<Envelope>([&](const auto& m) {
    ++members;
    EXPECT_NE(envelope.*(m.at), Envelope{}.*(m.at)) << m.name;
  });
  EXPECT_EQ(members, static_cast<int>(numbers.size()));
}

TEST(EnvelopeNumbers, WhatIsNotGivenIsZero) {
  const Envelope envelope = envelope_of_numbers(least_known);
  EXPECT_EQ(envelope.astern, 0.0);
  EXPECT_EQ(envelope.turn_rate(1.6), 0.5);
}

TEST(EnvelopeNumbers, WhatIsWrongIsSaidInOneLine) {
  using testing::HasSubstr;
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({{"pivot_m", "-0.4"}}), "");
  EXPECT_THAT(refusal({{"ahed_mps", "1"}}),
              HasSubstr("envelope.ahed_mps: unknown number; did you mean ahead_mps?"));
  EXPECT_EQ(refusal({{"astern_mps", "fast"}}),
            "envelope.astern_mps: is \"fast\"; expected a number, 0 or more");
  EXPECT_EQ(refusal({{"astern_mps", "-1"}}), "envelope.astern_mps: is \"-1\"; expected a number, 0 or more");
  EXPECT_EQ(refusal({{"pivot_m", "nan"}}), "envelope.pivot_m: is \"nan\"; expected a number");
  EXPECT_EQ(refusal({{"ahead_mps", "1"}}), "envelope.ahead_mps: is given twice");
  EXPECT_EQ(refusal({{"following_errors_m", "1 2"}}),
            "envelope.following_errors_m: has 2 numbers; expected 6");
  EXPECT_EQ(refusal({}, "ahead_mps"), "envelope.ahead_mps: is missing; expected greatest speed ahead");
  EXPECT_EQ(refusal({}, "turn_rates_radps"),
            "envelope: an envelope has to have a turn acceleration and turn rates above zero");
  EXPECT_EQ(refusal({{"least_mps", "2"}}), "envelope: an envelope's least speed is above its greatest ahead");
}

TEST(EnvelopeNumbers, AnEnvelopeThatIsNoNumberIsKnown) {
  Envelope envelope = envelope_of_numbers(least_known);
  EXPECT_EQ(why_unusable(envelope), "");
  envelope.turn_rates[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(why_unusable(envelope), "");
  envelope = envelope_of_numbers(least_known);
  envelope.sideways = -1.0;
  EXPECT_NE(why_unusable(envelope), "");
}

}  // namespace
}  // namespace fairway
