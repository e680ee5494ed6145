// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "fairway/scenario/scenario.hpp"
#include "fairway/studies/cell.hpp"

namespace fairway::uuv {

inline constexpr std::array update_rates_hz{20.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1};
inline constexpr std::array loss_ratios{0.0, 0.1, 0.25, 0.5};

/// How the vehicles of a cube hear of each other.
struct Channel {
  enum class Kind {
    perfect,
    acoustic,  ///< everyone sends at `update_rate_hz`, through water that carries any amount any distance
    modem      ///< in turns, as far, as slowly and as often as was measured of a real one
  };
  Kind kind{};
  double update_rate_hz{};
  double loss_ratio{};

  std::string name() const;  ///< "0.5 Hz, loss 0.25"
};

/// The published cubes that are crossed again.
std::span<const std::string_view> silent_cubes();

/// As published, in the corrected mode, and with `inflate`; APF also with a repulsion that holds vehicles
/// apart, the next of the published tuning, since with its best one it collides even when it knows
/// everything.
std::span<const Method> silence_methods();

/// raja2024's crossing with the published best parameters, corrected, over the channel.
Scenario silence_scenario(std::string_view cube, const Method& method, const Channel& channel,
                          std::uint64_t seed);

}  // namespace fairway::uuv
