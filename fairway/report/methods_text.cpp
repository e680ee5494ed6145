// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/methods_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

/// "1 to 20", "1, 2 and 7" or how many they are.
std::string seeds_text(const std::set<std::uint64_t>& seeds) {
  const std::uint64_t first = *seeds.begin(), last = *seeds.rbegin();
  if (seeds.size() == 1) return fmt::format("the seed {}", first);
  if (last - first + 1 == seeds.size())
    return fmt::format("the {} seeds {} to {}", seeds.size(), first, last);
  return fmt::format("{} seeds between {} and {}", seeds.size(), first, last);
}

std::string design_text(const Comparison& comparison, std::span<const RunRecord> records) {
  LabelValues values;
  std::set<std::uint64_t> seeds;
  std::size_t failed = 0;
  for (const RunRecord& record : records) {
    add_values(values, record.spec.labels);
    seeds.insert(record.spec.seed);
    failed += record.failure.empty() ? 0 : 1;
  }
  std::vector<std::string> candidates;
  for (const ComparedCell& cell : comparison.cells) {
    if (std::ranges::find(candidates, cell.candidate) == candidates.end())
      candidates.push_back(cell.candidate);
  }
  std::string text = fmt::format("{} values of {} ({}) were simulated", candidates.size(), comparison.by,
                                 fmt::join(candidates, ", "));
  std::string places;
  for (const auto& [name, known] : values) {
    if (name == comparison.by) continue;
    places += places.empty() ? " in all combinations of " : "; ";
    places += fmt::format("{} ({})", name, fmt::join(known, ", "));
  }
  text += places + fmt::format(" with {}, the same for each, so that runs pair by seed: {} runs",
                               seeds_text(seeds), records.size());
  if (failed > 0) text += fmt::format(", of which {} failed", failed);
  return text + ".";
}

std::string values_text(const Comparison& comparison, const std::string& percent) {
  std::string text = fmt::format(
      "Each run counts as one value; a quantity of vehicles is averaged over the vehicles of a run first. "
      "Means over runs have {} intervals of Student's t, shares of runs Wilson's score intervals.",
      percent);
  const bool failed = std::ranges::any_of(comparison.cells, [](const auto& cell) { return cell.failed > 0; });
  if (failed) text += " Failed runs count as failures in every share and are left out of means.";
  const bool identical =
      std::ranges::any_of(comparison.cells, [](const auto& cell) { return cell.identical > 0; });
  if (identical)
    text +=
        " Cells whose runs agreed to the bit under all seeds, since nothing is drawn in them, count as one "
        "run.";
  const bool cut =
      std::ranges::any_of(comparison.means, [](const auto& mean) { return mean.censored.has_value(); });
  if (cut) {
    text +=
        " Times of runs that ended before everyone had arrived are taken as censored there: medians are "
        "Kaplan-Meier estimates with Brookmeyer-Crowley intervals, means are restricted to the common limit, "
        "with "
        "Greenwood's standard error; their differences are of paired pseudo-values, tested by the exact sign "
        "test.";
  }
  return text;
}

std::string tests_text(const Comparison& comparison, const std::string& percent) {
  if (comparison.tests == 0) return {};
  return fmt::format(
      "Differences from {} are paired by seed: mean with {} interval of Student's t, and Hodges-Lehmann "
      "estimate "
      "with the interval of the signed rank distribution (exact up to {} pairs). Quantities are tested by "
      "the "
      "two-sided Wilcoxon signed rank test (exact up to {} pairs without ties, else normal with corrections "
      "for ties "
      "and continuity), with the matched-pairs rank-biserial correlation as effect size; shares by the exact "
      "McNemar "
      "test, with Newcombe's interval of the paired difference (1998, method 10) and Cohen's g. p values are "
      "adjusted by {}.",
      comparison.baseline, percent, most_exact_pairs, most_exact_pairs, comparison.family);
}

std::string versions_text(const Origin& origin) {
  std::string made = origin.version.empty() ? "an unknown version" : origin.version;
  std::string text = fmt::format("Simulated with fairway {}", made);
  if (!origin.epoch.empty()) text += fmt::format(" (results epoch {})", origin.epoch);
  return text + fmt::format("; statistics by fairway {}.", fairway_version);
}

}  // namespace

std::vector<std::string> methods_text(const Comparison& comparison, std::span<const RunRecord> records,
                                      const Origin& origin) {
  const std::string percent = fmt::format("{:.4g} %", 100.0 * comparison.confidence);
  std::vector<std::string> paragraphs{design_text(comparison, records), values_text(comparison, percent)};
  if (comparison.tests > 0) paragraphs.push_back(tests_text(comparison, percent));
  paragraphs.push_back(versions_text(origin));
  return paragraphs;
}

}  // namespace fairway
