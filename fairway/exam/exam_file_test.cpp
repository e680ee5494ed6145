// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/exam/entrance.hpp"
#include "fairway/exam/exam_plan.hpp"
#include "fairway/exam/tuned.hpp"
#include "fairway/experiment/ground_digest.hpp"
#include "fairway/planning/builtin.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {
namespace {

const std::string shipped = FAIRWAY_SOURCE_DIR "/campaigns/exam/exam.yaml";

constexpr const char* pair = R"(fairway: 1
name: pair
duration_s: 10
vehicles:
  - {model: kinematic, avoider: orca3d, start: {position_m: [0, 0, 5]}, mission: [{transit: {position_m: [9, {uniform: [0, 1]}, 5]}}]}
  - {model: kinematic, avoider: orca3d, start: {position_m: [9, 9, 5]}, mission: [{transit: {position_m: [0, 9, 5]}}]}
)";

std::string family_text(const std::string& needs = "movers",
                        const std::string& test = "{first: 201, count: 100}") {
  return "fairway_family: 1\nname: meeting\nsummary: s\nsource: s\nneeds: [" + needs +
         "]\ngrounds: [a.yaml, b.yaml]\ntrain_on: [a]\nseeds:\n  train: {first: 1, count: 100}\n"
         "  validation: {first: 101, count: 100}\n  test: " +
         test + "\n";
}

/// An exam of one family of two grounds, in a folder of its own.
struct SmallExam {
  SmallExam() {
    write("a.yaml", pair);
    write("b.yaml", pair);
    write("meeting.yaml", family_text());
    write("exam.yaml",
          "fairway_exam: 1\nname: small\nbaseline: direct\nmethods: [orca3d, vo, apf+inflate]\nconditions:\n"
          "  - {name: known, meaning: m}\n  - {name: told, meaning: m, of: told, set: {exchange: none}}\n"
          "families: [meeting.yaml]\n");
  }
  void write(const std::string& name, const std::string& text) { std::ofstream{folder.file(name)} << text; }
  ExamFile load() const { return load_exam(folder.file("exam.yaml")); }

  TemporaryFolder folder;
};

Catalog methods() {
  Catalog catalog = builtin_avoiders();
  add_planners(catalog);
  return catalog;
}

ExamPlan planned(const ExamFile& exam, const std::vector<std::string>& names, std::size_t seeds,
                 bool by_name = false) {
  ExamQuestion question{.families = exam.families,
                        .conditions = exam.conditions,
                        .candidates = {},
                        .seeds = seeds,
                        .by_name = by_name};
  for (const std::string& name : names)
    question.candidates.push_back({.method = {.label = name, .avoider = name}, .families = {}});
  return plan_exam(exam, question, methods(), {}, 1, {});
}

TEST(ExamFile, NoFamilyThatIsShippedSharesASeedBetweenTrainValidationAndTest) {
  const ExamFile exam = load_exam(shipped);
  EXPECT_GE(exam.families.size(), 15U);
  for (const ExamFamily& family : exam.families) {
    EXPECT_FALSE(family.train.meets(family.test)) << family.name;
    EXPECT_FALSE(family.train.meets(family.validation)) << family.name;
    EXPECT_FALSE(family.validation.meets(family.test)) << family.name;
    EXPECT_FALSE(family.source.empty()) << family.name;
  }
}

TEST(ExamFile, EveryShippedGroundDrawsAnotherCaseForAnotherSeedAndStandsUnderEveryCondition) {
  const ExamFile exam = load_exam(shipped);
  for (const ExamFamily& family : exam.families) {
    for (const ExamGround& ground : family.grounds) {
      std::set<std::string> drawn;
      for (std::uint64_t seed = family.test.first; seed < family.test.first + 3; ++seed)
        for (const ExamCondition& condition : exam.conditions) {
          Overrides set = family.set;
          set.insert(set.end(), condition.set.begin(), condition.set.end());
          Scenario scenario = parse_scenario(ground.text, ground.file, set, seed);
          scenario.seed = 0;
          drawn.insert(to_yaml(scenario));
        }
      EXPECT_EQ(drawn.size(), 3 * exam.conditions.size()) << ground.name;
    }
  }
}

