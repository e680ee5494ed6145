// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/tune.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "fairway/core/math.hpp"
#include "fairway/tuning/race.hpp"
#include "fairway/tuning/sampler.hpp"

namespace fairway {
namespace {

constexpr int most_asks = 50;                  // for a setting that was not tried yet
constexpr std::size_t least_learnt_of = 4;     // CMA-ES is told of so many at least
constexpr std::size_t most_tried_whole = 100;  // settings: on five seeds each they cost 500 runs

/// Whether the method as it is written is one of the settings that are searched.
bool has_usual(const std::vector<TunedParameter>& parameters) {
  return std::ranges::all_of(parameters, &std::string::empty, &TunedParameter::beyond);
}

/// Every setting besides that of the method itself, of a space that is small enough to try them all; none of
/// a larger one.
std::vector<Setting> few_settings(const std::vector<TunedParameter>& parameters) {
  std::vector<Setting> settings = all_settings(parameters, most_tried_whole);
  if (has_usual(parameters)) std::erase(settings, usual_setting(parameters));
  return settings;
}

/// How many settings a generation has, of whom `few` were to be tried and `tried` are.
std::size_t generation_of(const Sampler& sampler, const std::vector<Setting>& few, std::size_t tried) {
  return few.empty() ? sampler.population() : std::min(sampler.population(), few.size() - tried);
}

std::vector<double> values_of(std::span<const Outcome> outcomes, double Outcome::*value) {
  std::vector<double> values;
  for (const Outcome& outcome : outcomes) values.push_back(outcome.*value);
  return values;
}

/// The mean over blocks of which something is known.
MeanEstimate mean_of_blocks(const std::vector<double>& values, std::size_t scenarios,
                            double confidence = 0.95) {
  std::vector<double> known = block_means(values, scenarios);
  std::erase_if(known, [](double value) { return !std::isfinite(value); });
  return estimate_mean(known, confidence);
}

constexpr double one_of_three = 0.05 / 3.0;  // Bonferroni's, of the questions of shown_by()

/// Which way a mean is off zero for sure.
int sign_of(const MeanEstimate& mean) { return mean.low > 0.0 ? 1 : mean.high < 0.0 ? -1 : 0; }

Appraisal appraised(std::span<const Outcome> outcomes, std::span<const Outcome> reference,
                    std::size_t scenarios) {
  PairedAnswers safe;
  std::size_t safe_runs = 0;
  std::vector<double> longer = time_ratios(outcomes, reference);
  for (double& ratio : longer) ratio -= 1.0;
  std::vector<double> more_arrived = values_of(outcomes, &Outcome::arrived);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    more_arrived[i] -= reference[i].arrived;
    const bool first = outcomes[i].is_safe, second = reference[i].is_safe;
    safe_runs += first ? 1 : 0;
    ++(first ? (second ? safe.both : safe.first) : (second ? safe.second : safe.neither));
  }
  return {.runs = outcomes.size(),
          .collision_free = wilson_interval(safe_runs, outcomes.size()),
          .arrived = mean_of_blocks(values_of(outcomes, &Outcome::arrived), scenarios),
          .time_s = mean_of_blocks(values_of(outcomes, &Outcome::time_s), scenarios),
          .safer = paired_rate_difference(safe),
          .safer_p = mcnemar_test(safe).p,
          .arrived_difference = mean_of_blocks(more_arrived, scenarios),
          .time_difference = mean_of_blocks(longer, scenarios),
          .arrived_sign = sign_of(mean_of_blocks(more_arrived, scenarios, 1.0 - one_of_three)),
          .time_sign = sign_of(mean_of_blocks(longer, scenarios, 1.0 - one_of_three))};
}

/// The difference of two independent means, by the normal approximation.
MeanEstimate difference_of(const MeanEstimate& a, const MeanEstimate& b) {
  const auto square_error = [](const MeanEstimate& m) {
    return m.deviation * m.deviation / static_cast<double>(m.count);
  };
  constexpr double z = 1.959963984540054;  // of 95 %
  const double error = std::sqrt(square_error(a) + square_error(b));
  const double difference = a.mean - b.mean;
  return {.count = std::min(a.count, b.count),
          .mean = difference,
          .deviation = error,
          .low = difference - z * error,
          .high = difference + z * error};
}

/// The difference of two independent differences, by the distances to the ends of their intervals (Zou and
/// Donner 2008, Statistics in Medicine 27, 1693-1702).
RateDifference difference_of(const RateDifference& a, const RateDifference& b) {
  const double difference = a.difference - b.difference;
  const double below = math::hypot(a.difference - a.low, b.high - b.difference);
  const double above = math::hypot(a.high - a.difference, b.difference - b.low);
  return {.pairs = std::min(a.pairs, b.pairs),
          .difference = difference,
          .low = difference - below,
          .high = difference + above};
}

/// The search, from the method as written on.
class Search {
 public:
  Search(const TuningFile& tuning, TrialRuns& runs, const TuneOptions& options)
      : tuning_{tuning},
        runs_{runs},
        options_{options},
        sampler_{tuning.parameters, Rng{options.seed}.stream("tuning")},
        few_{few_settings(tuning.parameters)},
        left_{options.budget} {
    if (!few_.empty() && has_usual(tuning.parameters)) tried_.insert(usual_setting(tuning.parameters));
  }

