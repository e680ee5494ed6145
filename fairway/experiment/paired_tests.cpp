// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/paired_tests.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

#include "fairway/experiment/special_numbers.hpp"
#include "fairway/experiment/statistics.hpp"

namespace fairway {
namespace {

using special::infinity;
using special::nan;

double normal_above(double z) { return cdf(boost::math::complement(boost::math::normal{}, z)); }

/// The probability of each value of the signed rank statistic of n differences without ties: rank by rank,
/// each is positive in half of the cases.
std::vector<double> signed_rank_distribution(std::size_t n) {
  std::vector<double> chance(n * (n + 1) / 2 + 1, 0.0);
  chance[0] = 1.0;
  for (std::size_t rank = 1; rank <= n; ++rank) {
    for (std::size_t sum = rank * (rank + 1) / 2 + 1; sum-- > 0;)
      chance[sum] = 0.5 * (chance[sum] + (sum >= rank ? chance[sum - rank] : 0.0));
  }
  return chance;
}

/// How many of n (n + 1) / 2 Walsh averages lie beyond each end of the interval; 0 where none may.
std::size_t averages_beyond(std::size_t n, double beyond) {
  if (n <= most_exact_pairs) {
    double below = 0.0;
    std::size_t places = 0;
    for (const double chance : signed_rank_distribution(n)) {
      below += chance;
      if (below > beyond) break;
      ++places;
    }
    return places;
  }
  const auto m = static_cast<double>(n);
  const double z = quantile(boost::math::complement(boost::math::normal{}, beyond));
  const double place = m * (m + 1.0) / 4.0 - z * std::sqrt(m * (m + 1.0) * (2.0 * m + 1.0) / 24.0);
  return static_cast<std::size_t>(std::max(0.0, std::floor(place)));
}

/// How many Walsh averages of sorted values are at most `limit`.
std::size_t averages_up_to(const std::vector<double>& sorted, double limit) {
  std::size_t count = 0;
  std::size_t end = sorted.size();
  for (std::size_t i = 0; i < end; ++i) {
    while (end > i && 0.5 * (sorted[i] + sorted[end - 1]) > limit) --end;
    count += end - i;
  }
  return count;
}

/// The k-th smallest Walsh average of sorted values, from 1: the least number that so many do not exceed.
double walsh_average(const std::vector<double>& sorted, std::size_t k) {
  double low = sorted.front();
  double high = sorted.back();
  if (averages_up_to(sorted, low) >= k) return low;
  while (true) {
    const double middle = std::midpoint(low, high);
    if (middle <= low || middle >= high) return high;
    (averages_up_to(sorted, middle) >= k ? high : low) = middle;
  }
}

/// Ranks of what differs from 0, by size and with those of ties shared.
struct SignedRanks {
  std::size_t count{};
  double positive{};  ///< sum of their ranks
  double tied{};      ///< sum of t³ - t over ties of t
  bool zeros{};
};

SignedRanks ranks_of(std::span<const double> differences, double grain) {
  std::vector<double> nonzero;
  for (const double d : differences) {
    if (std::abs(d) > grain) nonzero.push_back(d);
  }
  std::sort(nonzero.begin(), nonzero.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });

  SignedRanks ranks{.count = nonzero.size(), .zeros = nonzero.size() < differences.size()};
  for (std::size_t begin = 0; begin < nonzero.size();) {
    std::size_t end = begin + 1;
    while (end < nonzero.size() && std::abs(nonzero[end]) - std::abs(nonzero[begin]) <= grain) ++end;
    const auto tie = static_cast<double>(end - begin);
    const double rank = 0.5 * static_cast<double>(begin + 1 + end);
    for (std::size_t i = begin; i < end; ++i) ranks.positive += nonzero[i] > 0.0 ? rank : 0.0;
    ranks.tied += tie * tie * tie - tie;
    begin = end;
  }
  return ranks;
}

/// Twice the chance of a statistic as far out as this one.
double exact_p(const SignedRanks& ranks) {
  const std::vector<double> chance = signed_rank_distribution(ranks.count);
  // the distribution is symmetric
  const double total = static_cast<double>(chance.size() - 1);
  const auto nearer = static_cast<std::size_t>(std::min(ranks.positive, total - ranks.positive));
  return std::min(1.0,
                  2.0 * std::accumulate(chance.begin(), chance.begin() + 1 + static_cast<long>(nearer), 0.0));
}

double normal_p(const SignedRanks& ranks) {
  const auto n = static_cast<double>(ranks.count);
  const double off = ranks.positive - n * (n + 1.0) / 4.0;
  const double deviation = std::sqrt(n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ranks.tied / 48.0);
  return std::min(1.0, 2.0 * normal_above(std::max(0.0, std::abs(off) - 0.5) / deviation));
}

/// Twice the chance that a fair coin falls as one-sidedly.
double coin_p(std::size_t a, std::size_t b) {
  if (a + b == 0) return 1.0;
  const boost::math::binomial coin{static_cast<double>(a + b), 0.5};
  return std::min(1.0, 2.0 * cdf(coin, static_cast<double>(std::min(a, b))));
}

}  // namespace

