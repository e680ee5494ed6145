// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/labels.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/exam/tuned.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

/// An exam of a baseline and two methods, one of which has a label of its own, and files of avoiders.
struct Asked {
  Asked() {
    exam.baseline = {.label = "alone", .avoider = "direct"};
    exam.methods = {{.label = "orca3d", .avoider = "orca3d"}, {.label = "field", .avoider = "apf"}};
  }

  /// What these names and files come to; `written` is in each file that is not there.
  ExamQuestion of(const std::vector<std::string>& names, const std::string& written = "algorithm: hrvo\n") {
    ExamQuestion question{.by_name = true};
    for (const std::string& name : names) {
      const std::string file = name.ends_with(".yaml") ? folder.file(name) : name;
      if (file != name) {
        std::filesystem::create_directories(std::filesystem::path(file).parent_path());
        std::ofstream{file} << written;
      }
      question.candidates.push_back(candidate_of(file, exam, methods, "--methods"));
    }
    return question;
  }

  std::string refusal(const std::vector<std::string>& names) {
    return refusal_by([&] { refuse_taken_labels(of(names), exam, methods); });
  }

  std::string of_file(const std::string& file, const std::string& label, const std::string& whose) const {
    return "--methods " + folder.file(file) + ": its label, " + label + ", is that of " + whose +
           "; expected a file of another name, so rename it";
  }

  TemporaryFolder folder;
  Catalog methods = builtin_avoiders();
  ExamFile exam;
};

TEST(Labels, AFileThatIsCalledAsSomebodyElseIsRefused) {
  Asked asked;
  EXPECT_EQ(asked.refusal({"orca3d", "mine.yaml"}), "accepted");
  EXPECT_EQ(asked.refusal({"orca3d.yaml"}), asked.of_file("orca3d.yaml", "orca3d", "a method of the exam"));
  EXPECT_EQ(asked.refusal({"field.yaml"}), asked.of_file("field.yaml", "field", "a method of the exam"));
  EXPECT_EQ(asked.refusal({"alone.yaml"}), asked.of_file("alone.yaml", "alone", "the exam's baseline"));
  EXPECT_EQ(asked.refusal({"vo.yaml"}), asked.of_file("vo.yaml", "vo", "a method that fairway has"));
  EXPECT_EQ(asked.refusal({"vo+inflate.yaml"}),
            asked.of_file("vo+inflate.yaml", "vo+inflate", "a method that fairway has"));
  EXPECT_EQ(asked.refusal({"mine.yaml", "q/mine.yaml"}),
            asked.of_file("q/mine.yaml", "mine", asked.folder.file("mine.yaml")));
}

TEST(Labels, WhoIsStoredUnderALabelIsKnownAgainByItsAvoiderAndNobodyElseTakesIt) {
  Asked asked;
  ExamReference reference{.epoch = results_epoch, .runs = {{.method = "mine"}, {.method = "orca3d"}}};
  const auto refusal = [&](const ExamQuestion& question) {
    return refusal_by([&] { refuse_stored_labels(question, reference, "stored.csv"); });
  };
  EXPECT_EQ(refusal(asked.of({"orca3d", "other.yaml"})), "accepted");
  EXPECT_EQ(refusal(asked.of({"mine.yaml"})),
            asked.of_file("mine.yaml", "mine", "a method that is not known to be this one in stored.csv"));
  reference.avoiders = avoiders_of(asked.of({"orca3d", "mine.yaml"}));
  EXPECT_EQ(reference.avoiders.size(), 1U);
  EXPECT_EQ(refusal(asked.of({"mine.yaml"}, "# a comment\nalgorithm: hrvo\n")), "accepted");
  EXPECT_EQ(refusal(asked.of({"mine.yaml"}, "{algorithm: orca3d, crit_dist_m: 9}\n")),
            asked.of_file("mine.yaml", "mine", "another avoider in stored.csv"));
  const ExamReference read = parse_reference(reference_text(reference), "stored.csv");
  EXPECT_EQ(read.avoiders, reference.avoiders);
}

}  // namespace
}  // namespace fairway