TEST(ExamFile, AFamilyWhoseTestSeedsAreAmongItsTrainingOnesIsRefused) {
  SmallExam exam;
  exam.write("meeting.yaml", family_text("movers", "{first: 100, count: 5}"));
  EXPECT_NE(refusal_by([&] {
              exam.load();
            }).find("meeting.yaml: seeds.test: has the seed 100 as train has; what is judged by must be new"),
            std::string::npos);
}

TEST(ExamFile, ARangeThatPassesTheLargestSeedIsRefused) {
  SmallExam exam;
  exam.write("meeting.yaml", family_text("movers", "{first: 18446744073709551615, count: 5}"));
  EXPECT_NE(refusal_by([&] { exam.load(); }).find("seeds.test: passes the largest seed there is"),
            std::string::npos);
}

TEST(ExamFile, MistakesAreToldWithTheNearestName) {
  SmallExam exam;
  exam.write("meeting.yaml", family_text("mover"));
  EXPECT_NE(refusal_by([&] { exam.load(); }).find("is mover; did you mean movers?"), std::string::npos);
  exam.write("meeting.yaml", family_text() + "keep_named_avoider: true\n");
  EXPECT_NE(refusal_by([&] { exam.load(); }).find("did you mean keep_named_avoiders?"), std::string::npos);
  exam.write("meeting.yaml", "name: x\n");
  EXPECT_NE(refusal_by([&] { exam.load(); }).find("not a family of scenarios"), std::string::npos);
}

TEST(ExamFile, AMethodThatIsUnknownIsToldWhereItIsWritten) {
  SmallExam exam;
  exam.write("exam.yaml",
             "fairway_exam: 1\nname: small\nbaseline: direkt\nmethods:\n  - orca3d\n  - orcad\nconditions:\n"
             "  - name: known\n    meaning: |\n      of several\n      lines\nfamilies: [meeting.yaml]\n");
  const ExamFile read = exam.load();
  const std::string file = exam.folder.file("exam.yaml");
  EXPECT_EQ(refusal_by([&] { candidate_of("orcad", read, methods(), "methods:"); }),
            file + ":6:5: methods[1]: unknown algorithm \"orcad\"; did you mean orca3d?");
  EXPECT_EQ(refusal_by([&] { expect_known(read.baseline, methods()); }),
            file + ":3:11: baseline: unknown algorithm \"direkt\"; did you mean direct?");
}

TEST(ExamFile, WhatASearchSawIsAskedOfTheFileBesideIt) {
  SmallExam exam;
  const ExamFile read = exam.load();
  const auto told = [&] { return is_search_told("--flag", exam.folder.file("best.yaml"), read.families); };
  exam.write("best.yaml", "algorithm: orca3d\n");
  EXPECT_TRUE(told()) << "nobody says that it was searched for";
  exam.write("best.yaml", "# Tuned by fairway 0.2.0\nalgorithm: orca3d\n");
  EXPECT_FALSE(told());
  for (const char* nothing : {"no JSON", "{}", "[]"}) {
    exam.write("tuning.json", nothing);
    EXPECT_FALSE(told()) << nothing;
  }
  exam.write("tuning.json",
             R"({"seen": {"train": {"first_seed": 1, "seed_count": 200, "scenarios": ["a"]}}})");
  EXPECT_TRUE(told());
  exam.write("tuning.json",
             R"({"seen": {"train": {"first_seed": 1, "seed_count": 201, "scenarios": ["a"]}}})");
  EXPECT_EQ(refusal_by(told), "--flag " + exam.folder.file("best.yaml") +
                                  ": its train has the seed 201 of a, which is a test seed of meeting");
}

TEST(ExamFile, ACopyOfAGroundIsKnownUnderAnotherName) {
  SmallExam exam;
  const ExamFile read = exam.load();
  exam.write("best.yaml", "# Tuned by fairway 0.2.0\nalgorithm: orca3d\n");
  const auto told = [&](const std::string& ground) {
    exam.write("tuning.json",
               R"({"seen": {"train": {"first_seed": 201, "seed_count": 5, "scenarios": ["copy"],)"
               R"( "digests": [")" +
                   ground_digest(ground, "copy.yaml") + R"("]}}})");
    return refusal_by([&] { is_search_told("--flag", exam.folder.file("best.yaml"), read.families); });
  };
  std::string copy = "# another comment\n" + std::string{pair};
  copy.replace(copy.find("name: pair"), 10, "name: copy");
  copy.replace(copy.find("avoider: orca3d"), 15, "avoider: apf");
  EXPECT_EQ(told(copy),
            "--flag " + exam.folder.file("best.yaml") +
                ": its train has the seed 201 of copy, which is a, and that is a test seed of meeting");
  copy.replace(copy.find("duration_s: 10"), 14, "duration_s: 11");
  EXPECT_EQ(told(copy), "accepted") << "another ground";
}

