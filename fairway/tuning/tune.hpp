// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fairway/experiment/paired_tests.hpp"
#include "fairway/experiment/statistics.hpp"
#include "fairway/tuning/score.hpp"
#include "fairway/tuning/trial_runs.hpp"
#include "fairway/tuning/tuning_file.hpp"

namespace fairway {

/// How a setting did on one set of runs, and against the method as it was written.
struct Appraisal {
  std::size_t runs{};
  RateEstimate collision_free;
  MeanEstimate arrived;             ///< share of vehicles, a block's mean being one value
  MeanEstimate time_s;              ///< likewise
  RateDifference safer;             ///< collision-free rate less that of the method as written, run by run
  double safer_p{1.0};              ///< exact McNemar
  MeanEstimate arrived_difference;  ///< share of vehicles less that of the method as written; by blocks
  MeanEstimate time_difference;     ///< relative to the method as written: -0.2 is a fifth less; by blocks
  int arrived_sign{};               ///< of that difference where it is shown as one of three at 95 %, else 0
  int time_sign{};                  ///< likewise
};

/// What is shown of a setting beside the method as written, at 95 % for the three questions together (each at
/// a third of 5 %): the first of safety, arrival and time in which there is a difference. Who is safer may be
/// slower.
enum class Shown { nothing, safer, less_safe, more_arrive, fewer_arrive, quicker, slower };
Shown shown_by(const Appraisal& appraisal);

/// One point of the way that a search went: the champion after so many runs.
struct TuningStep {
  std::size_t runs{};
  Score score;
};

/// What the result is with one parameter as the method has it.
struct Ablation {
  std::string parameter;
  Appraisal appraisal;  ///< on the validation set, against the result itself
};

struct TuningResult {
  Setting best;
  bool is_usual{};  ///< nothing better than the method as written was found
  std::size_t budget{};
  std::size_t runs{};  ///< spent of the budget
  std::size_t generations{};
  std::size_t tried{};  ///< settings
  Appraisal train, validation, test;
  Appraisal usual_train, usual_validation, usual_test;
  MeanEstimate luck;           ///< how much less time was saved on test than on train: of the gain, luck
  RateDifference safety_luck;  ///< likewise of the collision-free rate: how much less was gained on test
  std::vector<TuningStep> curve;
  std::vector<std::pair<Setting, Score>> front;  ///< of those who ran the whole course, none better in all
  std::vector<Ablation> ablations;
};

struct TuneOptions {
  std::size_t budget{};   ///< runs to train with
  std::uint64_t seed{1};  ///< of the search itself
  Progress* progress{};   ///< told of runs to train with; may be null
};

/// The least budget for a specification: the method as written on all of train, and one generation as far as
/// its first appraisal. A space of fewer settings than a generation has makes a smaller one.
std::size_t least_budget(const TuningFile& tuning);

/// Throws InputError for a budget below it.
void refuse_small_budget(const TuningFile& tuning, std::size_t budget);

/// Searches by racing generations of settings, and judges what it found on runs that it never saw. Of a space
/// of at most a hundred settings it tries every one, once, and ends when that is done. The same
/// specification, budget and seed come to the same result on any number of threads, and go on from where they
/// were stopped. Throws as refuse_small_budget(), RunAbandoned if stopped.
TuningResult tune(const TuningFile& tuning, TrialRuns& runs, const TuneOptions& options);

}  // namespace fairway
