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
#include "fairway/experiment/labels.hpp"

namespace fairway {
namespace {

struct LabelsBefore {
  bool operator()(const Labels& a, const Labels& b) const { return label_order(a, b) < 0; }
};
struct NameBefore {
  bool operator()(const std::string& a, const std::string& b) const { return natural_order(a, b) < 0; }
};

using Seeds = std::map<std::uint64_t, const RunRecord*>;
using Candidates = std::map<std::string, Seeds, NameBefore>;
using Groups = std::map<Labels, Candidates, LabelsBefore>;

template <class Names>
std::string suggest(const std::string& typed, const Names& known) {
  return suggestion(typed, std::vector<std::string_view>(known.begin(), known.end()));
}

/// Every run by group, candidate and seed.
Groups grouped(std::span<const RunRecord> records, const std::string& by) {
  Groups groups;
  std::set<std::string> names;
  for (const RunRecord& record : records) {
    const std::string* candidate = find_label(record.spec.labels, by);
    for (const auto& [name, value] : record.spec.labels) names.insert(name);
    if (candidate == nullptr) continue;
    const RunRecord*& place = groups[without_label(record.spec.labels, by)][*candidate][record.spec.seed];
    if (place != nullptr) {
      throw InputError(
          "two runs of " + labels_text(record.spec.labels) + " have the seed " +
          std::to_string(record.spec.seed) +
          ": these are results of more than one version of a scenario or of fairway; keep them apart");
    }
    place = &record;
  }
  if (records.empty()) throw InputError("there are no runs to compare");
  if (groups.empty()) throw InputError("no run has the label " + by + suggest(by, names));
  return groups;
}

std::string chosen_baseline(const Groups& groups, const CompareOptions& options) {
  std::set<std::string, NameBefore> candidates;
  for (const auto& [group, cells] : groups) {
    for (const auto& [candidate, seeds] : cells) candidates.insert(candidate);
  }
  if (options.baseline.empty()) return *candidates.begin();
  if (!candidates.contains(options.baseline)) {
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
  for (const std::string& quantity : options.quantities) {
    // where every run failed, nothing can be said about names
    if (!measured.empty() && !measured.contains(quantity)) {
      throw InputError("no run measured " + quantity + suggest(quantity, measured));
    }
  }
  return options.quantities;
}

/// A run's value, to take a mean of.
std::optional<double> finite_value_of(const RunRecord& record, const std::string& quantity) {
  const double value = run_value(record.measures, quantity);
  return std::isfinite(value) ? std::optional{value} : std::nullopt;
}

MeanEstimate mean_of(const Seeds& seeds, const std::string& quantity, double confidence) {
  std::vector<double> values;
  for (const auto& [seed, record] : seeds) {
    if (const auto value = finite_value_of(*record, quantity)) values.push_back(*value);
  }
  return estimate_mean(values, confidence);
}

MeanEstimate difference_of(const Seeds& seeds, const Seeds* baseline, const std::string& quantity,
                           double confidence) {
  std::vector<double> own;
  std::vector<double> others;
  for (const auto& [seed, record] : seeds) {
    if (baseline == nullptr) break;
    const auto partner = baseline->find(seed);
    if (partner == baseline->end()) continue;
    const auto a = finite_value_of(*record, quantity);
    const auto b = finite_value_of(*partner->second, quantity);
    if (!a || !b) continue;
    own.push_back(*a);
    others.push_back(*b);
  }
  return paired_difference(own, others, confidence);
}

RateEstimate rate_of(const Seeds& seeds, const RateQuestion& question, double confidence) {
  std::size_t runs = 0;
  std::size_t yes = 0;
  for (const auto& [seed, record] : seeds) {
    const double value = run_value(record->measures, question.quantity);
    if (std::isnan(value)) continue;
    ++runs;
    if (value >= question.min && value <= question.max) ++yes;
  }
  return wilson_interval(yes, runs, confidence);
}

}  // namespace

double run_value(std::span<const Measure> measures, std::string_view quantity) {
  double sum = 0.0;
  int vehicles = 0;
  for (const Measure& m : measures) {
    if (m.quantity != quantity) continue;
    if (m.vehicle == Measure::fleet) return m.value;
    if (!std::isfinite(m.value)) continue;
    sum += m.value;
    ++vehicles;
  }
  return vehicles == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / vehicles;
}

std::vector<RateQuestion> usual_rates() {
  return {{.name = "collision_free_ratio", .quantity = "collision_count", .min = 0.0, .max = 0.0},
          {.name = "all_arrived_ratio", .quantity = "arrived_ratio", .min = 1.0, .max = 1.0}};
}

Comparison compare(std::span<const RunRecord> records, const CompareOptions& options) {
  const Groups groups = grouped(records, options.by);
  const std::string baseline = chosen_baseline(groups, options);
  const std::vector<std::string> quantities = chosen_quantities(records, options);

  Comparison comparison{.by = options.by, .baseline = baseline, .confidence = options.confidence};
  for (const auto& [group, candidates] : groups) {
    const auto base = candidates.find(baseline);
    for (const auto& [candidate, seeds] : candidates) {
      const auto failed =
          std::count_if(seeds.begin(), seeds.end(), [](const auto& s) { return !s.second->failure.empty(); });
      comparison.cells.push_back({group, candidate, seeds.size(), static_cast<std::size_t>(failed)});

      const Seeds* other = base == candidates.end() || candidate == baseline ? nullptr : &base->second;
      for (const std::string& quantity : quantities) {
        comparison.means.push_back({group, candidate, quantity, mean_of(seeds, quantity, options.confidence),
                                    difference_of(seeds, other, quantity, options.confidence)});
      }
      for (const RateQuestion& question : options.rates) {
        const RateEstimate rate = rate_of(seeds, question, options.confidence);
        if (rate.trials > 0) comparison.rates.push_back({group, candidate, question.name, rate});
      }
    }
  }
  return comparison;
}

}  // namespace fairway
