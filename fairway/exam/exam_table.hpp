// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/exam/exam_run.hpp"
#include "fairway/experiment/paired_tests.hpp"
#include "fairway/experiment/statistics.hpp"

namespace fairway {

/// The results of an exam: what the runs come to, who is ahead of whom, and how sure that is.
inline constexpr double exam_significance = 0.05;

/// One number of one cell.
struct ExamRow {
  std::string family;
  std::string condition;
  std::string method;
  bool tuned{};
  std::string quantity;
  double mean{};
  double low{};   ///< of the 95 % interval; NaN where there is none
  double high{};  ///< likewise
  std::size_t runs{};
};

/// Runs of one method with the same parameters in one family and condition, by seed.
struct ExamCell {
  std::string family;
  std::string condition;
  std::string method;
  bool tuned{};
  std::vector<const ExamRun*> runs;      ///< ascending seeds
  std::vector<const ExamRun*> baseline;  ///< of the same seed each; null where there is none
  bool is_baseline{};

  /// "orca3d", or "orca3d, tuned".
  std::string name() const;
  std::size_t safe_count() const;
  double arrived() const;  ///< mean share
  /// A quantity over the baseline's of the same seed, in runs in which all arrived in both; NaN in others.
  std::vector<double> ratios(double ExamOutcome::*member) const;
  /// Mean of the finite ones of time; NaN of none.
  double time_ratio() const;
};

enum class Place {
  first,   ///< every other one is shown to be behind
  shared,  ///< not shown to be behind whoever leads
  behind,
  alone,  ///< nobody else may enter
};
std::string_view name_of(Place place);

/// Where a method stands in a family under a condition.
struct Placing {
  const ExamCell* cell{};
  Place place{};
  std::string_view behind_in{};  ///< "safety" or "outcome"
  double p_adjusted{1.0};        ///< the lesser of both tests against whoever leads
  double mean_rank{};            ///< among those who entered, by Friedman
  bool on_front{};               ///< nobody is both safer and faster, or one of them and equal in the other
};

/// The placings of one family under one condition, best first.
struct Contest {
  std::string family;
  std::string condition;
  std::vector<Placing> placings;
  double friedman_p{1.0};
  double critical_difference{};  ///< Nemenyi's, of mean ranks
  std::size_t seeds{};           ///< that all of them have
};

/// What a condition does to a method, over all families that it entered under it, run by run.
struct Awareness {
  std::string method;
  bool tuned{};
  std::string condition;
  RateDifference safety;    ///< collision-free under it less under the first condition
  double p_adjusted{1.0};   ///< McNemar's, by Holm over all of these
  MeanEstimate time_ratio;  ///< change of the time over the baseline's, in runs in which all arrived in both
};

struct ExamTable {
  std::vector<std::string> families;
  std::vector<std::string> conditions;
  std::vector<ExamCell> cells;
  std::vector<ExamRow> rows;
  std::vector<Contest> contests;
  std::vector<Awareness> awareness;
  std::size_t tests{};  ///< in Holm's family of the placings
};

/// The orders in which families and conditions stand, and what times are relative to.
struct ExamOrder {
  std::vector<std::string> families;
  std::vector<std::string> conditions;
  std::vector<std::string> methods;
  std::string baseline;
};

/// The table of these runs, which must outlive it; the same for the same runs in any order. Whoever leads a
/// contest has the most runs without a collision, then the most arrivals, then the least time. Two tests say
/// whether another is behind: McNemar's of collision-free runs, and a sign test of who came out better under
/// each seed: safe before unsafe, then in larger part arrived, then sooner by more than one in a hundred.
/// Their p values are taken times half the number of entrants, since any of them could have led, and adjusted
/// by Holm over the whole table. O(runs log runs).
ExamTable exam_table(std::span<const ExamRun> runs, const ExamOrder& order);

}  // namespace fairway
