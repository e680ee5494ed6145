// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/testing/refusal.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>

#include "fairway/scenario/load.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string refusal(const std::string& yaml, const Overrides& overrides = {}) {
  return refusal_by([&] { parse_scenario(yaml, "f.yaml", overrides); });
}

/// A good document of two vehicles; `document` and the lines of the first vehicle are added.
std::string with(const std::string& document, const std::string& vehicle = "radius_m: 1") {
  return "fairway: 1\nname: a\nvehicles:\n"
         "  - " +
         vehicle +
         "\n    model: m\n    avoider: direct\n    start: {position_m: [0, 0, 0]}\n"
         "  - {model: m, avoider: direct, start: {position_m: [9, 9, 9]}}\n" +
         document + "\n";
}

TEST(RefusalTest, AGoodDocumentIsNotRefused) { EXPECT_EQ(refusal(with("")), "accepted"); }

TEST(RefusalTest, AnUnknownKeyIsNamedWithItsPlaceAndTheNearestKnown) {
  EXPECT_EQ(refusal(with("steps_s: 1")), "f.yaml:9:1: steps_s: unknown key; did you mean step_s?");
  EXPECT_EQ(refusal(with("", "limits: {max_sped_mps: 1}")),
            "f.yaml:4:14: vehicles[0].limits.max_sped_mps: unknown key; did you mean max_speed_mps?");
  EXPECT_EQ(refusal(with("obstacles: [{spher: {}}]")),
            "f.yaml:9:14: obstacles[0].spher: unknown kind; did you mean sphere?");
  EXPECT_EQ(refusal(with("", "mission: [{transit: {position: [1, 2, 3]}}]")),
            "f.yaml:4:26: vehicles[0].mission[0].transit.position: unknown key; did you mean position_m?");
}

TEST(RefusalTest, AMissingOrWrongUnitNamesTheRightOne) {
  EXPECT_EQ(refusal(with("", "radius: 1")),
            "f.yaml:4:5: vehicles[0].radius: unknown key; did you mean radius_m?");
  EXPECT_EQ(refusal(with("", "radius_cm: 1")),
            "f.yaml:4:5: vehicles[0].radius_cm: unknown key; did you mean radius_m?");
  EXPECT_EQ(refusal(with("", "limits: {max_turn_rate: 1}")),
            "f.yaml:4:14: vehicles[0].limits.max_turn_rate: unknown key; did you mean max_turn_rate_degps?");
  EXPECT_EQ(refusal(with("perception: {range: 1}")),
            "f.yaml:9:14: perception.range: unknown key; did you mean range_m?");
  EXPECT_THAT(refusal(with("", "limits: {max_turn_rate_degps: 1, max_turn_rate_radps: 1}")),
              HasSubstr("max_turn_rate_radps: given before as max_turn_rate_degps; keep one"));
}

TEST(RefusalTest, AMissingKeyIsNamed) {
  EXPECT_EQ(refusal("name: a\nvehicles: [{}]"), "f.yaml:1:1: the key fairway is missing");
  EXPECT_EQ(refusal("{fairway: 1, name: a, vehicles: [{avoider: a, start: {position_m: [0, 0, 0]}}]}"),
            "f.yaml:1:34: vehicles[0]: the key model is missing");
  EXPECT_THAT(refusal("{fairway: 1, name: a, vehicles: [{model: m, avoider: a, start: {yaw_deg: 1}}]}"),
              HasSubstr("vehicles[0].start: the key position_m is missing"));
  EXPECT_THAT(
      refusal(with("", "limits: {}\n    steering: {}\n    mission: [{section: {from_m: [0, 0, 0]}}]")),
      HasSubstr("vehicles[0].mission[0].section: the key to_m is missing"));
  EXPECT_THAT(refusal("{fairway: 1, name: a, vehicles: [{model: {mass_kg: 1}, avoider: a, start: "
                      "{position_m: [0, 0, 0]}}]}"),
              HasSubstr("vehicles[0].model: the key name is missing"));
  EXPECT_EQ(refusal("{fairway: 2, name: a, vehicles: [{}]}"),
            "f.yaml:1:11: fairway: expected the format's version, 1, got 2");
}

