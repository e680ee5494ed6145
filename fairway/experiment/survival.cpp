// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/survival.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

#include "fairway/experiment/special_numbers.hpp"
#include "fairway/experiment/statistics.hpp"

namespace fairway {
namespace {

using special::infinity;
using special::nan;

/// Shares nearer than this to a half are a half.
constexpr double rounding = 1e-8;

double z_of(double confidence) {
  return quantile(boost::math::complement(boost::math::normal{}, tail_of(confidence)));
}

/// Where a falling curve crosses a half: in the middle of the way that it stays at it.
template <class Height>
double half_time(std::span<const SurvivalStep> steps, Height height) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double here = height(steps[i]);
    if (std::isnan(here) || here >= 0.5 + rounding) continue;
    if (here <= 0.5 - rounding) return steps[i].time;
    const auto next = std::find_if(steps.begin() + static_cast<long>(i), steps.end(),
                                   [&](const SurvivalStep& s) { return height(s) < here; });
    return next == steps.end() ? steps[i].time : std::midpoint(steps[i].time, next->time);
  }
  return infinity;
}

/// The area below the steps from each of them to the limit, and before them from 0.
std::vector<double> areas_from(std::span<const SurvivalStep> steps, double limit) {
  std::vector<double> areas(steps.size() + 1, 0.0);
  double end = limit;
  for (std::size_t i = steps.size(); i-- > 0;) {
    const double begin = std::min(steps[i].time, limit);
    areas[i + 1] = (i + 1 < steps.size() ? areas[i + 2] : 0.0) + steps[i].share * (end - begin);
    end = begin;
  }
  areas[0] = (steps.empty() ? 0.0 : areas[1]) + end;
  return areas;
}

/// The steps of the curve; the times are in order.
std::vector<SurvivalStep> steps_of(std::span<const ObservedTime> sorted) {
  std::vector<SurvivalStep> steps;
  double share = 1.0;
  double variance = 0.0;
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin;
    std::size_t events = 0;
    for (; end < sorted.size() && sorted[end].time == sorted[begin].time; ++end)
      events += sorted[end].cut ? 0 : 1;
    if (events > 0) {
      const std::size_t at_risk = sorted.size() - begin;
      const auto n = static_cast<double>(at_risk);
      const auto d = static_cast<double>(events);
      share = events == at_risk ? 0.0 : share * (1.0 - d / n);
      variance += d / (n * (n - d));
      steps.push_back({sorted[begin].time, share, variance, at_risk, events});
    }
    begin = end;
  }
  return steps;
}

bool before(const ObservedTime& a, const ObservedTime& b) { return a.time < b.time; }

}  // namespace

std::vector<SurvivalStep> kaplan_meier(std::span<const ObservedTime> times) {
  std::vector<ObservedTime> sorted(times.begin(), times.end());
  std::sort(sorted.begin(), sorted.end(), before);
  return steps_of(sorted);
}

MedianEstimate median_time(std::span<const SurvivalStep> steps, double confidence) {
  const double z = z_of(confidence);
  // at share 0 the bands are not known
  const auto band = [&](double sign) {
    return half_time(steps, [&, sign](const SurvivalStep& s) {
      return s.share == 0.0 ? nan : std::min(1.0, s.share * std::exp(sign * z * std::sqrt(s.variance)));
    });
  };
  const double low = band(-1.0);
  return {half_time(steps, [](const SurvivalStep& s) { return s.share; }),
          std::isfinite(low) ? low : -infinity, band(1.0)};
}

RestrictedMean restricted_mean(std::span<const SurvivalStep> steps, double limit, double confidence) {
  const std::vector<double> areas = areas_from(steps, limit);
  double variance = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    // the last of all leaves nothing behind it
    if (steps[i].events == steps[i].at_risk || steps[i].time >= limit) break;
    const auto n = static_cast<double>(steps[i].at_risk);
    const auto d = static_cast<double>(steps[i].events);
    variance += areas[i + 1] * areas[i + 1] * d / (n * (n - d));
  }
  const double error = std::sqrt(variance);
  const double half = z_of(confidence) * error;
  return {areas[0], error, std::max(0.0, areas[0] - half), std::min(limit, areas[0] + half)};
}

std::vector<double> restricted_pseudo_values(std::span<const ObservedTime> times, double limit) {
  const auto n = static_cast<double>(times.size());
  const double all = areas_from(kaplan_meier(times), limit)[0];
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return before(times[a], times[b]); });

  // the others in order: one is left out after the other
  std::vector<ObservedTime> others;
  for (std::size_t i = 1; i < order.size(); ++i) others.push_back(times[order[i]]);
  std::vector<double> values(times.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    values[order[i]] = n * all - (n - 1.0) * areas_from(steps_of(others), limit)[0];
    if (i < others.size()) others[i] = times[order[i]];
  }
  return values;
}

}  // namespace fairway
