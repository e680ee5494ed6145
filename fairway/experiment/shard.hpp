// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// A part of a campaign: part `index`, from 0, of `count`.
struct Shard {
  std::uint32_t index{0};
  std::uint32_t count{1};

  bool is_all() const { return count == 1; }
};

inline constexpr std::uint32_t max_shards = 100'000;

/// "3/64". Throws InputError unless it is I/N with I < N and N up to max_shards.
Shard parse_shard(const std::string& text);

/// "3/64".
std::string text_of(const Shard& shard);

/// About what a run of this scenario costs, in microseconds of one core: vehicles x steps x what the model
/// and the method take, were it to last for its whole duration. Made of the scenario alone by sums and
/// products, so it is the same on every machine. Methods differ a hundredfold and more (docs/benchmarks.md);
/// within a method it may be out by a few times.
double expected_cost(const Scenario& scenario);

/// Which of `count` shards each run is of: run s of cell c at [c * runs_per_cell + s]. The runs of a cell
/// cost alike, so every shard gets as many of them as any other; what is left over goes one by one, the
/// dearest cell first, to the shard that has least. A pure function of its arguments. O(runs log count).
std::vector<std::uint32_t> dealt(std::span<const double> cell_costs, std::size_t runs_per_cell,
                                 std::uint32_t count);

}  // namespace fairway