TEST(RefusalTest, AWrongTypeSaysWhatWasExpected) {
  EXPECT_EQ(refusal(with("step_s: fast")), "f.yaml:9:9: step_s: expected a number in [1e-05, 1], got fast");
  EXPECT_EQ(refusal(with("step_s: '0.1'")),
            "f.yaml:9:9: step_s: expected a number in [1e-05, 1], got the text \"0.1\"");
  EXPECT_EQ(refusal(with("step_s:")), "f.yaml:9:1: step_s: expected a number in [1e-05, 1], got nothing");
  EXPECT_EQ(refusal(with("stop_when_done: yes")),
            "f.yaml:9:17: stop_when_done: expected true or false, got yes");
  EXPECT_EQ(refusal(with("water: {current_mps: [1, 2]}")),
            "f.yaml:9:22: water.current_mps: expected three numbers [n, e, d], got a list of 2");
  EXPECT_EQ(refusal(with("seed: -1")),
            "f.yaml:9:7: seed: expected a whole number in [0, 18446744073709551615], got -1");
  EXPECT_EQ(refusal(with("exam: [1]")),
            "f.yaml:9:7: exam: expected a mapping: crit_dist_m, safety_distance_m, time_coefficient_ratio, "
            "progress_window_s, got a list of 1");
  EXPECT_THAT(refusal(with("obstacles: {sphere: {}}")),
              HasSubstr("expected a list of obstacles, got a mapping with the key sphere"));
  EXPECT_THAT(refusal(with("", "mission: [hold]")),
              HasSubstr("vehicles[0].mission[0]: expected a mapping with one key of go_to,"));
  EXPECT_THAT(refusal(with("", "steering: {kind: [1]}")),
              HasSubstr("vehicles[0].steering.kind: expected text, got a list of 1"));
  EXPECT_THAT(refusal("just text"), HasSubstr("f.yaml: not a scenario"));
  EXPECT_THAT(refusal(""), HasSubstr("f.yaml: not a scenario"));
}

TEST(RefusalTest, NumbersOutOfRangeShowTheRange) {
  EXPECT_EQ(refusal(with("step_s: 0")), "f.yaml:9:9: step_s: expected a number in [1e-05, 1], got 0");
  // 600 s of such steps are more than can be counted
  EXPECT_EQ(refusal(with("step_s: 1e-300")),
            "f.yaml:9:9: step_s: expected a number in [1e-05, 1], got 1e-300");
  EXPECT_THAT(refusal(with("", "radius_m: -1")),
              HasSubstr("vehicles[0].radius_m: expected a number in [0, 1000], got -1"));
  EXPECT_THAT(refusal(with("obstacles: [{sphere: {position_m: [90, 0, 0], radius_m: 0}}]")),
              HasSubstr("expected a number in (0, 1e+06], got 0"));
  EXPECT_THAT(refusal(with("water: {current_mps: [100, 0, 0]}")),
              HasSubstr("water.current_mps[0]: expected a number in [-10, 10], got 100"));
  EXPECT_THAT(refusal(with("duration_s: -5")),
              HasSubstr("duration_s: expected a number in (0, 1e+07], got -5"));
}

TEST(RefusalTest, NothingThatIsNotFiniteIsANumber) {
  for (const std::string text : {".inf", "-.inf", ".nan", "inf", "nan", "1e999", "infinity"}) {
    EXPECT_THAT(refusal(with("duration_s: " + text)), HasSubstr("duration_s: expected a finite number"))
        << text;
    EXPECT_THAT(refusal(with("", "steering: {gain_ratio: " + text + "}")),
                HasSubstr("steering.gain_ratio: expected a finite number"))
        << text;
  }
}

TEST(RefusalTest, AKeyGivenTwiceIsRefused) {
  EXPECT_EQ(refusal(with("seed: 1\nseed: 2")), "f.yaml:10:1: seed: given twice, before in line 9");
  EXPECT_EQ(refusal(with("", "limits: {max_depth_m: 1, max_depth_m: 1}")),
            "f.yaml:4:30: max_depth_m: given twice, before in line 4");
}

