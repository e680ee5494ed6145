// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fairway/metrics/measure.hpp"

namespace fairway {

/// What one run says of a method, in the order of what counts.
struct Outcome {
  bool is_safe{};    ///< no two vehicles came within the safety distance, and none touched an obstacle
  double arrived{};  ///< share of the vehicles that arrived
  double time_s{};   ///< mean time under way of the vehicles; of those that did not arrive as far as it went
};

/// Of a run that failed: unsafe, nobody arrived, and there is no time.
Outcome failed_outcome();

Outcome outcome_of(std::span<const Measure> measures);

/// Outcomes in blocks: a seed after the other, and under each seed every scenario.
using Outcomes = std::vector<Outcome>;

/// What outcomes come to. Times are relative to those of `usual`, run by run, because scenarios differ in
/// length; a time that is not known in either is left out.
struct Score {
  std::size_t runs{};
  std::size_t unsafe{};
  double arrived{};     ///< mean share
  double time_ratio{};  ///< mean of time over usual time; NaN of none
};

/// Of the first runs that both have.
Score score_of(std::span<const Outcome> outcomes, std::span<const Outcome> usual);

/// Whether `a` is better than `b` over as many runs: fewer unsafe runs, then more arrivals, then less time.
/// Fewer unsafe runs are a higher lower bound of the collision-free rate, since the runs are as many.
bool is_better(const Score& a, const Score& b);

/// Whether `b` gives up nothing of what `a` has, and is better in something.
bool is_dominated(const Score& a, const Score& b);

/// Whether the runs show that `a` is worse than `b`: at the first of safety, arrivals and time in which they
/// differ beyond chance (exact McNemar; Student's t of the paired differences), over the first runs of both,
/// in blocks of `scenarios`. An 0.05 test that is asked again and again: it saves runs and proves nothing.
bool is_beaten(std::span<const Outcome> a, std::span<const Outcome> b, std::size_t scenarios);

/// The mean of the known values of each block of `scenarios`; NaN where none is known.
std::vector<double> block_means(std::span<const double> values, std::size_t scenarios);

/// Time over usual time of each run; NaN where one is not known.
std::vector<double> time_ratios(std::span<const Outcome> outcomes, std::span<const Outcome> usual);

}  // namespace fairway