TEST(ExamFile, TunedParametersAreForTheFamilyOfAFolderAtMostAsHighAsTheOneThatIsGiven) {
  SmallExam exam;
  const ExamFile read = exam.load();
  const auto families_of = [&](const std::string& path) {
    return tuned_candidates(exam.folder.file(path), read, {}, methods()).front().families;
  };
  std::filesystem::create_directories(exam.folder.file("meeting/one/meeting/two"));
  exam.write("meeting/one/best.yaml", "algorithm: orca3d\n");
  EXPECT_EQ(families_of("meeting/one"), std::vector<std::string>{}) << "what lies above says nothing";
  EXPECT_EQ(families_of("meeting/one/best.yaml"), std::vector<std::string>{});
  EXPECT_EQ(families_of("meeting"), std::vector<std::string>{"meeting"});
  exam.write("meeting/one/meeting/two/best.yaml", "algorithm: apf\n");
  EXPECT_EQ(families_of("meeting/one/meeting/two"), std::vector<std::string>{});
  EXPECT_EQ(families_of("meeting/one/meeting"), std::vector<std::string>{"meeting"});
  exam.write("meeting/one/meeting/two/best.yaml", "algorithm: orca3d\n");
  EXPECT_EQ(refusal_by([&] { families_of("meeting/one"); }),
            "--tuned " + exam.folder.file("meeting/one/meeting/two/best.yaml") +
                ": a second one of orca3d for meeting")
      << "the first is for all families";
}

TEST(ExamFile, OfAFolderOfTunedParametersThoseOfTheNamedMethodsAreTaken) {
  SmallExam small;
  const ExamFile exam = small.load();
  for (const char* method : {"apf", "orca3d", "avoa"}) {
    std::filesystem::create_directories(small.folder.file(std::string{"tuned/"} + method));
    small.write(std::string{"tuned/"} + method + "/best.yaml", std::string{"algorithm: "} + method + "\n");
  }
  const auto taken = [&](const std::string& path, const std::vector<std::string>& names) {
    ExamQuestion question{.families = exam.families, .by_name = !names.empty()};
    for (const std::string& name : names)
      question.candidates.push_back(candidate_of(name, exam, methods(), "--methods"));
    std::vector<std::string> labels;
    for (const Candidate& each : tuned_candidates(small.folder.file(path), exam, question, methods()))
      labels.push_back(each.method.label);
    return labels;
  };
  EXPECT_EQ(taken("tuned", {}).size(), 3U);
  EXPECT_EQ(taken("tuned", {"orca3d", "vo"}), std::vector<std::string>{"orca3d"});
  EXPECT_EQ(taken("tuned/apf/best.yaml", {"orca3d"}), std::vector<std::string>{"apf"})
      << "it was named itself";
  EXPECT_EQ(
      refusal_by([&] { taken("tuned", {"vo"}); }),
      "--tuned " + small.folder.file("tuned") +
          ": has parameters of none of the methods that --methods names; it has those of apf, avoa, orca3d");
}

TEST(ExamFile, TwoMethodsOfOneLabelAreRefused) {
  SmallExam exam;
  exam.write("exam.yaml",
             "fairway_exam: 1\nname: small\nbaseline: direct\nmethods: [vo, {algorithm: apf, label: vo}]\n"
             "conditions: [{name: known, meaning: m}]\nfamilies: [meeting.yaml]\n");
  EXPECT_EQ(refusal_by([&] { exam.load(); }),
            exam.folder.file("exam.yaml") + ": methods: a second one named vo; give it a label of its own");
}