TEST(RefusalTest, DistributionsMustMakeSense) {
  EXPECT_EQ(refusal(with("duration_s: {uniform: [5, 1]}")),
            "f.yaml:9:23: duration_s.uniform: lo is 5, above hi, 1");
  EXPECT_THAT(refusal(with("duration_s: {uniform: [-5, 1]}")),
              HasSubstr("duration_s.uniform[0]: expected a number in (0, 1e+07], got -5"));
  EXPECT_THAT(refusal(with("duration_s: {uniform: 3}")),
              HasSubstr("duration_s.uniform: expected two numbers [lo, hi], got 3"));
  EXPECT_THAT(refusal(with("duration_s: {normal: [1, -2]}")),
              HasSubstr("duration_s.normal[1]: expected a number in [0, 1e+07], got -2"));
  EXPECT_THAT(refusal(with("duration_s: {triangle: [1, 2]}")),
              HasSubstr("duration_s: expected a number, {uniform: [lo, hi]} or {normal: [mean, deviation]}, "
                        "got a mapping with the key triangle"));
}

TEST(RefusalTest, ExpectationsNeedABound) {
  EXPECT_THAT(refusal(with("expect: {makespan_s: {}}")),
              HasSubstr("expect.makespan_s: expected a number, or {min"));
  EXPECT_THAT(refusal(with("expect: {makespan_s: {maxi: 1}}")),
              HasSubstr("expect.makespan_s.maxi: unknown key; did you mean max?"));
  EXPECT_THAT(refusal(with("expect: {makespan_s: {min: 2, max: 1}}")),
              HasSubstr("expect.makespan_s: min is above max"));
}

TEST(RefusalTest, MissionsMustExistAndEnd) {
  EXPECT_THAT(
      refusal(with("missions: {out: []}", "mission: [{run: oat}]")),
      HasSubstr("f.yaml:4:21: vehicles[0].mission[0].run: no mission is named oat; did you mean out?"));
  EXPECT_THAT(refusal(with("missions: {a: [{run: b}], b: [{rendezvous: {}}, {run: c}], c: [{run: b}]}")),
              HasSubstr("missions.c[0].run: missions run each other without end: b -> c -> b"));
  EXPECT_THAT(refusal(with("missions: {a: [{run: a}]}")), HasSubstr("a -> a"));
  EXPECT_THAT(refusal(with("missions: {a: [{run: b, transit: {}}]}")),
              HasSubstr("missions.a[0]: run stands alone"));
  EXPECT_THAT(refusal(with("missions: {a: [{transit: {}}]}")),
              HasSubstr("missions.a[0].transit: the key position_m is missing"));
  EXPECT_THAT(
      refusal(with("", "mission: [{go_to: {position_m: [0, 0, 0], box_m: [1, 1, 1], arrival_m: 1}}]")),
      HasSubstr("keep one"));
}

TEST(RefusalTest, DefaultsAreCheckedEvenIfNobodyTakesThem) {
  EXPECT_EQ(refusal(with("defaults: {radius: 1}")),
            "f.yaml:9:12: defaults.radius: unknown key; did you mean radius_m?");
  EXPECT_THAT(refusal(with("defaults: {radius_m: -1}")),
              HasSubstr("f.yaml:9:22: defaults.radius_m: expected a number in [0, 1000], got -1"));
}

TEST(RefusalTest, AFailureIsOfAKindThatIsKnown) {
  EXPECT_THAT(refusal(with("defaults: {failure: {kind: stop}}")),
              testing::AllOf(HasSubstr("f.yaml:9:"), HasSubstr("did you mean stops?")));
  EXPECT_THAT(refusal(with("defaults: {failure: {under_way_s: 3}}")), HasSubstr("kind is missing"));
}

