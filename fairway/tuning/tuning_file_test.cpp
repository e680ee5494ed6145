// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/tuning_file.hpp"

#include <gtest/gtest.h>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

/// One parameter of ORCA as it is read. The scenarios need not be there to read it.
TunedParameter parameter_of(const std::string& method, const std::string& parameter) {
  const std::string text = "fairway_tuning: 1\nname: meeting\nmethod: " + method + "\nparameters:\n  " +
                           parameter +
                           "\nscenario: meeting.yaml\ntrain: {seeds: {count: 20}}\n"
                           "validation: {seeds: {first: 101, count: 30}}\n"
                           "test: {seeds: {first: 201, count: 40}}\n";
  static const Catalog methods = builtin_avoiders();
  return parse_tuning_file(text, "t.yaml", methods).tunings.front().parameters.front();
}

std::string refusal_of(const std::string& method, const std::string& parameter) {
  return refusal_by([&] { parameter_of(method, parameter); });
}

TEST(TuningFile, AListOfNumbersIsHeldToTheRangeThatTheMethodDeclares) {
  const std::string at =
      "t.yaml:5:23: parameters.time_horizon_s[1]: expected a number in [0.01, 10000], got ";
  EXPECT_EQ(refusal_of("orca3d", "time_horizon_s: [5, -5]"), at + "-5");
  EXPECT_EQ(refusal_of("orca3d", "time_horizon_s: [5, abc]"), at + "abc");
  EXPECT_EQ(refusal_of("orca3d", "time_horizon_s: [5, '6']"), at + "the text \"6\"");
  EXPECT_EQ(refusal_of("orca3d", "time_horizon_s: [5, [6]]"), at + "a list of 1");
  EXPECT_EQ(refusal_of("orca3d", "time_horizon_s: [5, {uniform: [6, 7]}]"),
            at + "a mapping with the key uniform");
  EXPECT_EQ(refusal_of("orca3d", "time_horizon_s: [abc, 4]"),
            "t.yaml:5:20: parameters.time_horizon_s[0]: expected a number in [0.01, 10000], got abc");
  EXPECT_EQ(refusal_of("orca3d", "max_neighbours_count: [4, 4.5]"),
            "t.yaml:5:29: parameters.max_neighbours_count[1]: expected a whole number in [0, 500], got 4.5");
}

TEST(TuningFile, AListOfSwitchesIsOfTrueAndFalse) {
  EXPECT_EQ(refusal_of("hard_switching", "latch: [true, maybe]"),
            "t.yaml:5:17: parameters.latch[1]: expected true or false, got maybe");
  EXPECT_EQ(parameter_of("hard_switching", "latch: [false, true]").usual, 1.0);
}

TEST(TuningFile, ANumberThatIsGivenTwiceIsKnownHoweverItIsWritten) {
  EXPECT_EQ(refusal_of("orca3d", "time_horizon_s: [4, 4.0, 4e0]"),
            "t.yaml:5:23: parameters.time_horizon_s[1]: 4.0 is given twice, first as 4");
  EXPECT_EQ(refusal_of("orca3d", "max_neighbours_count: [4, 5, 4e0]"),
            "t.yaml:5:32: parameters.max_neighbours_count[2]: 4e0 is given twice, first as 4");
  EXPECT_EQ(refusal_of("orca3d", "symmetry: [none, none]"),
            "t.yaml:5:20: parameters.symmetry[1]: none is given twice");
}

TEST(TuningFile, TheMethodsOwnNumberIsKnownAmongTheChoicesHoweverItIsWritten) {
  EXPECT_EQ(parameter_of("orca3d", "time_horizon_s: [2, 4, 5.0]").usual, 2.0);
  const TunedParameter without = parameter_of("orca3d", "time_horizon_s: [2, 4, 6, 8, 15]");
  EXPECT_EQ(value_text(without, without.usual), "5");
}

}  // namespace
}  // namespace fairway
