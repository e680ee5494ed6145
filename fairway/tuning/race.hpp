// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fairway/tuning/parameter_space.hpp"
#include "fairway/tuning/score.hpp"

namespace fairway {

/// A setting with the runs that it has been given.
struct Contender {
  Setting setting;
  Outcomes outcomes{};  ///< the same seeds for all, from the first on
  bool is_out{false};   ///< was beaten before it had run all
};

/// What a race goes by.
struct RaceCourse {
  std::size_t scenarios{};  ///< runs of a block, which is one seed
  std::size_t blocks{};     ///< of the whole course
  std::size_t step{5};      ///< after so many blocks everybody who is still in is judged, again and again
};

/// Runs the next blocks of some contenders: their settings, the index of the first block, how many.
using RunBlocks =
    std::function<std::vector<Outcomes>(const std::vector<Setting>&, std::size_t first, std::size_t count)>;

/// Lets contenders run the same blocks side by side, against `champion`, who has run the whole course.
/// Whoever is beaten by the champion or by the best of the others is out, as is whoever has more unsafe runs
/// already than the champion has in all, who can never be better (Maron and Moore 1997; irace, Lopez-Ibanez
/// et al. 2016). Ends early where the next blocks would cost more than `budget` runs; what was spent is taken
/// off it. Returns the contenders best first: by how far they came, then by is_better().
std::vector<Contender> race(std::vector<Contender> contenders, std::span<const Outcome> champion,
                            std::span<const Outcome> usual, const RaceCourse& course, const RunBlocks& run,
                            std::size_t& budget);

}  // namespace fairway