TEST(RefusalTest, VehiclesMustBeAbleToStart) {
  EXPECT_THAT(refusal("{fairway: 1, name: a, vehicles: []}"),
              HasSubstr("vehicles: zero vehicles; a scenario has 1 to 100000"));
  EXPECT_EQ(refusal(with("", "id: 1")), "f.yaml:8:5: vehicles[1].id: id 1 is that of vehicles[0]");
  EXPECT_EQ(
      refusal(with("", "name: robot1")),
      "f.yaml:8:5: vehicles[1].name: robot1 is the name of vehicles[0], too; expected another name there, "
      "since this one follows from an id");
  EXPECT_THAT(refusal("{fairway: 1, name: a, vehicles: [&v {name: me, model: m, avoider: a, start: "
                      "{position_m: [1, 2, 3]}}, *v]}"),
              HasSubstr("vehicles[1].name: me is the name of vehicles[0], too; expected a name of its own"));
  const std::string together =
      "{fairway: 1, name: a, vehicles: [&v {model: m, avoider: a, start: {position_m: [1, 2, 3]}}, *v]}";
  EXPECT_THAT(
      refusal(together),
      HasSubstr("vehicles[1].start.position_m: vehicles[0] starts at the same place, [1, 2, 3]; move one"));
  EXPECT_EQ(refusal(together, {{"coincident_start", "true"}}), "accepted");
  const std::string near =
      "{fairway: 1, name: a, vehicles: [{model: m, avoider: a, radius_m: 2, start: {position_m: [0, 0, 3]}}, "
      "{model: m, avoider: a, start: {position_m: [0, 2, 3]}}]}";
  EXPECT_EQ(refusal(near),
            "f.yaml:1:146: vehicles[1].start.position_m: the spheres of radius_m of all 2 vehicles overlap "
            "where they start; move them apart, or write coincident_start: true");
  EXPECT_EQ(refusal(near, {{"coincident_start", "true"}}), "accepted");
  EXPECT_EQ(refusal(near, {{"vehicles[1].start.position_m[1]", "3"}}), "accepted") << "they touch";
  EXPECT_THAT(refusal(with("obstacles: [{sphere: {position_m: [9, 8, 9], radius_m: 2}}]")),
              HasSubstr("f.yaml:8:53: vehicles[1].start.position_m: [9, 9, 9] lies inside obstacles[0]"));
  EXPECT_THAT(refusal(with("obstacles: [{polygon: {vertices_m: [[8, 8], [10, 8], [10, 10], [8, 10]]}}]")),
              HasSubstr("lies inside obstacles[0]"));
}

TEST(RefusalTest, WhoCollidesIsDetected) {
  EXPECT_THAT(
      refusal(with("exam: {crit_dist_m: 1}")),
      HasSubstr("exam: crit_dist_m is 1 and safety_distance_m 3: who is not detected does not collide"));
}

TEST(RefusalTest, ObstaclesMustBeSolid) {
  EXPECT_THAT(refusal(with("obstacles: [{polygon: {vertices_m: [[90, 0], [90, 10], [80, 0]]}}]")),
              testing::Not(HasSubstr("clockwise")));
  EXPECT_THAT(refusal(with("obstacles: [{polygon: {vertices_m: [[90, 0], [80, 0], [90, 10]]}}]")),
              HasSubstr("obstacles[0].polygon: the vertices_m run clockwise; write them counter-clockwise"));
  EXPECT_THAT(refusal(with("obstacles: [{polygon: {vertices_m: [[90, 0], [80, 0]]}}]")),
              HasSubstr("needs 3 to 10000 vertices_m, got 2"));
  EXPECT_THAT(refusal(with("obstacles: [{polygon: {vertices_m: [[0, 90], [0, 80], [0, 70]]}}]")),
              HasSubstr("lie on one line"));
  EXPECT_THAT(
      refusal(with("obstacles: [{polygon: {vertices_m: [[60, 0], [43.8, 11.8], [69.1, -19], [69.1, 19], "
                   "[43.8, -11.8]]}}]")),
      HasSubstr("cross or touch; a polygon goes round one area, once"));
  EXPECT_THAT(
      refusal(with("obstacles: [{polygon: {vertices_m: [[60, 0], [70, 0], [70, 10], [70, 5], [60, 5]]}}]")),
      HasSubstr("from vertices_m[1] and [3] cross or touch"));
  EXPECT_THAT(refusal(with("obstacles: [{polygon: {vertices_m: [[9, 0], [9, 0], [0, 7]]}}]")),
              HasSubstr("vertices_m[0] and [1] are the same place"));
  EXPECT_THAT(refusal(with("obstacles: [{segment: {from_m: [9, 0, 0], to_m: [9, 0, 0]}}]")),
              HasSubstr("a segment needs a length"));
  EXPECT_THAT(refusal(with("obstacles: [{sphere: {}, segment: {}}]")),
              HasSubstr("expected a mapping with one key of sphere, segment, polygon"));
}

