// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/compared_cells.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/experiment/special_numbers.hpp"
#include "fairway/metrics/run_metrics.hpp"

namespace fairway {
namespace {

using special::nan;

/// What a run has of a quantity.
struct Observed : ObservedTime {
  double value{};  ///< run_value(); of a time that was cut off, a lower end
};

/// If the run did not fail and the value is a number. A time of the fleet may have been cut off. The mean of
/// its vehicles' times, each of which counts until the end of the run at most, is known whoever arrived.
std::optional<Observed> observed(const RunRecord& record, const std::string& quantity) {
  const double value = run_value(record.measures, quantity);
  if (!record.failure.empty() || !std::isfinite(value)) return std::nullopt;
  const auto first = std::ranges::find(record.measures, quantity, &Measure::quantity);
  const bool cut = first->vehicle == Measure::fleet && cut_off(record.measures, quantity);
  return Observed{{value, cut}, value};
}

std::size_t truncated(const std::vector<const RunRecord*>& runs, const std::string& quantity) {
  return static_cast<std::size_t>(std::ranges::count_if(runs, [&](const RunRecord* run) {
    const auto value = observed(*run, quantity);
    return value && !value->cut && cut_off(run->measures, quantity);
  }));
}

std::vector<ObservedTime> observed(const std::vector<const RunRecord*>& runs, const std::string& quantity) {
  std::vector<ObservedTime> values;
  for (const RunRecord* run : runs) {
    if (const auto value = observed(*run, quantity)) values.push_back(*value);
  }
  return values;
}

bool any_cut(const std::vector<ObservedTime>& values) {
  return std::ranges::any_of(values, &ObservedTime::cut);
}

std::vector<double> times_of(const std::vector<ObservedTime>& values) {
  std::vector<double> times;
  for (const ObservedTime& value : values) times.push_back(value.time);
  return times;
}

CensoredTimes censored(const CellOfRuns& cell, const std::vector<ObservedTime>& values, double limit,
                       double confidence) {
  const auto failed =
      std::ranges::count_if(cell.counted, [](const auto* run) { return !run->failure.empty(); });
  CensoredTimes times{.cut = static_cast<std::size_t>(std::ranges::count_if(values, &ObservedTime::cut)),
                      .complete = {},
                      .curve = kaplan_meier(values),
                      .median = {},
                      .limit = limit,
                      .restricted = {}};
  times.complete = wilson_interval(values.size() - times.cut,
                                   values.size() + static_cast<std::size_t>(failed), confidence);
  times.median = median_time(times.curve, confidence);
  times.restricted = restricted_mean(times.curve, limit, confidence);
  return times;
}

/// Both values of each pair that has both.
struct PairedValues {
  std::vector<ObservedTime> own, others;
  std::vector<double> own_values, other_values;
};

PairedValues paired_values(const CellOfRuns& cell, const CellOfRuns& baseline, const std::string& quantity) {
  PairedValues values;
  for (const auto& [run, partner] : pairs_of(cell, baseline)) {
    const auto a = observed(*run, quantity);
    const auto b = observed(*partner, quantity);
    if (!a || !b) continue;
    values.own.push_back(*a);
    values.others.push_back(*b);
    values.own_values.push_back(a->value);
    values.other_values.push_back(b->value);
  }
  return values;
}

/// Values no farther apart than single precision tells are the same to whoever reads them: rounding that two
/// methods do differently leaves more than nothing, and a test by ranks would count it.
double grain_of(const std::vector<double>& own, const std::vector<double>& others) {
  double largest = 0.0;
  for (const auto* side : {&own, &others}) {
    for (const double value : *side) largest = std::max(largest, std::abs(value));
  }
  return std::ldexp(largest, -24);
}

/// Which of each pair took longer, as far as what was cut off lets it be known.
PairedTest longer_test(const PairedValues& values, double grain) {
  std::size_t more = 0;
  std::size_t less = 0;
  for (std::size_t i = 0; i < values.own.size(); ++i) {
    const ObservedTime& a = values.own[i];
    const ObservedTime& b = values.others[i];
    if (a.cut && b.cut) continue;
    const double difference = values.own_values[i] - values.other_values[i];
    if ((!b.cut && difference > grain) || (a.cut && difference >= -grain)) ++more;
    if ((!a.cut && difference < -grain) || (b.cut && difference <= grain)) ++less;
  }
  return sign_test(more, less);
}

/// No answer of a run that did not measure it; a run that failed is a no.
std::optional<bool> answer_of(const RunRecord& record, const RateQuestion& question) {
  if (!record.failure.empty()) return false;
  const double value = run_value(record.measures, question.quantity);
  if (std::isnan(value)) return std::nullopt;
  const double other = question.also.empty() ? nan : run_value(record.measures, question.also);
  const auto lies_within = [&](double x) { return x >= question.min && x <= question.max; };
  return lies_within(value) && (std::isnan(other) || lies_within(other));
}

/// The same number, or none on both sides.
bool same(const Measure& a, const Measure& b) {
  return a.quantity == b.quantity && a.vehicle == b.vehicle &&
         (a.value == b.value || (std::isnan(a.value) && std::isnan(b.value)));
}

}  // namespace

std::vector<const RunRecord*> counted_runs(std::span<const RunRecord* const> cell, bool nothing_is_drawn) {
  std::vector<const RunRecord*> all(cell.begin(), cell.end());
  if (all.size() < 2) return all;
  const std::vector<Measure>& first = all.front()->measures;
  const bool fine = std::ranges::any_of(
      first, [](const Measure& m) { return std::isfinite(m.value) && m.value != std::trunc(m.value); });
  const bool alike =
      (fine || nothing_is_drawn) && std::ranges::all_of(all, [&](const RunRecord* run) {
        return run->failure == all.front()->failure && std::ranges::equal(run->measures, first, same);
      });
  if (alike) all.resize(1);
  return all;
}

std::vector<std::pair<const RunRecord*, const RunRecord*>> pairs_of(const CellOfRuns& candidate,
                                                                    const CellOfRuns& baseline) {
  if (candidate.same() && baseline.same()) return {{candidate.counted.front(), baseline.counted.front()}};
  std::vector<std::pair<const RunRecord*, const RunRecord*>> pairs;
  for (const auto& [seed, run] : candidate.all) {
    const auto partner = baseline.all.find(seed);
    if (partner != baseline.all.end()) pairs.emplace_back(run, partner->second);
  }
  return pairs;
}

std::optional<double> common_limit(const std::vector<const CellOfRuns*>& cells, const std::string& quantity) {
  bool cut = false;
  double last = 0.0;
  double limit = std::numeric_limits<double>::infinity();
  for (const CellOfRuns* cell : cells) {
    const std::vector<ObservedTime> values = observed(cell->counted, quantity);
    if (values.empty()) continue;
    const double longest = std::ranges::max(values, {}, &ObservedTime::time).time;
    last = std::max(last, longest);
    cut = cut || any_cut(values);
    if (std::ranges::any_of(values, [&](const ObservedTime& v) { return v.cut && v.time == longest; }))
      limit = std::min(limit, longest);
  }
  if (!cut) return std::nullopt;
  return std::min(limit, last);
}

ComparedMean mean_of(const CellOfRuns& cell, const std::string& quantity, std::optional<double> limit,
                     double confidence) {
  const std::vector<ObservedTime> values = observed(cell.counted, quantity);
  std::vector<double> times = times_of(values);
  ComparedMean mean{.group = {},
                    .candidate = {},
                    .quantity = quantity,
                    .value = estimate_mean(times, confidence),
                    .median = nan,
                    .left_out = cell.counted.size() - values.size(),
                    .truncated = truncated(cell.counted, quantity),
                    .difference = {0, nan, nan, nan, nan},
                    .difference_median = {nan, nan, nan}};
  std::ranges::sort(times);
  mean.median = quantile(times, 0.5);
  if (!limit) return mean;

  mean.censored = censored(cell, values, *limit, confidence);
  mean.median = mean.censored->median.median;
  if (mean.censored->cut > 0) mean.value = {values.size(), nan, nan, nan, nan};
  return mean;
}

void add_difference(ComparedMean& mean, const CellOfRuns& cell, const CellOfRuns& baseline,
                    std::optional<double> limit, double confidence) {
  const PairedValues values = paired_values(cell, baseline, mean.quantity);
  if (values.own.empty()) return;
  std::vector<double> own = values.own_values;
  std::vector<double> others = values.other_values;
  const double grain = grain_of(own, others);

  if (limit && (any_cut(values.own) || any_cut(values.others))) {
    own = restricted_pseudo_values(values.own, *limit);
    others = restricted_pseudo_values(values.others, *limit);
    mean.difference = paired_difference(own, others, confidence);
    mean.test = {.name = "sign", .effect_size = "rank_biserial", .result = longer_test(values, grain)};
    return;
  }
  mean.difference = paired_difference(own, others, confidence);
  std::ranges::transform(own, others, own.begin(), std::minus<>{});
  mean.difference_median = hodges_lehmann(own, confidence);
  mean.test = {
      .name = "wilcoxon_signed_rank", .effect_size = "rank_biserial", .result = signed_rank_test(own, grain)};
}

RateEstimate rate_of(const CellOfRuns& cell, const RateQuestion& question, double confidence) {
  std::size_t runs = 0;
  std::size_t yes = 0;
  for (const RunRecord* run : cell.counted) {
    const auto answer = answer_of(*run, question);
    runs += answer ? 1 : 0;
    yes += answer.value_or(false) ? 1 : 0;
  }
  return wilson_interval(yes, runs, confidence);
}

void add_difference(ComparedRate& rate, const CellOfRuns& cell, const CellOfRuns& baseline,
                    const RateQuestion& question, double confidence) {
  PairedAnswers answers;
  for (const auto& [run, partner] : pairs_of(cell, baseline)) {
    const auto a = answer_of(*run, question);
    const auto b = answer_of(*partner, question);
    if (!a || !b) continue;
    ++(*a ? (*b ? answers.both : answers.first) : (*b ? answers.second : answers.neither));
  }
  rate.difference = paired_rate_difference(answers, confidence);
  if (rate.difference.pairs == 0) return;
  rate.test = {.name = "mcnemar", .effect_size = "cohens_g", .result = mcnemar_test(answers)};
}

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
  return vehicles == 0 ? nan : sum / vehicles;
}

bool cut_off(std::span<const Measure> measures, std::string_view quantity) {
  static const std::vector<QuantityInfo> known = all_quantities();
  const auto info = std::ranges::find(known, quantity, &QuantityInfo::name);
  if (info == known.end() || info->complete_at_1.empty()) return false;
  return run_value(measures, info->complete_at_1) < 1.0;
}

}  // namespace fairway
