// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/shard.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <numeric>
#include <queue>
#include <string_view>
#include <utility>

namespace fairway {
namespace {

/// A whole number of at most `most` that `text` consists of.
bool read_whole(std::string_view text, std::uint32_t most, std::uint32_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() && number <= most;
}

struct MethodCost {
  std::string_view name;
  double decision_us;  ///< among seven, as docs/benchmarks.md has it
};
constexpr std::array<MethodCost, 9> dear_methods{{{"vo", 5},
                                                  {"rvo", 5},
                                                  {"hrvo", 5},
                                                  {"avoa", 220},
                                                  {"avoa_improved", 100},
                                                  {"teb", 500},
                                                  {"blend", 3000},
                                                  {"hard_switching", 1},
                                                  {"wall_following", 1}}};
constexpr double cheap_decision_us = 0.4;
constexpr double vehicle_step_us = 0.8;
// a path among four obstacles, once; `blend` plans too
constexpr double plan_us = 68'000;

double decision_cost(std::string_view method) {
  const auto* known = std::ranges::find(dear_methods, method, &MethodCost::name);
  return known == dear_methods.end() ? cheap_decision_us : known->decision_us;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  Shard shard;
  if (slash == std::string::npos || !read_whole(text.substr(0, slash), max_shards, shard.index) ||
      !read_whole(text.substr(slash + 1), max_shards, shard.count) || shard.count == 0) {
    throw InputError("--shard " + text + ": expected I/N, as 3/64, with I from 0 to N - 1 and N at most " +
                     std::to_string(max_shards));
  }
  if (shard.index >= shard.count) {
    throw InputError("--shard " + text + ": there is no such shard; they count from 0 to " +
                     std::to_string(shard.count - 1));
  }
  return shard;
}

std::string text_of(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

double expected_cost(const Scenario& scenario) {
  const double steps = scenario.duration_s / scenario.step_s;
  double cost = 0.0;
  for (const VehicleSpec& vehicle : scenario.vehicles) {
    const std::string method = vehicle.avoider->name.substr(0, vehicle.avoider->name.find('+'));
    cost += steps * (vehicle_step_us + decision_cost(method) / scenario.steps_per_decision);
    if (method == "rrt_star" || method == "blend") cost += plan_us;
  }
  return cost;
}

std::vector<std::uint32_t> dealt(std::span<const double> cell_costs, std::size_t runs_per_cell,
                                 std::uint32_t count) {
  const std::size_t even = runs_per_cell / count * count;
  std::vector<std::uint32_t> shards(cell_costs.size() * runs_per_cell);
  std::vector<std::size_t> dearest_first(cell_costs.size());
  std::iota(dearest_first.begin(), dearest_first.end(), std::size_t{0});
  std::ranges::stable_sort(dearest_first,
                           [&](std::size_t a, std::size_t b) { return cell_costs[a] > cell_costs[b]; });

  using Load = std::pair<double, std::uint32_t>;
  std::priority_queue<Load, std::vector<Load>, std::greater<>> lightest;
  for (std::uint32_t shard = 0; shard < count; ++shard) lightest.emplace(0.0, shard);
  std::vector<Load> taken;
  for (const std::size_t cell : dearest_first) {
    std::uint32_t* const of_cell = &shards[cell * runs_per_cell];
    for (std::size_t s = 0; s < even; ++s) of_cell[s] = static_cast<std::uint32_t>(s % count);
    // each of those left over, fewer than there are shards, to another one
    taken.clear();
    for (std::size_t s = even; s < runs_per_cell; ++s) {
      const auto [load, shard] = lightest.top();
      lightest.pop();
      of_cell[s] = shard;
      taken.emplace_back(load + cell_costs[cell], shard);
    }
    for (const Load& load : taken) lightest.push(load);
  }
  return shards;
}

}  // namespace fairway
