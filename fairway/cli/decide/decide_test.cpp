// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/decide.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <sstream>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

/// Answers (own priority, decisions before, gain); hesitates once it remembers.
struct Counting {
  static constexpr AlgorithmInfo info{.name = "counting", .title = "", .source = ""};
  struct Params {
    double gain_ratio = 0.25;
    static consteval auto fields() {
      return std::tuple{field<&Params::gain_ratio>({0, 1}, "the third component")};
    }
  };
  struct Memory {
    int before = 0;
  };
  Params params;

  Command decide(const Situation& s, Memory& memory, Context&) const noexcept {
    const double before = memory.before++;
    return {.velocity = {-0.0 * s.own.priority, before, params.gain_ratio},
            .mode = before > 0 ? Mode::hold : Mode::avoid};
  }
};

/// Goes where it likes, although it is planar.
struct Flat {
  static constexpr AlgorithmInfo info{.name = "flat", .title = "", .source = "", .planar = true};
  using Params = NoParams;
  using Memory = NoMemory;
  Params params;
  Command decide(const Situation& s, Memory&, Context&) const noexcept {
    return {.velocity = s.preferred_velocity()};
  }
};

Catalog test_catalog() { return Catalog{}.add<Counting>().add<Flat>(); }

std::string line(int id, const std::string& more = "") {
  constexpr const char* form =
      R"({{"period":0.1,"own":{{"id":{},"position":[0,0,0],"velocity":[0,0,0],"yaw":0,"radius":1}},)"
      R"("goal":{{"position":[9,0,9]}},"limits":{{"max_speed":5}}{}}})";
  return fmt::format(fmt::runtime(form), id, more) + "\n";
}

std::string answers(const std::string& in, const DecideOptions& options) {
  std::istringstream input{in};
  std::ostringstream output;
  decide_lines(input, output, test_catalog(), options);
  return output.str();
}

const std::string fresh = "{\"velocity\":[0,0,0.25],\"mode\":\"avoid\"}\n";

TEST(DecideTest, EveryLineMeetsAFreshAvoider) {
  EXPECT_EQ(answers(line(0) + "\n  \n" + line(0), {.algorithm = "counting"}), fresh + fresh);
  EXPECT_EQ(answers("", {.algorithm = "counting"}), "");
}

TEST(DecideTest, WhatCannotBeDecidedOnIsAnsweredWithANoteThatSaysWhy) {
  // each number is finite, and their sum is not
  const std::string track = R"(,"tracks":[{"id":1,"position":[9,0,0],"velocity":[0,0,0],"radius":1,)"
                            R"("position_covariance":[[1e308,0,0],[0,1e308,0],[0,0,1e308]]}])";
  EXPECT_EQ(answers(line(0, track), {.algorithm = "counting"}),
            R"({"velocity":[0,0,0],"mode":"infeasible",)"
            R"("note":"a track has a number that is not finite, or no radius"})"
            "\n");
}

TEST(DecideTest, WithMemoryEachVehicleLivesOn) {
  EXPECT_EQ(answers(line(0) + line(0) + line(1) + line(0), {.algorithm = "counting", .keep_memory = true}),
            fresh + "{\"velocity\":[0,1,0.25],\"mode\":\"hold\"}\n" + fresh +
                "{\"velocity\":[0,2,0.25],\"mode\":\"hold\"}\n");
}

TEST(DecideTest, ParamsOfALineOverrideThoseOfTheOptionsForThatLine) {
  const std::string own = line(0, R"(,"params":{"gain_ratio":1})");
  EXPECT_EQ(
      answers(line(0) + own + own + line(0), {.algorithm = "counting", .params = {{"gain_ratio", 0.5}}}),
      "{\"velocity\":[0,0,0.5],\"mode\":\"avoid\"}\n{\"velocity\":[0,0,1],\"mode\":\"avoid\"}\n"
      "{\"velocity\":[0,0,1],\"mode\":\"avoid\"}\n{\"velocity\":[0,0,0.5],\"mode\":\"avoid\"}\n");
}