  TuningResult run() {
    if (options_.progress != nullptr) options_.progress->begin(count());
    usual_ = champion_ = whole_course({tuning_.method}).front();
    left_ -= usual_.size();
    if (options_.progress != nullptr) options_.progress->update(count());
    remember(result_.best, usual_);
    while (left_ >= generation() * least_train_seeds * scenarios() && next_generation()) {
    }
    if (options_.progress != nullptr) options_.progress->end(count());
    result_.budget = options_.budget;
    result_.runs = options_.budget - left_;
    result_.is_usual = result_.best.empty();
    if (result_.is_usual) result_.best = usual_setting(tuning_.parameters);
    judge();
    return std::move(result_);
  }

 private:
  std::size_t scenarios() const { return tuning_.train.scenarios.size(); }
  std::size_t generation() const { return generation_of(sampler_, few_, result_.tried); }
  ProgressCount count() const { return {.total = options_.budget, .made = options_.budget - left_}; }

  /// A setting as the campaign's machinery takes it; none is the method as written.
  CampaignAlgorithm method_with(const Setting& setting) const {
    if (setting.empty()) return tuning_.method;
    std::string label = tuning_.method.label;
    for (std::size_t i = 0; i < setting.size(); ++i)
      label += " " + tuning_.parameters[i].name + "=" + value_text(tuning_.parameters[i], setting[i]);
    return {.label = label, .avoider = avoider_text(tuning_.method.avoider, tuning_.parameters, setting)};
  }

  std::vector<Outcomes> whole_course(const std::vector<CampaignAlgorithm>& methods) {
    return runs_.outcomes(methods, tuning_.train, 0, tuning_.train.seed_count);
  }

  /// Settings that nobody has tried; fewer where the sampler comes up with none and they are not few enough
  /// to go through.
  std::vector<Contender> newcomers() {
    std::vector<Contender> contenders;
    const auto take = [&](const Setting& setting) {
      if (tried_.insert(setting).second) contenders.push_back({.setting = setting});
    };
    const std::size_t wanted = generation();
    for (int asked = 0; asked < most_asks && contenders.size() < wanted; ++asked) take(sampler_.ask());
    for (auto next = few_.begin(); next != few_.end() && contenders.size() < wanted; ++next) take(*next);
    return contenders;
  }

  /// False where there is nothing new to try.
  bool next_generation() {
    std::vector<Contender> contenders = newcomers();
    if (contenders.size() < (few_.empty() ? least_learnt_of : 1)) return false;
    result_.tried += contenders.size();
    ++result_.generations;
    const RaceCourse course{
        .scenarios = scenarios(), .blocks = tuning_.train.seed_count, .step = least_train_seeds};
    const auto run = [&](const std::vector<Setting>& settings, std::size_t first, std::size_t blocks) {
      std::vector<CampaignAlgorithm> methods;
      for (const Setting& setting : settings) methods.push_back(method_with(setting));
      std::vector<Outcomes> outcomes = runs_.outcomes(methods, tuning_.train, first, blocks);
      if (options_.progress != nullptr) options_.progress->update(count());
      return outcomes;
    };
    contenders = race(std::move(contenders), champion_, usual_, course, run, left_);
    std::vector<Setting> order;
    for (const Contender& contender : contenders) order.push_back(contender.setting);
    sampler_.tell(order);
    for (const Contender& contender : contenders)
      if (contender.outcomes.size() == usual_.size()) remember(contender.setting, contender.outcomes);
    result_.curve.push_back({.runs = options_.budget - left_, .score = score_of(champion_, usual_)});
    if (sampler_.has_converged())
      sampler_.restart(result_.best.empty() ? usual_setting(tuning_.parameters) : result_.best);
    return true;
  }