TEST(RefusalTest, AnOverrideIsNamedAndNotTheFile) {
  EXPECT_EQ(refusal(with(""), {{"vehicles[0].radius", "2"}}),
            "--set vehicles[0].radius: unknown key; did you mean radius_m?");
  EXPECT_EQ(refusal(with(""), {{"vehicles[0].radius_m", "wide"}}),
            "--set vehicles[0].radius_m: expected a number in [0, 1000], got wide");
  EXPECT_EQ(refusal(with(""), {{"vehicles[*].radius_m", "-1"}}),
            "--set vehicles[*].radius_m: vehicles[0].radius_m: expected a number in [0, 1000], got -1");
  EXPECT_EQ(refusal(with(""), {{"exams.crit_dist_m", "1"}}),
            "--set exams.crit_dist_m: exams: unknown key; did you mean exam?");
  EXPECT_EQ(refusal(with(""), {{"vehicles[2].radius_m", "1"}}),
            "--set vehicles[2].radius_m: [2] does not exist; the last one is [1]");
  EXPECT_EQ(refusal(with(""), {{"name[0]", "1"}}), "--set name[0]: name is not a list");
  EXPECT_EQ(refusal(with(""), {{"name.first", "1"}}),
            "--set name.first: first cannot be set: what holds it is a value");
  EXPECT_EQ(refusal(with(""), {{"obstacles[*].sphere.radius_m", "1"}}),
            "--set obstacles[*].sphere.radius_m: obstacles is empty");
  EXPECT_THAT(refusal(with(""), {{"seed", "[1, "}}), testing::StartsWith("--set seed: "));
  for (const std::string path : {"", ".", "a..b", "a.", "[0]", "a[", "a[x]", "a[-1]", "a[0]b", "a[]"}) {
    EXPECT_THAT(refusal(with(""), {{path, "1"}}), HasSubstr("write a path such as")) << path;
  }
}

TEST(RefusalTest, BrokenYamlNamesItsLine) {
  EXPECT_THAT(refusal("fairway: 1\nname: [a\nb: c}\n"), HasSubstr("f.yaml:3:"));
  EXPECT_THAT(refusal("fairway: 1\n\tname: a\n"), HasSubstr("f.yaml:2:"));
  EXPECT_THAT(refusal(with("---\nname: b")), HasSubstr("more than one document"));
  EXPECT_THAT(refusal("a: *b\n"), HasSubstr("f.yaml:1:4: "));
  EXPECT_THAT(refusal("a: &b [*b]\n"), HasSubstr("an alias inside its own anchor"));
  EXPECT_THAT(refusal("? [a]\n: b\n"), HasSubstr("a key must be a word"));
  EXPECT_THAT(refusal("a: !!binary b\n"), HasSubstr("means nothing here"));
}

TEST(RefusalTest, BracketsTooDeepAreToldWithTheirPlaceThoughTheyAreClosed) {
  const std::string deep = std::string(5000, '[') + std::string(5000, ']');
  EXPECT_EQ(
      refusal("fairway: 1\nname: " + deep),
      "f.yaml:2:1031: brackets nested deeper than 64 levels, or not closed");  // the 1025th, from column 7
  EXPECT_THAT(refusal("fairway: 1\nname: " + deep.substr(4900, 200)),
              HasSubstr("f.yaml:2:70: nested deeper than 64 levels"));
}

