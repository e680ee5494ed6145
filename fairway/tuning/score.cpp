// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/paired_tests.hpp"

namespace fairway {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double significance = 0.05;

PairedAnswers unsafe_pairs(std::span<const Outcome> a, std::span<const Outcome> b) {
  PairedAnswers answers;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].is_safe && !b[i].is_safe) ++answers.both;
    if (!a[i].is_safe && b[i].is_safe) ++answers.first;
    if (a[i].is_safe && !b[i].is_safe) ++answers.second;
    if (a[i].is_safe && b[i].is_safe) ++answers.neither;
  }
  return answers;
}

/// Whether the differences of blocks are above 0 beyond chance.
bool is_positive(const std::vector<double>& differences, std::size_t scenarios) {
  std::vector<double> known;
  for (const double mean : block_means(differences, scenarios))
    if (std::isfinite(mean)) known.push_back(mean);
  return known.size() >= 2 && estimate_mean(known, 1.0 - significance).low > 0.0;
}

}  // namespace

Outcome failed_outcome() { return {.is_safe = false, .arrived = 0.0, .time_s = unknown}; }

Outcome outcome_of(std::span<const Measure> measures) {
  const double collisions = run_value(measures, "pair_collision_count");
  const bool touched = std::ranges::any_of(measures, [](const Measure& measure) {
    return measure.quantity == "footprint_clearance_m" && measure.value < 0.0;
  });
  const double time = run_value(measures, "navigation_time_s");
  return {.is_safe = !(collisions > 0.0) && !touched,
          .arrived = run_value(measures, "arrived_ratio"),
          .time_s = std::isfinite(time) ? time : unknown};
}

std::vector<double> time_ratios(std::span<const Outcome> outcomes, std::span<const Outcome> usual) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(outcomes.size(), usual.size()); ++i)
    ratios.push_back(usual[i].time_s > 0.0 ? outcomes[i].time_s / usual[i].time_s : unknown);
  return ratios;
}

std::vector<double> block_means(std::span<const double> values, std::size_t scenarios) {
  std::vector<double> means;
  for (std::size_t first = 0; first + scenarios <= values.size(); first += scenarios) {
    double sum = 0.0;
    std::size_t known = 0;
    for (const double value : values.subspan(first, scenarios)) {
      if (!std::isfinite(value)) continue;
      sum += value;
      ++known;
    }
    means.push_back(known > 0 ? sum / static_cast<double>(known) : unknown);
  }
  return means;
}

Score score_of(std::span<const Outcome> outcomes, std::span<const Outcome> usual) {
  const std::size_t runs = std::min(outcomes.size(), usual.size());
  const std::span<const Outcome> counted = outcomes.first(runs);
  Score score{.runs = runs};
  for (const Outcome& outcome : counted) {
    score.unsafe += outcome.is_safe ? 0 : 1;
    score.arrived += outcome.arrived / static_cast<double>(runs);
  }
  const std::vector<double> whole = block_means(time_ratios(counted, usual), std::max<std::size_t>(1, runs));
  score.time_ratio = whole.empty() ? unknown : whole.front();
  return score;
}

bool is_better(const Score& a, const Score& b) {
  if (a.unsafe != b.unsafe) return a.unsafe < b.unsafe;
  if (a.arrived != b.arrived) return a.arrived > b.arrived;
  if (std::isnan(b.time_ratio)) return std::isfinite(a.time_ratio);
  return a.time_ratio < b.time_ratio;
}

bool is_dominated(const Score& a, const Score& b) {
  const bool as_good = b.unsafe <= a.unsafe && b.arrived >= a.arrived && !(b.time_ratio > a.time_ratio);
  return as_good && (b.unsafe < a.unsafe || b.arrived > a.arrived || b.time_ratio < a.time_ratio);
}

bool is_beaten(std::span<const Outcome> a, std::span<const Outcome> b, std::size_t scenarios) {
  const std::size_t runs = std::min(a.size(), b.size());
  a = a.first(runs);
  b = b.first(runs);
  const PairedAnswers unsafe = unsafe_pairs(a, b);
  if (unsafe.first != unsafe.second && mcnemar_test(unsafe).p < significance)
    return unsafe.first > unsafe.second;
  if (unsafe.first < unsafe.second) return false;  // no evidence yet, and it looks safer

  std::vector<double> fewer_arrivals(runs), longer(runs);
  for (std::size_t i = 0; i < runs; ++i) {
    fewer_arrivals[i] = b[i].arrived - a[i].arrived;
    longer[i] = b[i].time_s > 0.0 ? a[i].time_s / b[i].time_s - 1.0 : unknown;
  }
  if (is_positive(fewer_arrivals, scenarios)) return true;
  double balance = 0.0;
  for (const double fewer : fewer_arrivals) balance += fewer;
  return balance >= 0.0 && is_positive(longer, scenarios);
}

}  // namespace fairway
