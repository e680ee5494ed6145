// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fairway/avoidance/command.hpp"
#include "fairway/control/body_request.hpp"
#include "fairway/core/state.hpp"
#include "fairway/core/tick.hpp"
#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// What no vehicle does, whatever its model: whoever is beyond it is the product of a calculation that broke.
/// Farther is nobody on this Earth [m]: half way round it, twice what a scenario's places may be.
inline constexpr double farthest_m = 2e7;
/// Four times the fastest that any vehicle's parameters or a scenario's start allow [m/s].
inline constexpr double fastest_mps = 200.0;
/// Thirty turns a second, twenty times the fastest that any vehicle's parameters allow [rad/s].
inline constexpr double fastest_turn_radps = 200.0;

/// Why no vehicle can be in this state, or empty; of static storage. Four comparisons where one can.
std::string_view why_impossible(const VehicleState& x) noexcept;
/// Likewise of a command to a vehicle, of a request to its controller and of a demand of its actuators: all
/// are finite.
std::string_view why_impossible(const Command& command) noexcept;
std::string_view why_impossible(const BodyRequest& request) noexcept;
std::string_view why_impossible(const ActuatorValues& demand) noexcept;

/// How a run broke. It ends there, is recorded up to the instant before, and is never a result.
struct Divergence {
  std::size_t vehicle{};  ///< index
  Tick tick{};
  double time{};         ///< [s]
  std::string_view why;  ///< of static storage
};

/// "diverged: otter0 at 3.2 s: its speed is beyond 200 m/s".
std::string text_of(const Divergence& divergence, std::string_view vehicle);

/// Ends a run that broke where only a whole one counts. what() is text_of().
class RunDiverged : public std::runtime_error {
 public:
  RunDiverged(const Divergence& divergence, std::string_view vehicle)
      : RunDiverged{text_of(divergence, vehicle)} {}
  /// As it was told before, by text_of().
  explicit RunDiverged(const std::string& text) : std::runtime_error{text} {}
};

}  // namespace fairway