  /// Of whoever ran the whole course: whether it is the new champion, and its place on the front.
  void remember(const Setting& setting, const Outcomes& outcomes) {
    const Score score = score_of(outcomes, usual_);
    if (result_.curve.empty()) result_.curve.push_back({.runs = usual_.size(), .score = score});
    if (is_better(score, score_of(champion_, usual_))) {
      champion_ = outcomes;
      result_.best = setting;
    }
    const auto dominates = [&](const auto& other) { return is_dominated(score, other.second); };
    if (std::ranges::any_of(result_.front, dominates)) return;
    std::erase_if(result_.front, [&](const auto& other) { return is_dominated(other.second, score); });
    result_.front.emplace_back(setting.empty() ? usual_setting(tuning_.parameters) : setting, score);
  }

  /// What was found and the method as written, on the runs that the search did not see.
  void judge() {
    const CampaignAlgorithm best = result_.is_usual ? tuning_.method : method_with(result_.best);
    result_.train = appraised(champion_, usual_, scenarios());
    result_.usual_train = appraised(usual_, usual_, scenarios());
    const auto judge_on = [&](const TuningSet& set, Appraisal& found, Appraisal& usual) {
      const Outcomes reference = runs_.outcomes({tuning_.method}, set, 0, set.seed_count).front();
      Outcomes outcomes =
          result_.is_usual ? reference : runs_.outcomes({best}, set, 0, set.seed_count).front();
      found = appraised(outcomes, reference, set.scenarios.size());
      usual = appraised(reference, reference, set.scenarios.size());
      return outcomes;
    };
    const Outcomes seen = judge_on(tuning_.validation, result_.validation, result_.usual_validation);
    judge_on(tuning_.test, result_.test, result_.usual_test);
    result_.luck = difference_of(result_.test.time_difference, result_.train.time_difference);
    result_.safety_luck = difference_of(result_.train.safer, result_.test.safer);
    if (!result_.is_usual) ablate(seen);
  }

  void ablate(const Outcomes& whole) {
    const TuningSet& set = tuning_.validation;
    for (std::size_t i = 0; i < tuning_.parameters.size(); ++i) {
      Setting without = result_.best;
      without[i] = tuning_.parameters[i].usual;
      if (without == result_.best) continue;
      const Outcomes outcomes = runs_.outcomes({method_with(without)}, set, 0, set.seed_count).front();
      result_.ablations.push_back(
          {tuning_.parameters[i].name, appraised(outcomes, whole, set.scenarios.size())});
    }
  }

  const TuningFile& tuning_;
  TrialRuns& runs_;
  const TuneOptions& options_;
  Sampler sampler_;
  std::vector<Setting> few_;  ///< all that there are to try, where they are few
  std::size_t left_;
  std::set<Setting> tried_;
  Outcomes usual_;     ///< of the method as written
  Outcomes champion_;  ///< of the best so far
  TuningResult result_;
};

}  // namespace

Shown shown_by(const Appraisal& appraisal) {
  if (appraisal.safer_p < one_of_three)
    return appraisal.safer.difference > 0.0 ? Shown::safer : Shown::less_safe;
  if (appraisal.arrived_sign != 0)
    return appraisal.arrived_sign > 0 ? Shown::more_arrive : Shown::fewer_arrive;
  if (appraisal.time_sign != 0) return appraisal.time_sign < 0 ? Shown::quicker : Shown::slower;
  return Shown::nothing;
}

std::size_t least_budget(const TuningFile& tuning) {
  const Sampler sampler{tuning.parameters, Rng{0}};
  const std::size_t generation = generation_of(sampler, few_settings(tuning.parameters), 0);
  return tuning.train.runs() + generation * least_train_seeds * tuning.train.scenarios.size();
}

void refuse_small_budget(const TuningFile& tuning, std::size_t budget) {
  if (budget < least_budget(tuning))
    throw InputError("a budget of " + std::to_string(budget) + " runs is too small to race; this needs " +
                     std::to_string(least_budget(tuning)) + " to judge one generation");
}

TuningResult tune(const TuningFile& tuning, TrialRuns& runs, const TuneOptions& options) {
  refuse_small_budget(tuning, options.budget);
  return Search{tuning, runs, options}.run();
}

}  // namespace fairway
