// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/core/names.hpp"
#include "fairway/experiment/campaign_file.hpp"

/// What an exam is asked on, as it is written in campaigns/exam.
namespace fairway {

/// Seeds in a row.
struct SeedRange {
  std::uint64_t first{1};
  std::uint32_t count{1};

  std::uint64_t last() const { return first + (count - 1); }
  bool meets(const SeedRange& other) const { return first <= other.last() && other.first <= last(); }
};

/// A scenario file of a family.
struct ExamGround {
  std::string name;  ///< the file's, without its ending
  std::string file;
  std::string text;
};

/// Scenarios of one kind, of which each seed is one: the n-th seed is a run of the ground n modulo their
/// number, with what that file draws.
struct ExamFamily {
  std::string file;
  std::int32_t version{};
  std::string name;
  std::string summary;
  std::string source;
  bool needs_movers{};     ///< of a method, that it sees what moves
  bool needs_obstacles{};  ///< that it sees what stands
  bool needs_space{};      ///< that it goes up and down
  bool needs_way{};        ///< that it never has to stop, since not everybody there can
  std::vector<CampaignScenarioFile> scenarios;
  std::vector<ExamGround> grounds;
  std::vector<std::string>
      train_on;                ///< grounds that parameters may be searched on; the others are new kinds
  bool keep_named_avoiders{};  ///< vehicles that name an avoider of their own keep it, as one that is broken
  Overrides set;
  SeedRange train;
  SeedRange validation;
  SeedRange test;
};

/// To whom a condition makes a difference.
enum class ConditionOf {
  all,
  told,  ///< where there is somebody to tell anything
  seen,  ///< where something is to be seen that is not on the chart
};

/// What everybody knows and feels, laid over every scenario alike.
struct ExamCondition {
  std::string name;
  std::string meaning;
  ConditionOf of{ConditionOf::all};
  Overrides set;
};

/// Cells that nobody waits for unless they are asked for by name.
struct ExamOmission {
  std::string method;
  std::vector<std::string> families;
  std::string why;
};

struct ExamFile {
  std::string file;
  std::int32_t version{};
  std::string name;
  std::string summary;
  CampaignAlgorithm baseline;
  std::vector<CampaignAlgorithm> methods;
  std::vector<ExamCondition> conditions;  ///< the first is the one that the others are held against
  std::vector<ExamOmission> omissions;
  std::vector<std::string> family_files;
  std::vector<ExamFamily> families;
};

/// Reads an exam with its families and their scenarios. Throws InputError with file, line, column, path and
/// the nearest known name; also where two of a family's ranges of seeds share a seed.
ExamFile load_exam(const std::string& file);

/// The same of one family, from text.
ExamFamily parse_family(const std::string& text, const std::string& file);

/// A whole text file. Throws InputError where it cannot be read.
std::string text_of_file(const std::string& file);

/// Those of `known` that are named, in their order there; all if none is. Throws InputError, which begins
/// with `flag`, for one that is not known, with the nearest name.
template <class T>
std::vector<T> chosen_by_name(const std::vector<T>& known, const std::vector<std::string>& names,
                              const std::string& flag) {
  if (names.empty()) return known;
  std::vector<std::string_view> all;
  for (const T& one : known) all.push_back(one.name);
  for (const std::string& name : names)
    if (std::ranges::find(all, name) == all.end())
      throw InputError(flag + " " + name + ": unknown" + suggestion(name, all));
  std::vector<T> chosen;
  for (const T& one : known)
    if (std::ranges::find(names, one.name) != names.end()) chosen.push_back(one);
  return chosen;
}

}  // namespace fairway
