// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/experiment/statistics.hpp"

namespace fairway {

/// What the numbers make of a claim of the publication.
enum class Standing {
  holds,
  does_not_hold,
  reversed,      ///< a comparison came out the other way round
  undecided,     ///< the 95 % intervals overlap, or the numbers are equal
  not_measured,  ///< a number that it takes is missing
};
std::string_view name_of(Standing standing);

/// The number of one run in which nothing is drawn: an estimate without a spread.
MeanEstimate exactly(double value);

/// "`a` is less than `b`". Of an estimate without an interval (a single run of something random) or of no
/// values at all nothing is said.
Standing is_less(const MeanEstimate& a, const MeanEstimate& b);

/// "All of them are so": `count` of `total` are.
Standing all_are(std::size_t count, std::size_t total);

/// The claim, what the numbers make of it, and the numbers: "\"...\": holds (3 s against 5 s)." Of what was
/// not measured the numbers are left out.
std::string stated(std::string_view claim, Standing standing, std::string_view numbers);

}  // namespace fairway
