// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/compare.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "fairway/core/error.hpp"
#include "fairway/core/names.hpp"
#include "fairway/experiment/compared_cells.hpp"
#include "fairway/experiment/labels.hpp"

namespace fairway {
namespace {

struct LabelsBefore {
  bool operator()(const Labels& a, const Labels& b) const { return label_order(a, b) < 0; }
};
struct NameBefore {
  bool operator()(const std::string& a, const std::string& b) const { return natural_order(a, b) < 0; }
};

using Candidates = std::map<std::string, CellOfRuns, NameBefore>;
using Groups = std::map<Labels, Candidates, LabelsBefore>;

template <class Names>
std::string suggest(const std::string& typed, const Names& known) {
  return suggestion(typed, std::vector<std::string_view>(known.begin(), known.end()));
}

/// Runs of one cell have to be of one case, as far as their versions are known.
void refuse_other_version(CellOfRuns& cell, const RunRecord& record) {
  if (record.spec.version.empty()) return;
  if (cell.versioned == nullptr) cell.versioned = &record;
  if (cell.versioned->spec.version == record.spec.version) return;
  throw InputError("the runs of " + labels_text(record.spec.labels) + " with the seeds " +
                   std::to_string(cell.versioned->spec.seed) + " and " + std::to_string(record.spec.seed) +
                   " are of two versions of a scenario or of fairway; keep them apart, or say that they are "
                   "to be mixed");
}

/// The cells in which runs are the same. Where one of a group is, its scenario draws nothing for the others.
void count_runs(Candidates& candidates) {
  bool nothing_is_drawn = false;
  for (int round = 0; round < 2; ++round) {
    for (auto& [candidate, cell] : candidates) {
      std::vector<const RunRecord*> runs;
      for (const auto& [seed, run] : cell.all) runs.push_back(run);
      cell.counted = counted_runs(runs, nothing_is_drawn);
    }
    nothing_is_drawn = std::ranges::any_of(candidates, [](const auto& named) { return named.second.same(); });
    if (!nothing_is_drawn) return;
  }
}

/// Every run by group, candidate and seed.
Groups grouped(std::span<const RunRecord> records, const std::string& by, bool mixed) {
  Groups groups;
  std::set<std::string> names;
  for (const RunRecord& record : records) {
    const std::string* candidate = find_label(record.spec.labels, by);
    for (const auto& [name, value] : record.spec.labels) names.insert(name);
    if (candidate == nullptr) continue;
    CellOfRuns& cell = groups[without_label(record.spec.labels, by)][*candidate];
    const RunRecord*& place = cell.all[record.spec.seed];
    if (place != nullptr) {
      throw InputError(
          "two runs of " + labels_text(record.spec.labels) + " have the seed " +
          std::to_string(record.spec.seed) +
          ": these are results of more than one version of a scenario or of fairway; keep them apart");
    }
    if (!mixed) refuse_other_version(cell, record);
    place = &record;
  }
  if (records.empty()) throw InputError("there are no runs to compare");
  if (groups.empty()) throw InputError("no run has the label " + by + suggest(by, names));
  for (auto& [group, candidates] : groups) count_runs(candidates);
  return groups;
}

/// The values of the label: those that are named in their order, then the others.
std::vector<std::string> candidates_of(const Groups& groups, const std::vector<std::string>& order) {
  std::set<std::string, NameBefore> there;
  for (const auto& [group, cells] : groups) {
    for (const auto& [candidate, cell] : cells) there.insert(candidate);
  }
  std::vector<std::string> candidates;
  for (const std::string& name : order) {
    if (there.erase(name) > 0) candidates.push_back(name);
  }
  candidates.insert(candidates.end(), there.begin(), there.end());
  return candidates;
}

std::string chosen_baseline(const std::vector<std::string>& candidates, const CompareOptions& options) {
  if (options.baseline.empty()) return candidates.front();
  if (std::ranges::find(candidates, options.baseline) == candidates.end()) {
    throw InputError("no run has " + options.by + "=" + options.baseline +
                     suggest(options.baseline, candidates));
  }
  return options.baseline;
}

std::vector<std::string> chosen_quantities(std::span<const RunRecord> records,
                                           const CompareOptions& options) {
  // in the order in which a run reports them
  std::vector<std::string> order;
  std::set<std::string> measured;
  for (const RunRecord& record : records) {
    for (const Measure& m : record.measures) {
      if (measured.insert(m.quantity).second) order.push_back(m.quantity);
    }
  }
  if (options.quantities.empty()) return order;
  std::set<std::string> asked;
  for (const std::string& quantity : options.quantities) {
    if (!asked.insert(quantity).second) throw InputError(quantity + ": is asked about twice");
    // where every run failed, nothing can be said about names
    if (!measured.empty() && !measured.contains(quantity)) {
      throw InputError("no run measured " + quantity + suggest(quantity, measured));
    }
  }
  return options.quantities;
}

/// The questions that some run can answer; all of them where every run failed.
std::vector<RateQuestion> asked_rates(std::span<const RunRecord> records, const CompareOptions& options) {
  const bool none = std::ranges::all_of(records, [](const RunRecord& r) { return r.measures.empty(); });
  std::vector<RateQuestion> asked;
  std::ranges::copy_if(options.rates, std::back_inserter(asked), [&](const RateQuestion& question) {
    return none || std::ranges::any_of(records, [&](const RunRecord& record) {
             return !std::isnan(run_value(record.measures, question.quantity));
           });
  });
  return asked;
}

ComparedCell cell_of(const Labels& group, const std::string& candidate, const CellOfRuns& cell) {
  const auto failed =
      std::ranges::count_if(cell.counted, [](const RunRecord* run) { return !run->failure.empty(); });
  return {group, candidate, cell.counted.size(), static_cast<std::size_t>(failed),
          cell.same() ? cell.all.size() : 0};
}

/// What is asked of every cell of a group.
struct Questions {
  std::vector<std::string> quantities;
  std::vector<std::optional<double>> limits;  ///< common_limit() of each quantity
  std::vector<RateQuestion> rates;
};

Questions questions_of(const Candidates& cells, const std::vector<std::string>& quantities,
                       const std::vector<RateQuestion>& rates) {
  std::vector<const CellOfRuns*> all;
  for (const auto& [name, cell] : cells) all.push_back(&cell);
  Questions questions{.quantities = quantities, .limits = {}, .rates = rates};
  for (const std::string& quantity : quantities) questions.limits.push_back(common_limit(all, quantity));
  return questions;
}

/// `baseline` is null for the baseline itself and where a group has none.
void compare_cell(Comparison& comparison, const ComparedCell& name, const CellOfRuns& cell,
                  const CellOfRuns* baseline, const Questions& questions) {
  const double confidence = comparison.confidence;
  for (std::size_t i = 0; i < questions.quantities.size(); ++i) {
    ComparedMean mean = mean_of(cell, questions.quantities[i], questions.limits[i], confidence);
    mean.group = name.group;
    mean.candidate = name.candidate;
    if (baseline != nullptr) add_difference(mean, cell, *baseline, questions.limits[i], confidence);
    comparison.means.push_back(std::move(mean));
  }
  for (const RateQuestion& question : questions.rates) {
    ComparedRate rate{name.group, name.candidate, question.name, rate_of(cell, question, confidence)};
    if (rate.value.trials == 0) continue;
    if (baseline != nullptr) add_difference(rate, cell, *baseline, question, confidence);
    comparison.rates.push_back(std::move(rate));
  }
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// "Holm over 12 comparisons: 3 methods x 4 quantities".
std::string family_of(const Comparison& comparison) {
  std::set<std::string> candidates, quantities, rates;
  std::set<Labels> groups;
  const auto note = [&](const auto& row, std::set<std::string>& names, const std::string& name) {
    if (!row.test) return;
    candidates.insert(row.candidate);
    groups.insert(row.group);
    names.insert(name);
  };
  for (const ComparedMean& mean : comparison.means) note(mean, quantities, mean.quantity);
  for (const ComparedRate& rate : comparison.rates) note(rate, rates, rate.name);
  if (comparison.tests == 0) return {};

  const std::string& by = comparison.by;
  std::string asked = counted(quantities.size(), "quantity", "quantities");
  if (quantities.empty()) asked = counted(rates.size(), "rate", "rates");
  if (!quantities.empty() && !rates.empty())
    asked = "(" + asked + " and " + counted(rates.size(), "rate", "rates") + ")";
  std::string text = "Holm over " + counted(comparison.tests, "comparison", "comparisons") + ": " +
                     (by == "method" ? counted(candidates.size(), "method", "methods")
                                     : counted(candidates.size(), "value of ", "values of ") + by) +
                     " x " + asked;
  if (groups.size() > 1) text += " x " + std::to_string(groups.size()) + " cases";
  const std::size_t whole = candidates.size() * (quantities.size() + rates.size()) * groups.size();
  if (whole != comparison.tests)
    text += ", less " + std::to_string(whole - comparison.tests) + " without a pair";
  return text;
}

/// Holm's adjustment over everything that was tested.
void adjust(Comparison& comparison) {
  std::vector<ComparedTest*> tests;
  for (ComparedMean& mean : comparison.means) {
    if (mean.test) tests.push_back(&*mean.test);
  }
  for (ComparedRate& rate : comparison.rates) {
    if (rate.test) tests.push_back(&*rate.test);
  }
  std::vector<double> p;
  for (const ComparedTest* test : tests) p.push_back(test->result.p);
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < tests.size(); ++i) tests[i]->p_adjusted = adjusted[i];
  comparison.tests = tests.size();
  comparison.family = family_of(comparison);
}

}  // namespace

std::vector<RateQuestion> usual_rates() {
  return {{.name = "collision_free_ratio",
           .quantity = "collision_count",
           .min = 0.0,
           .max = 0.0,
           .also = "pair_collision_count"},
          {.name = "all_arrived_ratio", .quantity = "arrived_ratio", .min = 1.0, .max = 1.0}};
}

Comparison compare(std::span<const RunRecord> records, const CompareOptions& options) {
  const Groups groups = grouped(records, options.by, options.mixed);
  const std::vector<std::string> candidates = candidates_of(groups, options.order);
  const std::vector<std::string> quantities = chosen_quantities(records, options);
  const std::vector<RateQuestion> rates = asked_rates(records, options);

  const std::string baseline = chosen_baseline(candidates, options);

  Comparison comparison{.by = options.by, .baseline = baseline, .confidence = options.confidence};
  for (const auto& [group, cells] : groups) {
    const Questions questions = questions_of(cells, quantities, rates);
    const auto base = cells.find(baseline);
    for (const std::string& candidate : candidates) {
      const auto cell = cells.find(candidate);
      if (cell == cells.end()) continue;
      comparison.cells.push_back(cell_of(group, candidate, cell->second));
      const bool alone = base == cells.end() || candidate == baseline;
      compare_cell(comparison, comparison.cells.back(), cell->second, alone ? nullptr : &base->second,
                   questions);
    }
  }
  adjust(comparison);
  return comparison;
}

}  // namespace fairway