TEST(ExamFile, NamesAreChosenInTheOrderOfTheExam) {
  const std::vector<ExamCondition> known{{.name = "a"}, {.name = "sonar"}, {.name = "c"}};
  const auto chosen = chosen_by_name(known, {"c", "a"}, "--conditions");
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen[0].name, "a");
  EXPECT_EQ(chosen_by_name(known, {}, "--conditions").size(), 3U);
  EXPECT_EQ(refusal_by([&] { chosen_by_name(known, {"sonor"}, "--conditions"); }),
            "--conditions sonor: unknown; did you mean sonar?");
}

TEST(Entrance, FollowsFromWhatTheLayersDeclare) {
  ExamFamily family;
  family.needs_space = true;
  EXPECT_EQ(why_not(methods(), "orca3d+inflate", family), "");
  EXPECT_NE(why_not(methods(), "orca2d", family), "");
  EXPECT_NE(why_not(methods(), "orca3d+safety_filter", family), "");
  family = {};
  family.needs_obstacles = true;
  EXPECT_NE(why_not(methods(), "direct+stop_and_wait", family), "");
  EXPECT_EQ(why_not(methods(), "direct+safety_filter", family), "");
  family = {};
  family.needs_movers = true;
  EXPECT_EQ(why_not(methods(), "rrt_star", family), "ignores whatever moves, and something does");
  family = {};
  family.needs_way = true;
  EXPECT_EQ(why_not(methods(), "hrvo", family), "");
  EXPECT_EQ(why_not(methods(), "orca3d+stop_and_wait", family),
            "has to stop now and then, and not everybody there can");
}

TEST(Entrance, WhoAgreesByWordsMeetsItsLikeAndNothingElse) {
  SmallExam exam;
  const auto why = [&](const char* method, const std::string& ground) {
    exam.write("b.yaml", ground);
    return why_not(methods(), method, exam.load().families[0]);
  };
  const std::string silent = "vehicles:\n  - {cooperative: false, ";
  std::string with_silent = pair;
  with_silent.replace(with_silent.find("vehicles:\n  - {"), 15, silent);
  const std::string with_drifter =
      "obstacles: [{sphere: {position_m: [5, 5, 5], radius_m: 1, velocity_mps: [0.1, 0, 0]}}]\n";
  std::string many = pair;
  for (int i = 0; i < 31; ++i)
    many += "  - {model: kinematic, avoider: orca3d, start: {position_m: [0, " + std::to_string(20 + 5 * i) +
            ", 5]}, mission: [{transit: {position_m: [9, 9, 5]}}]}\n";
  for (const char* method : {"pledge", "delay_check"}) {
    EXPECT_EQ(why(method, pair), "") << method;
    EXPECT_EQ(why(method, with_silent), "avoids whoever speaks as it does, and not everything there speaks");
    EXPECT_EQ(why(method, pair + with_drifter), why(method, with_silent));
  }
  EXPECT_EQ(why("pledge", many), "is for groups of 2 to 32, and b has 33");
  EXPECT_EQ(why("delay_check", many), "");
  const std::string rock = "obstacles: [{sphere: {position_m: [5, 5, 5], radius_m: 1}}]\n";
  EXPECT_EQ(why("pledge", pair + rock), "");
  const std::string lone = std::string{pair}.substr(0, std::string{pair}.rfind("  - {"));
  EXPECT_EQ(why("pledge", lone), "is for groups of 2 to 32, and b has 1");
  EXPECT_EQ(why("orca3d", with_silent), "");
}

TEST(ExamPlan, EverySeedIsARunAndTheGroundsTakeTurns) {
  const SmallExam exam;
  const ExamPlan plan = planned(exam.load(), {"orca3d", "vo"}, 5);
  EXPECT_EQ(plan.campaign.specs.size(), 5U * 3 * 2);  // the baseline beside the two, under two conditions
  for (const RunSpec& spec : plan.campaign.specs)
    EXPECT_EQ(*find_label(spec.labels, "case"), spec.seed % 2 == 1 ? "a" : "b") << spec.seed;
  EXPECT_NE(plan.campaign.specs.front().command.find("vehicles[*].avoider=direct"), std::string::npos);
}

