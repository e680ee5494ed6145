// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/labels.hpp"

namespace fairway {
namespace {

/// "case=bay method=apf", and how many more such there are.
std::string cells_text(const std::vector<Labels>& cells) {
  constexpr std::size_t named = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(named, cells.size()); ++i)
    text.append(i == 0 ? "" : ", ").append(labels_text(cells[i]));
  if (cells.size() > named) text += fmt::format(" and {} more", cells.size() - named);
  return text;
}

Labels labels_of(const Comparison& comparison, const ComparedCell& cell) {
  Labels labels = cell.group;
  labels.emplace_back(comparison.by, cell.candidate);
  return labels;
}

void remark_identical(const Comparison& comparison, std::vector<Remark>& said) {
  std::vector<Labels> cells;
  std::size_t most = 0;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.identical == 0) continue;
    cells.push_back(labels_of(comparison, cell));
    most = std::max(most, cell.identical);
  }
  if (cells.empty()) return;
  said.push_back(
      {true,
       fmt::format("Nothing is drawn in {}: runs of {} seeds are identical to the bit and count as one.",
                   cells_text(cells), most)});
}

void remark_failed(const Comparison& comparison, std::vector<Remark>& said) {
  std::vector<Labels> cells;
  std::size_t failed = 0;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.failed > 0) cells.push_back(labels_of(comparison, cell));
    failed += cell.failed;
  }
  if (failed == 0) return;
  said.push_back(
      {true, fmt::format("{} of {} failed: in rates they count as failures, from means they are left out.",
                         failed == 1 ? "1 run" : fmt::format("{} runs", failed), cells_text(cells))});
}

void remark_cut(const Comparison& comparison, std::vector<Remark>& said) {
  std::set<std::string> cut;
  for (const ComparedMean& mean : comparison.means) {
    if (mean.censored) cut.insert(mean.quantity);
  }
  if (cut.empty()) return;
  said.push_back(
      {true,
       fmt::format("Times that the end of a run cut off ({}) are censored: the median is Kaplan and Meier's, "
                   "the mean counts times up to the limit beside it, with Greenwood's error; differences are "
                   "of these means, and the sign test asks which of a pair took longer, where that is known.",
                   fmt::join(cut, ", "))});
}

void remark_truncated(const Comparison& comparison, std::vector<Remark>& said) {
  std::set<std::string> ended;
  for (const ComparedMean& mean : comparison.means)
    if (mean.truncated > 0) ended.insert(mean.quantity);
  if (ended.empty()) return;
  said.push_back(
      {true, fmt::format("Where not all arrived, {} of each vehicle counts until it arrived or was given up, "
                         "or until the end of the run: means are restricted to that.",
                         fmt::join(ended, ", "))});
}

template <class T>
bool tested(const std::vector<T>& rows) {
  return std::ranges::any_of(rows, [](const T& row) { return row.test.has_value(); });
}

}  // namespace

std::vector<Remark> remarks(const Comparison& comparison) {
  std::vector<Remark> said;
  remark_identical(comparison, said);
  remark_failed(comparison, said);
  remark_cut(comparison, said);
  remark_truncated(comparison, said);
  if (comparison.tests == 0) return said;

  std::string tests = "Differences are paired by seed";
  if (tested(comparison.means)) {
    tests +=
        "; of quantities: mean with Student's t interval, Hodges and Lehmann's median, Wilcoxon's signed "
        "rank test with the rank-biserial correlation as its effect";
  }
  if (tested(comparison.rates))
    tests += "; of rates: Newcombe's interval, McNemar's exact test with Cohen's g as its effect";
  said.push_back({false, tests + ". p is adjusted by " + comparison.family + "."});
  return said;
}

}  // namespace fairway
