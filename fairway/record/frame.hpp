// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/core/echo.hpp"
#include "fairway/core/ids.hpp"
#include "fairway/core/leg.hpp"
#include "fairway/core/message_flight.hpp"
#include "fairway/core/state.hpp"
#include "fairway/core/tick.hpp"

namespace fairway {

class Crew;

/// One vehicle in one frame: the truth, and what was asked of it.
struct VehicleFrame {
  VehicleId id{};
  VehicleState state;
  Command command;  ///< decided at this instant, from this state
  Phase phase{};
  Vec3 goal = Vec3::Zero();           ///< of the present leg [m, NED]
  double goal_speed{};                ///< along the leg [m/s]
  std::span<const double> actuators;  ///< state, in the order of the model
  double power{};                     ///< drawn by the actuators [W]
  Wrench wrench = Wrench::Zero();     ///< of the actuators on the vehicle [N, N m, body]
  std::span<const Track> tracks;      ///< as it perceived the others when it last decided; see FrameSink
  std::span<const Echo> echoes;       ///< of the sonar's last ping; empty without one
  std::span<const Stroke> strokes;    ///< what it drew when it last decided; empty unless someone is looking
};

/// What was true at one instant and what was decided on it. Metrics and the viewer know nothing else.
struct Frame {
  Tick tick{};
  double time{};                           ///< [s]
  double period{};                         ///< to the next frame [s]
  std::span<const VehicleFrame> vehicles;  ///< by index, as in the scenario
  std::span<const MessageFlight> flights;  ///< messages under way; empty unless someone is looking
  std::span<const SpokenWord> words;       ///< said at this instant, in the order of the vehicles, and of a
                                           ///< recording also since the frame before
  Crew* crew{nullptr};                     ///< threads that whoever looks at it may use meanwhile; null: none
};

/// Takes the frames of a run, in order. May throw on I/O errors; the run then ends.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void write(const Frame& frame) = 0;

  /// Whether it looks at strokes and flights, which a run that it is handed to then shows.
  virtual bool wants_thoughts() const { return false; }

  /// Whether it looks at tracks. Where no sink of a run does, frames have none, and nobody keeps any.
  virtual bool wants_tracks() const { return true; }
};

}  // namespace fairway
