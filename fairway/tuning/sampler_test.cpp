// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/sampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fairway/core/text.hpp"

namespace fairway {
namespace {

using Kind = TunedParameter::Kind;

const std::vector<TunedParameter> parameters{
    {.name = "horizon_s", .kind = Kind::number, .range = {1, 100}, .logarithmic = true, .usual = 5},
    {.name = "neighbours_count", .kind = Kind::integer, .range = {1, 20}, .usual = 10},
    {.name = "symmetry", .kind = Kind::choice, .choices = {"none", "starboard", "by_id"}, .usual = 0}};

/// Best at a horizon of 30 s, 4 neighbours and the last choice.
double loss(const Setting& s) {
  return std::fabs(std::log(s[0] / 30.0)) + 0.2 * std::fabs(s[1] - 4.0) + (s[2] == 2.0 ? 0.0 : 1.0);
}

Setting searched(Sampler sampler, int generations) {
  Setting best = usual_setting(parameters);
  for (int g = 0; g < generations; ++g) {
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < sampler.population(); ++i) settings.push_back(sampler.ask());
    std::ranges::stable_sort(settings, {}, loss);
    sampler.tell(settings);
    if (loss(settings.front()) < loss(best)) best = settings.front();
  }
  return best;
}

TEST(Sampler, FindsNumbersIntegersAndChoicesTogether) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Setting best = searched(Sampler{parameters, Rng{seed}}, 60);
    EXPECT_NEAR(best[0], 30.0, 1.0) << seed;
    EXPECT_EQ(best[1], 4.0) << seed;
    EXPECT_EQ(best[2], 2.0) << seed;
  }
}

TEST(Sampler, EveryDrawIsInItsRangeAndWhole) {
  Sampler sampler{parameters, Rng{7}};
  for (int i = 0; i < 2000; ++i) {
    const Setting s = sampler.ask();
    EXPECT_GE(s[0], 1.0);
    EXPECT_LE(s[0], 100.0);
    EXPECT_EQ(s[0], to_six_digits(s[0])) << "what is tried is what is written";
    EXPECT_EQ(s[1], std::round(s[1]));
    EXPECT_GE(s[1], 1.0);
    EXPECT_LE(s[1], 20.0);
    EXPECT_TRUE(s[2] == 0.0 || s[2] == 1.0 || s[2] == 2.0);
  }
}

TEST(Sampler, TheSameSeedProposesTheSame) {
  EXPECT_EQ(searched(Sampler{parameters, Rng{3}}, 10), searched(Sampler{parameters, Rng{3}}, 10));
  Sampler a{parameters, Rng{3}}, b{parameters, Rng{4}};
  EXPECT_NE(a.ask(), b.ask());
}

TEST(Sampler, AChoiceThatLosesIsStillTriedNowAndThen) {
  Sampler sampler{parameters, Rng{5}};
  for (int g = 0; g < 40; ++g) {
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < sampler.population(); ++i) settings.push_back(sampler.ask());
    std::ranges::stable_sort(settings, {}, loss);
    sampler.tell(settings);
  }
  int others = 0;
  for (int i = 0; i < 1000; ++i) others += sampler.ask()[2] != 2.0 ? 1 : 0;
  EXPECT_GT(others, 40);
  EXPECT_LT(others, 250);
}

TEST(Sampler, LearnsNothingOfASettingThatNoOtherStandsBeside) {
  Sampler told{{parameters[1], parameters[2]}, Rng{5}}, untold = told;
  told.tell(std::vector<Setting>{{20, 1}});
  EXPECT_EQ(told.ask(), untold.ask());
}

TEST(Setting, AllOfASmallSpaceAreKnownAndNoneOfALargerOne) {
  const std::vector<TunedParameter> small{
      {.name = "symmetry", .kind = Kind::choice, .choices = {"none", "starboard"}},
      {.name = "neighbours_count", .kind = Kind::integer, .range = {4, 6}}};
  const std::vector<Setting> all{{0, 4}, {0, 5}, {0, 6}, {1, 4}, {1, 5}, {1, 6}};
  EXPECT_EQ(all_settings(small, 6), all);
  EXPECT_TRUE(all_settings(small, 5).empty());
  EXPECT_TRUE(all_settings(parameters, 1'000'000).empty()) << "a number has no end of values";
}

TEST(Setting, IsWrittenIntoTheAvoider) {
  EXPECT_EQ(avoider_text("orca3d", parameters, {12.5, 8, 1}),
            "{algorithm: orca3d, horizon_s: 12.5, neighbours_count: 8, symmetry: starboard}");
  EXPECT_EQ(avoider_text("{algorithm: apf, w2_ratio: 3}", {parameters[1]}, {8}),
            "{algorithm: apf, w2_ratio: 3, neighbours_count: 8}");
}

}  // namespace
}  // namespace fairway