TEST(DecideTest, APlanarAlgorithmStaysAtItsDepth) {
  EXPECT_THAT(answers(line(0), {.algorithm = "flat"}),
              testing::MatchesRegex("\\{\"velocity\":\\[3\\.5355[0-9]*,0,0\\],\"mode\":\"cruise\"\\}\n"));
}

/// What comes out before the error, and the error.
std::pair<std::string, std::string> refused(const std::string& in, const DecideOptions& options) {
  std::istringstream input{in};
  std::ostringstream output;
  const std::string said = refusal_by([&] { decide_lines(input, output, test_catalog(), options); });
  return {output.str(), said};
}

TEST(DecideTest, ABadLineIsNamedAndEarlierAnswersStay) {
  const auto [out, error] =
      refused(line(0) + "\n" + line(0, ",\"tracks\":1") + line(0), {.algorithm = "counting"});
  EXPECT_EQ(out, fresh);
  EXPECT_EQ(error, "line 3: tracks: expected a list of tracks, got 1");
}

TEST(DecideTest, ParametersAreChecked) {
  EXPECT_EQ(refused(line(0, R"(,"params":{"gain":1})"), {.algorithm = "counting"}).second,
            "line 1: params.gain: unknown parameter of counting; did you mean gain_ratio?");
  EXPECT_EQ(refused(line(0, R"(,"params":{"gain_ratio":2})"), {.algorithm = "counting"}).second,
            "line 1: params.gain_ratio: is 2; expected a number in [0, 1]");
  EXPECT_EQ(refused("", {.algorithm = "countin"}).second,
            "unknown algorithm \"countin\"; did you mean counting?");
  EXPECT_EQ(refused("", {.algorithm = "counting", .params = {{"gain_ratio", 2.0}}}).second,
            "gain_ratio: is 2; expected a number in [0, 1]");
}

/// A stream that ends each line with a pause, like a program waiting for its answer.
class Conversation : public std::stringbuf {
 public:
  Conversation(const std::vector<std::string>& lines, const std::ostringstream& out)
      : lines_{lines}, out_{out} {}
  std::vector<std::size_t> answered_before;

 private:
  int_type underflow() override {
    answered_before.push_back(out_.str().size());
    if (next_ == lines_.size()) return traits_type::eof();
    current_ = lines_[next_++];
    setg(current_.data(), current_.data(), current_.data() + current_.size());
    return traits_type::to_int_type(current_[0]);
  }
  std::streamsize showmanyc() override { return 0; }

  std::vector<std::string> lines_;
  const std::ostringstream& out_;
  std::size_t next_{};
  std::string current_;
};

TEST(DecideTest, AnswersAreThereBeforeTheNextLineIsAskedFor) {
  std::ostringstream out;
  Conversation conversation{{line(0), line(0)}, out};
  std::istream in{&conversation};
  decide_lines(in, out, test_catalog(), {.algorithm = "counting"});
  EXPECT_EQ(conversation.answered_before, (std::vector<std::size_t>{0, fresh.size(), 2 * fresh.size()}));
}

/// Lines with five neighbours each. They take 0.05 s of the processor; the bound leaves room for
/// sanitizers, and catches what grows with the lines before.
TEST(DecideTest, ManyLinesAreAnsweredQuickly) {
  std::string tracks = ",\"tracks\":[";
  for (int i = 1; i <= 5; ++i) {
    tracks += fmt::format(
        R"({}{{"id":{},"position":[1.23456789012,-5.678901,{}],"velocity":[0.12345,0.3456,0],"radius":1}})",
        i > 1 ? "," : "", i, i);
  }
  std::string in;
  for (int i = 0; i < 2'000; ++i) in += line(0, tracks + "],\"params\":{\"gain_ratio\":0.5}");

  const std::clock_t start = std::clock();
  const std::string out = answers(in, {.algorithm = "counting"});
  const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  RecordProperty("microseconds_per_line", std::to_string(took * 1e6 / 2'000));
  EXPECT_EQ(std::ranges::count(out, '\n'), 2'000);
  EXPECT_LT(took, 3.0);
}

}  // namespace
}  // namespace fairway