MedianEstimate hodges_lehmann(std::span<const double> differences, double confidence) {
  const double beyond = tail_of(confidence);
  if (differences.empty() || !std::ranges::all_of(differences, [](double x) { return std::isfinite(x); }))
    return {nan, -infinity, infinity};

  std::vector<double> sorted(differences.begin(), differences.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t averages = sorted.size() * (sorted.size() + 1) / 2;
  const double below = walsh_average(sorted, (averages + 1) / 2);
  const double above = averages % 2 == 1 ? below : walsh_average(sorted, averages / 2 + 1);
  MedianEstimate estimate{std::midpoint(below, above), -infinity, infinity};

  const std::size_t place = averages_beyond(sorted.size(), beyond);
  if (place == 0) return estimate;
  estimate.low = walsh_average(sorted, place);
  estimate.high = walsh_average(sorted, averages + 1 - place);
  return estimate;
}

PairedTest signed_rank_test(std::span<const double> differences, double grain) {
  const SignedRanks ranks = ranks_of(differences, grain);
  PairedTest test{.pairs = ranks.count, .statistic = ranks.positive, .p = 1.0, .effect = 0.0, .exact = true};
  if (ranks.count == 0) return test;
  const auto n = static_cast<double>(ranks.count);
  test.exact = ranks.count <= most_exact_pairs && !ranks.zeros && ranks.tied == 0.0;
  test.p = test.exact ? exact_p(ranks) : normal_p(ranks);
  test.effect = 4.0 * ranks.positive / (n * (n + 1.0)) - 1.0;
  return test;
}

PairedTest sign_test(std::size_t more, std::size_t less) {
  const auto a = static_cast<double>(more);
  const auto b = static_cast<double>(less);
  return {.pairs = more + less,
          .statistic = a,
          .p = coin_p(more, less),
          .effect = more + less == 0 ? 0.0 : (a - b) / (a + b),
          .exact = true};
}

PairedTest mcnemar_test(const PairedAnswers& answers) {
  PairedTest test = sign_test(answers.first, answers.second);
  test.effect /= 2.0;
  return test;
}

RateDifference paired_rate_difference(const PairedAnswers& answers, double confidence) {
  const std::size_t pairs = answers.both + answers.first + answers.second + answers.neither;
  const RateEstimate one = wilson_interval(answers.both + answers.first, pairs, confidence);
  const RateEstimate two = wilson_interval(answers.both + answers.second, pairs, confidence);
  if (pairs == 0) return {.pairs = 0, .difference = nan, .low = -1.0, .high = 1.0};

  const auto n = static_cast<double>(pairs);
  const auto both = static_cast<double>(answers.both);
  const auto neither = static_cast<double>(answers.neither);
  const double product = static_cast<double>(one.successes) * (n - static_cast<double>(one.successes)) *
                         static_cast<double>(two.successes) * (n - static_cast<double>(two.successes));
  double joint = both * neither - static_cast<double>(answers.first) * static_cast<double>(answers.second);
  if (joint > 0.0) joint = std::max(0.0, joint - n / 2.0);
  const double correlation = product > 0.0 ? joint / std::sqrt(product) : 0.0;
  const auto joined = [&](double a, double b) {
    return std::sqrt(a * a - 2.0 * correlation * a * b + b * b);
  };

  const double difference = one.rate - two.rate;
  return {.pairs = pairs,
          .difference = difference,
          .low = std::max(-1.0, difference - joined(one.rate - one.low, two.high - two.rate)),
          .high = std::min(1.0, difference + joined(one.high - one.rate, two.rate - two.low))};
}

std::vector<double> holm_adjusted(std::span<const double> p) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!std::isnan(p[i])) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.begin(), p.end());
  double least = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    least = std::max(least, std::min(1.0, static_cast<double>(order.size() - k) * p[order[k]]));
    adjusted[order[k]] = least;
  }
  return adjusted;
}

}  // namespace fairway