TEST(ExamPlan, MoreSeedsAreRunsOfTheSameKeysAndSomeMore) {
  const SmallExam exam;
  std::set<std::string> few, many;
  for (const RunSpec& spec : planned(exam.load(), {"orca3d"}, 3).campaign.specs) few.insert(spec.key);
  for (const RunSpec& spec : planned(exam.load(), {"orca3d"}, 8).campaign.specs) many.insert(spec.key);
  EXPECT_EQ(few.size(), 12U);
  EXPECT_TRUE(std::ranges::includes(many, few));
}

TEST(ExamPlan, WhoMayEnterNothingIsToldOrRefusedWhereItWasNamed) {
  SmallExam exam;
  const ExamPlan plan = planned(exam.load(), {"rrt_star"}, 2);
  ASSERT_EQ(plan.absences.size(), 1U);
  EXPECT_EQ(plan.absences[0].method, "rrt_star");
  EXPECT_EQ(
      refusal_by([&] { planned(exam.load(), {"rrt_star"}, 2, true); }),
      "--methods rrt_star may enter none of the families; meeting: rrt_star ignores whatever moves, and "
      "something does");
}

TEST(ExamPlan, TunedParametersThatMayEnterNothingAreToldWhoeverWasNamed) {
  const SmallExam small;
  const ExamFile exam = small.load();
  ExamQuestion question{
      .families = exam.families, .conditions = exam.conditions, .seeds = 2, .by_name = true};
  question.candidates = {
      {.method = {.label = "orca3d", .avoider = "orca3d"}, .families = {}},
      {.method = {.label = "rrt_star", .avoider = "rrt_star"}, .tuned = true, .families = {}},
      {.method = {.label = "apf", .avoider = "apf"}, .tuned = true, .families = {"elsewhere"}}};
  const ExamPlan plan = plan_exam(exam, question, methods(), {}, 1, {});
  ASSERT_EQ(plan.absences.size(), 2U);
  EXPECT_EQ(plan.absences[0].method + " " + plan.absences[0].why, "apf was tuned for elsewhere alone");
  EXPECT_EQ(plan.absences[1].method + " " + plan.absences[1].why,
            "rrt_star ignores whatever moves, and something does");
}

TEST(ExamPlan, AConditionThatChangesNothingIsLeftOutAndTold) {
  SmallExam exam;
  const std::string lone = std::string{pair}.substr(0, std::string{pair}.rfind("  - {"));
  exam.write("a.yaml", lone);
  exam.write("b.yaml", lone);
  const ExamPlan plan = planned(exam.load(), {"orca3d"}, 2);
  EXPECT_EQ(plan.campaign.specs.size(), 2U * 2);
  ASSERT_EQ(plan.absences.size(), 1U);
  EXPECT_EQ(plan.absences[0].condition, "told");
}

TEST(ExamPlan, AGroupEntersWhereItsWordsAreHeard) {
  const SmallExam exam;  // under its condition "told" the exchange is none
  const ExamPlan plan = planned(exam.load(), {"pledge"}, 2);
  EXPECT_EQ(plan.campaign.specs.size(),
            2U * 3);  // the baseline under two conditions, and the group under one
  ASSERT_EQ(plan.absences.size(), 1U);
  EXPECT_EQ(plan.absences[0].condition, "told");
  EXPECT_EQ(plan.absences[0].why, "goes by the words of others, and nobody hears any");
}

TEST(ExamPlan, MoreSeedsThanAFamilyHasAreRefused) {
  const SmallExam exam;
  EXPECT_NE(refusal_by([&] {
              planned(exam.load(), {"orca3d"}, 101);
            }).find("seeds.test: has 100 seeds, and --seeds asks for 101"),
            std::string::npos);
}

TEST(ExamPlan, TheDigestOfAFamilyChangesWithItsScenariosAndConditionsAlone) {
  SmallExam small;
  const ExamFile exam = small.load();
  const std::string before = digest_of(exam.families[0], exam.conditions);
  small.write("a.yaml", "# a comment\n" + std::string{pair});
  EXPECT_EQ(digest_of(small.load().families[0], exam.conditions), before);
  EXPECT_NE(digest_of(exam.families[0], {}), before);
  std::string longer = pair;
  longer.replace(longer.find("10"), 2, "11");
  small.write("a.yaml", longer);
  EXPECT_NE(digest_of(small.load().families[0], exam.conditions), before);
}

}  // namespace
}  // namespace fairway
