// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fairway/experiment/special_numbers.hpp"

namespace fairway {
namespace {

using special::infinity;
using special::nan;

RateEstimate rate_of(std::size_t successes, std::size_t trials) {
  if (successes > trials) throw std::invalid_argument("more successes than trials");
  const double rate = trials == 0 ? nan : static_cast<double>(successes) / static_cast<double>(trials);
  return {.successes = successes, .trials = trials, .rate = rate, .low = 0.0, .high = 1.0};
}

}  // namespace

double tail_of(double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::domain_error("a confidence of " + std::to_string(confidence) + " is not between 0 and 1");
  }
  return (1.0 - confidence) / 2.0;
}

MeanEstimate estimate_mean(std::span<const double> values, double confidence) {
  const double beyond = tail_of(confidence);
  const std::size_t count = values.size();
  if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); })) {
    return {.count = count, .mean = nan, .deviation = nan, .low = nan, .high = nan};
  }
  if (count == 0) return {.count = 0, .mean = nan, .deviation = nan, .low = -infinity, .high = infinity};
  if (count == 1)
    return {.count = 1, .mean = values[0], .deviation = nan, .low = -infinity, .high = infinity};

  // about the first value, so that equal values have exactly that mean and no deviation
  const auto n = static_cast<double>(count);
  double sum = 0.0;
  for (const double x : values) sum += x - values[0];
  const double mean = values[0] + sum / n;

  // in two passes, less what rounding left in the mean (Chan, Golub and LeVeque 1983, equation 1.7)
  double squares = 0.0;
  double rest = 0.0;
  for (const double x : values) {
    squares += (x - mean) * (x - mean);
    rest += x - mean;
  }
  const double deviation = std::sqrt(std::max(0.0, squares - rest * rest / n) / (n - 1.0));

  const boost::math::students_t student{n - 1.0};
  const double half = quantile(boost::math::complement(student, beyond)) * deviation / std::sqrt(n);
  return {.count = count, .mean = mean, .deviation = deviation, .low = mean - half, .high = mean + half};
}

MeanEstimate paired_difference(std::span<const double> a, std::span<const double> b, double confidence) {
  if (a.size() != b.size()) throw std::invalid_argument("pairs need as many values on either side");
  std::vector<double> differences(a.size());
  std::transform(a.begin(), a.end(), b.begin(), differences.begin(), std::minus<>{});
  return estimate_mean(differences, confidence);
}

RateEstimate wilson_interval(std::size_t successes, std::size_t trials, double confidence) {
  const double z = quantile(boost::math::complement(boost::math::normal{}, tail_of(confidence)));
  RateEstimate estimate = rate_of(successes, trials);
  if (trials == 0) return estimate;

  // (p + z²/2n ± z sqrt(p(1-p)/n + z²/4n²)) / (1 + z²/n)
  const auto n = static_cast<double>(trials);
  const double p = estimate.rate;
  const double centre = p + z * z / (2.0 * n);
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  const double scale = 1.0 + z * z / n;
  // the ends are exact where rounding would leave a crumb
  estimate.low = successes == 0 ? 0.0 : (centre - half) / scale;
  estimate.high = successes == trials ? 1.0 : (centre + half) / scale;
  return estimate;
}

double fisher_exact(std::size_t first_successes, std::size_t first_trials, std::size_t second_successes,
                    std::size_t second_trials) {
  if (first_successes > first_trials || second_successes > second_trials)
    throw std::invalid_argument("more successes than trials");
  const auto ln_choose = [](std::size_t n, std::size_t k) {
    const auto ln_factorial = [](std::size_t m) { return boost::math::lgamma(static_cast<double>(m) + 1.0); };
    return ln_factorial(n) - ln_factorial(k) - ln_factorial(n - k);
  };
  const std::size_t successes = first_successes + second_successes;
  const auto ln_weight = [&](std::size_t k) {
    return ln_choose(first_trials, k) + ln_choose(second_trials, successes - k);
  };

  // as likely within rounding counts as likely
  constexpr double alike = 1e-7;
  const double here = ln_weight(first_successes);
  double all = 0.0, as_unlikely = 0.0;
  const std::size_t least = successes > second_trials ? successes - second_trials : 0;
  for (std::size_t k = least; k <= std::min(first_trials, successes); ++k) {
    const double weight = std::exp(ln_weight(k) - here);
    all += weight;
    if (weight <= 1.0 + alike) as_unlikely += weight;
  }
  return as_unlikely / all;
}

CountEstimate poisson_interval(double count, double confidence) {
  if (!(count >= 0.0)) throw std::invalid_argument("a negative count");
  const double beyond = tail_of(confidence);
  CountEstimate estimate{.count = count};
  if (count > 0.0) estimate.low = quantile(boost::math::chi_squared{2.0 * count}, beyond) / 2.0;
  estimate.high =
      quantile(boost::math::complement(boost::math::chi_squared{2.0 * count + 2.0}, beyond)) / 2.0;
  return estimate;
}

double quantile(std::span<const double> sorted, double p) {
  if (!(p >= 0.0 && p <= 1.0))
    throw std::domain_error("a quantile's p of " + std::to_string(p) + " is not in [0, 1]");
  if (sorted.empty()) return nan;
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

BoxSummary summarize(std::vector<double> values) {
  if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); })) {
    throw std::domain_error("a box plot of values that are not finite");
  }
  if (values.empty()) return {0, nan, nan, nan, nan, nan, nan, nan, {}};
  std::sort(values.begin(), values.end());

  BoxSummary box{.count = values.size(),
                 .min = values.front(),
                 .lower_quartile = quantile(values, 0.25),
                 .median = quantile(values, 0.5),
                 .upper_quartile = quantile(values, 0.75),
                 .max = values.back()};
  const double reach = 1.5 * (box.upper_quartile - box.lower_quartile);
  const auto first =
      std::find_if(values.begin(), values.end(), [&](double x) { return x >= box.lower_quartile - reach; });
  const auto last =
      std::find_if(values.rbegin(), values.rend(), [&](double x) { return x <= box.upper_quartile + reach; });
  box.low_whisker = *first;
  box.high_whisker = *last;
  box.outliers.assign(values.begin(), first);
  box.outliers.insert(box.outliers.end(), last.base(), values.end());
  return box;
}

}  // namespace fairway
