// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fairway/scenario/scenario.hpp"
#include "fairway/studies/cell.hpp"

namespace fairway::pledges {

/// What eight vehicles meet with that cross a cube of 20 m and hear each other by modem.
struct Condition {
  double cycle_s{};              ///< from one word of a vehicle to its next
  double loss_ratio{};           ///< of words, each pair by itself
  double current_mps{};          ///< to the north
  FailureKind failure{};         ///< of one vehicle, at an instant that is drawn
  double drift_sigma_m{};        ///< of where each believes to be, north and east
  bool agreed_beforehand{true};  ///< the crossing begins when they have agreed; else when all are there
  int rock_count{};              ///< spheres that stand in the cube, beside where they come to it and go
  double loss_run_count{};       ///< how many words a pair loses in a row in the mean; 0: each by itself

  std::string place() const;  ///< "3.2 s, loss 0.1"
  std::string name() const;   ///< "current 0.2, stops"
};

inline constexpr std::array cycles_s{3.2, 8.0, 10.0};
inline constexpr std::array loss_ratios{0.0, 0.1, 0.5};
inline constexpr std::array currents_mps{0.0, 0.1, 0.2};

/// `pledge`, who it is compared with, and `direct`, which is in nobody's way and in everybody's.
std::span<const Method> methods();

Scenario crossing_scenario(const Condition& condition, const Method& method, std::uint64_t seed);

/// `pledge` under every condition, `seeds` runs each; the others under a few, with a fifth of them.
std::vector<Cell> crossing_cells(int seeds);

/// `direct` in the same current, beside which the time of a cell is judged.
const Cell& straight_cell(const std::vector<Cell>& cells, const Cell& cell);

}  // namespace fairway::pledges