TEST(RefusalTest, TextThatIsNotUtf8IsToldWithItsPlace) {
  EXPECT_EQ(refusal(with("summary: caf\xE9")),
            "f.yaml:9:13: holds a byte that is not UTF-8; save the text in that encoding");
  EXPECT_EQ(refusal(with("summary: caf\xC3\xA9")), "accepted");
  EXPECT_EQ(refusal(with(""), {{"summary", "caf\xE9"}}),
            "--set summary: holds a byte that is not UTF-8; save the text in that encoding");
  EXPECT_EQ(refusal_by([] { parse_scenario(with(""), "caf\xE9.yaml"); }),
            "caf\xE9.yaml: has a name that is not UTF-8; expected another name");
}

TEST(RefusalTest, AColumnCountsCharactersAndNotBytes) {
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  // two characters of one, two, three and four bytes each
  for (const std::string word :
       {"ab", "\xC3\xA9\xC3\xA9", "\xE6\x95\xB0\xE6\x8D\xAE", "\xF0\x9F\x90\x9F\xF0\x9F\x90\xA0"}) {
    const std::string twice = with("x: {'" + word + "': 1, '" + word + "': 2}");
    EXPECT_THAT(refusal(twice), StartsWith("f.yaml:9:14: ")) << word;
    EXPECT_THAT(refusal(byte_order_mark + twice), StartsWith("f.yaml:9:14: ")) << word;
    EXPECT_THAT(refusal(with("x: ['" + word + "', *nobody]")), StartsWith("f.yaml:9:11: ")) << word;
    EXPECT_THAT(refusal(byte_order_mark + "? ['" + word + "', [b]]\n"), StartsWith("f.yaml:1:3: ")) << word;
    EXPECT_THAT(refusal(with("summary: " + word + "\xE9")), StartsWith("f.yaml:9:12: ")) << word;
    EXPECT_THAT(refusal("# " + word + "\n" + word + std::string(2000, '[')), StartsWith("f.yaml:2:1027: "))
        << word;
  }
}

/// The processor time that a document takes to be refused [s]: it does not depend on who else is busy.
double refusal_time(const std::string& yaml) {
  const std::clock_t start = std::clock();
  EXPECT_NE(refusal(yaml), "accepted");
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::string repeated(const std::string& text, std::size_t bytes) {
  std::string all;
  while (all.size() < bytes) all += text;
  return all;
}

TEST(RefusalTest, HugeDeepOrMalignInputIsRefusedInTime) {
  std::string bomb = "a0: &a0 [1, 2, 3, 4, 5, 6, 7, 8, 9]\n";
  std::string runs = with("missions:");
  for (int i = 1; i < 60; ++i) {
    bomb += fmt::format("a{0}: &a{0} [*a{1}, *a{1}]\n", i, i - 1);
    runs += fmt::format("  m{0}: [{{run: m{1}}}, {{run: m{1}}}]\n", i - 1, i);
  }
  runs += "  m59: []\n";
  EXPECT_EQ(refusal(runs), "accepted") << "nobody runs it";
  std::string chain = with("missions:", "mission: [{run: m0}]");
  for (int i = 0; i < 100'000; ++i) chain += fmt::format("  m{}: [{{run: m{}}}]\n", i, i + 1);
  chain += "  m100000: []\n";

  constexpr std::size_t megabyte = 1 << 20;
  EXPECT_LT(refusal_time(bomb), 20.0);
  runs.replace(runs.find("radius_m: 1"), 11, "mission: [{run: m0}]");
  EXPECT_LT(refusal_time(runs), 20.0);
  EXPECT_LT(refusal_time(chain), 20.0);
  for (const std::string text :
       {"[", "{",     "- ",   "? ",   "a: ",     "[a: ",  "{a: [", "&a ", "!a ", "\"",
        "'", "|",     ">",    "\n",   " ",       "\t",    "%",     "#",   "*a",  "]",
        "}", "---\n", "\xff", "\x01", "- - -\n", "a:\n ", "? a\n", ",",   "[,",  "\\"}) {
    EXPECT_LT(refusal_time(repeated(text, megabyte / 4)), 20.0) << text;
  }
  EXPECT_THAT(refusal(repeated("# comment\n", 161 * megabyte)), HasSubstr("longer than 167772160 bytes"));
  EXPECT_THAT(refusal(std::string("name: a\0b", 9)), HasSubstr("holds a zero byte"));
}

}  // namespace
}  // namespace fairway
