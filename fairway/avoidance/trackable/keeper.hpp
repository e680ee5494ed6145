// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/sketch.hpp"
#include "fairway/avoidance/trackable/foresight.hpp"
#include "fairway/avoidance/trackable/margins.hpp"

namespace fairway::trackable {

/// Of stopping; that of turning round is 2.
inline constexpr double usual_slow_cost = 0.5;

/// Turned from what is asked, and as quick as a share of its speed: as it is; then both sides of every 15
/// degrees at thirds of the speed, and to stop, the cheapest first, by 1 - cos(turn) + slow_cost_ratio (1 -
/// speed ratio). Columns, since they are looked at side by side; the last is repeated to their ends.
class Deviations {
 public:
  static constexpr std::size_t turn_count = 25;
  static constexpr std::size_t speed_count = 3;
  static constexpr std::size_t count = 1 + turn_count * speed_count + 1;

  explicit Deviations(double slow_cost_ratio);

  alignas(64) std::array<double, most_courses> cosines;
  alignas(64) std::array<double, most_courses> sines;  ///< to the side that is preferred
  alignas(64) std::array<double, most_courses> speed_ratios;
};

/// How a vehicle that must turn is kept clear.
struct Keeping {
  Margins margins;
  double hold;                  ///< how long a command is kept before its backup must still be possible [s]
  double drift_settling = 3.0;  ///< time constant of learning what sets it aside [s]
};

/// What is remembered between decisions.
struct Course {
  std::optional<Vec2> unexplained;   ///< of what sets it aside, by the current [m/s, NED]
  double sway{};                     ///< through the water, to starboard, as the envelope says [m/s]
  double side = 1.0;                 ///< to which it went last: 1 starboard, -1 port
  std::optional<Plan> last;          ///< what it took last
  bool is_instead{};                 ///< that is not what was asked
  std::optional<double> kept_since;  ///< against what was chosen anew [s]
};

/// What is taken of the plans that were looked at.
struct Choice;

/// Whether its envelope is known, and it turns in order to go elsewhere.
bool must_turn(const Situation& s) noexcept;

/// Said where the vehicle turns in order to go elsewhere and nobody says how; else empty. Text that outlives
/// the program's run.
std::string_view words_of_ignorance(const Situation& s) noexcept;

/// Holds what a method asks of a vehicle that must turn to what is clear, or leaves a backup manoeuvre, as a
/// Foresight says; otherwise takes the nearest course and speed of which that is true, and says at that
/// instant where there is none. A safe backup, once there, is not given up as long as what is near keeps its
/// velocity (gatekeeper, Agrawal, Chen, Panagou 2023). For one decision.
class Keeper {
 public:
  /// Of a situation in which the vehicle must_turn(). `s` must outlive it. O(solids).
  Keeper(const Keeping& keeping, const Situation& s, Course& course) noexcept;
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;

  /// Nine tenths of the way to the nearest surface; infinite where nothing is near [m].
  double room_now() const noexcept { return foresight_.room_now(); }

  /// Surge and turn rate by the TurnLaw, so that the way is the one foreseen whatever steering the vehicle
  /// has. Mode::infeasible and a note where no plan keeps clear. O(plans x steps x solids) where what is
  /// asked is not clear, else O(steps x solids). `sketch` may be null.
  Command keep(const Command& asked, const Deviations& deviations, Sketch* sketch) noexcept;

 private:
  /// What is asked, if it is clear; else the cheapest deviation that is, else the cheapest that has a backup,
  /// else, of who cannot stop, the way that it is on, if that is clear, else a refuge, else what leaves most
  /// room.
  Choice choose(const Plan& asked, const Deviations& deviations) noexcept;
  /// To stand, where that is clear, or before what stands to go astern, until it can turn.
  std::optional<Plan> refuge(const Plan& asked) const noexcept;
  /// What it took last, rather than to turn to the other side, as long as that is as good; of who can stop,
  /// no longer than a quarter of a turn takes. Who turns back loses what it has turned, a torpedo in the end
  /// all plans, and a boat that turns to and fro on the spot is driven ahead by its thrusters.
  Choice settled(const Choice& chosen) noexcept;
  bool is_as_good(const Plan& before, const Choice& chosen) const noexcept;
  void draw(Sketch& sketch, const Plan& plan, const Command& asked) const;

  const Situation& s_;
  Course& course_;
  Vec2 ahead_;
  TurnLaw law_;
  Margins margins_;
  double hold_;
  double window_;
  Vec2 frame_;  // in which it plans, by its velocity over ground [m/s]
  Foresight foresight_;
};

}  // namespace fairway::trackable
