// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/sampler.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"

namespace fairway {
namespace {

using Kind = TunedParameter::Kind;

constexpr double first_spread = 0.3;     // of the box, in each number
constexpr double last_spread = 1e-3;     // below, nothing new is proposed
constexpr double learning_rate = 0.3;    // of integers and choices, a generation
constexpr double least_share = 0.05;     // every choice keeps being tried
constexpr double least_deviation = 0.5;  // an integer's neighbours keep being tried

/// Where a value lies between the ends of its range, 0 to 1.
double place_of(const TunedParameter& parameter, double value) {
  const auto [lo, hi] = parameter.range;
  const double place =
      parameter.logarithmic ? math::log(value / lo) / math::log(hi / lo) : (value - lo) / (hi - lo);
  return std::clamp(place, 0.0, 1.0);
}

double value_at(const TunedParameter& parameter, double place) {
  const auto [lo, hi] = parameter.range;
  const double value =
      parameter.logarithmic ? lo * math::exp(place * math::log(hi / lo)) : lo + place * (hi - lo);
  return std::clamp(to_six_digits(value), lo, hi);  // what is tried is what is written
}

}  // namespace

Sampler::Sampler(std::vector<TunedParameter> parameters, Rng rng)
    : parameters_{std::move(parameters)}, rng_{rng} {
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    if (parameters_[i].kind == Kind::number) numbers_.push_back(i);
  // as many as if all were numbers: a choice needs trying as well
  population_ = 4 + static_cast<std::size_t>(3.0 * math::log(static_cast<double>(parameters_.size())));
  restart(usual_setting(parameters_));
}

void Sampler::restart(const Setting& setting) {
  if (!numbers_.empty()) {
    Eigen::VectorXd mean(static_cast<Eigen::Index>(numbers_.size()));
    for (std::size_t k = 0; k < numbers_.size(); ++k)
      mean[static_cast<Eigen::Index>(k)] = place_of(parameters_[numbers_[k]], setting[numbers_[k]]);
    cma_.emplace(mean, first_spread);
  }
  discrete_.assign(parameters_.size(), {});
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const TunedParameter& parameter = parameters_[i];
    const double width = parameter.range.hi - parameter.range.lo;
    discrete_[i] = {
        .mean = setting[i], .deviation = std::max(least_deviation, first_spread * width), .shares = {}};
    if (parameter.kind == Kind::choice)
      discrete_[i].shares.assign(parameter.choices.size(),
                                 1.0 / static_cast<double>(parameter.choices.size()));
  }
}

Setting Sampler::ask() {
  Setting setting(parameters_.size());
  if (cma_) {
    const Eigen::VectorXd point = cma_->ask(rng_);
    for (std::size_t k = 0; k < numbers_.size(); ++k)
      setting[numbers_[k]] = value_at(parameters_[numbers_[k]], point[static_cast<Eigen::Index>(k)]);
  }
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    if (parameters_[i].kind != Kind::number) setting[i] = draw(parameters_[i], discrete_[i]);
  return setting;
}

double Sampler::draw(const TunedParameter& parameter, const Discrete& discrete) {
  if (parameter.kind == Kind::integer) {
    const double value = std::round(discrete.mean + discrete.deviation * rng_.normal());
    return std::clamp(value, parameter.range.lo, parameter.range.hi);
  }
  double left = rng_.uniform(0.0, 1.0);
  std::size_t chosen = 0;
  while (chosen + 1 < discrete.shares.size() && left >= discrete.shares[chosen])
    left -= discrete.shares[chosen++];
  return static_cast<double>(chosen);
}

void Sampler::tell(std::span<const Setting> best_first) {
  if (cma_) {
    std::vector<Eigen::VectorXd> points;
    for (const Setting& setting : best_first) {
      Eigen::VectorXd& point = points.emplace_back(static_cast<Eigen::Index>(numbers_.size()));
      for (std::size_t k = 0; k < numbers_.size(); ++k)
        point[static_cast<Eigen::Index>(k)] = place_of(parameters_[numbers_[k]], setting[numbers_[k]]);
    }
    cma_->tell(points);
  }
  const auto better = best_first.first(best_first.size() / 2);
  if (better.empty()) return;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    if (parameters_[i].kind != Kind::number) learn(parameters_[i], discrete_[i], i, better);
}

void Sampler::learn(const TunedParameter& parameter, Discrete& discrete, std::size_t i,
                    std::span<const Setting> better) {
  const double count = static_cast<double>(better.size());
  if (parameter.kind == Kind::choice) {
    std::vector<double> seen(discrete.shares.size(), 0.0);
    for (const Setting& setting : better) seen[static_cast<std::size_t>(setting[i])] += 1.0 / count;
    double sum = 0.0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      double& share = discrete.shares[k];
      share = std::max(least_share, (1.0 - learning_rate) * share + learning_rate * seen[k]);
      sum += share;
    }
    for (double& share : discrete.shares) share /= sum;
    return;
  }
  double mean = 0.0;
  for (const Setting& setting : better) mean += setting[i] / count;
  double variance = 0.0;
  for (const Setting& setting : better) variance += (setting[i] - mean) * (setting[i] - mean) / count;
  discrete.mean += learning_rate * (mean - discrete.mean);
  const double deviation = discrete.deviation + learning_rate * (std::sqrt(variance) - discrete.deviation);
  discrete.deviation = std::max(least_deviation, deviation);
}

bool Sampler::has_converged() const { return cma_ && cma_->spread() < last_spread; }

}  // namespace fairway
