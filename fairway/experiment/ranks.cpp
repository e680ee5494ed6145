// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/ranks.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// The sum of t^3 - t over groups of t equal ranks.
double tie_sum(std::vector<double> ranks) {
  std::ranges::sort(ranks);
  double sum = 0.0;
  for (std::size_t i = 0, j = 0; i < ranks.size(); i = j) {
    while (j < ranks.size() && ranks[j] == ranks[i]) ++j;
    const auto tied = static_cast<double>(j - i);
    sum += tied * tied * tied - tied;
  }
  return sum;
}

/// The probability that the range of `count` standard normal variables is below q: count times the integral
/// of phi(z) (Phi(z) - Phi(z - q))^(count - 1) over z, the largest of them, by Simpson's rule.
double range_cdf(double q, std::size_t count) {
  constexpr int parts = 400;
  constexpr double low = -8.0, high = 8.0;
  constexpr double step = (high - low) / parts;
  const boost::math::normal normal;
  double sum = 0.0;
  for (int i = 0; i <= parts; ++i) {
    const double z = low + step * i;
    const double between = boost::math::cdf(normal, z) - boost::math::cdf(normal, z - q);
    const double weight = i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * boost::math::pdf(normal, z) * math::power(between, static_cast<int>(count) - 1);
  }
  return static_cast<double>(count) * sum * step / 3.0;
}

}  // namespace

std::vector<double> ranks_of(std::span<const double> values) {
  if (std::ranges::any_of(values, [](double value) { return std::isnan(value); }))
    throw std::domain_error("what is not a number has no rank");
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0, j = 0; i < order.size(); i = j) {
    while (j < order.size() && values[order[j]] == values[order[i]]) ++j;
    for (std::size_t k = i; k < j; ++k) ranks[order[k]] = 0.5 * static_cast<double>(i + 1 + j);
  }
  return ranks;
}

FriedmanTest friedman_test(std::span<const std::vector<double>> blocks) {
  FriedmanTest test{.blocks = blocks.size(), .mean_ranks = {}};
  if (blocks.empty()) return test;
  const std::size_t treatments = blocks.front().size();
  if (treatments < 2) throw std::invalid_argument("one treatment alone has no rank");
  std::vector<double> sums(treatments);
  double ties = 0.0;
  for (const std::vector<double>& block : blocks) {
    if (block.size() != treatments) throw std::invalid_argument("blocks of different lengths");
    const std::vector<double> ranks = ranks_of(block);
    for (std::size_t j = 0; j < treatments; ++j) sums[j] += ranks[j];
    ties += tie_sum(ranks);
  }
  const auto n = static_cast<double>(blocks.size()), k = static_cast<double>(treatments);
  double spread = 0.0;
  for (const double sum : sums) {
    const double off = sum - n * (k + 1.0) / 2.0;
    spread += off * off;
    test.mean_ranks.push_back(sum / n);
  }
  const double scale = n * k * (k + 1.0) - ties / (k - 1.0);
  if (scale <= 0.0) return test;
  test.statistic = 12.0 * spread / scale;
  test.p = boost::math::cdf(complement(boost::math::chi_squared{k - 1.0}, test.statistic));
  return test;
}

double range_quantile(double p, std::size_t count) {
  if (!(p > 0.0 && p < 1.0) || count < 2) throw std::domain_error("no such quantile of a range");
  double low = 0.0, high = 50.0;
  while (high - low > 1e-8) {
    const double middle = 0.5 * (low + high);
    (range_cdf(middle, count) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double nemenyi_difference(std::size_t treatments, std::size_t blocks, double alpha) {
  const auto k = static_cast<double>(treatments), n = static_cast<double>(blocks);
  return range_quantile(1.0 - alpha, treatments) / std::sqrt(2.0) * std::sqrt(k * (k + 1.0) / (6.0 * n));
}

}  // namespace fairway
