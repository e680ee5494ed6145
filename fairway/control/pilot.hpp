// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/control/body_request.hpp"
#include "fairway/control/guidance.hpp"
#include "fairway/control/steering.hpp"
#include "fairway/core/boxed.hpp"
#include "fairway/core/envelope.hpp"
#include "fairway/core/leg.hpp"
#include "fairway/core/onboard_model.hpp"
#include "fairway/core/shared.hpp"
#include "fairway/core/state.hpp"

namespace fairway {

/// A vehicle's particulars: what is known of it before it sets out.
struct Particulars {
  VehicleId id{};
  std::string name;
  double radius{1.0};  ///< of the enclosing sphere [m]
  std::int32_t priority{};
  Shared<Limits> limits;
  Shared<SteeringParams> steering;
  Boxed<OnboardModel> model;
  Boxed<Envelope> envelope{};  ///< where the avoider needs it
};

/// Carries out the commands of an avoidance method: it knows when the next one is due, which one is in force
/// and where a hold began, and makes body requests of them. `Simulation` has one for each vehicle, and each
/// `Helm` has its own. A value. Nothing but a copy allocates, and nothing throws.
class Pilot {
 public:
  /// Decisions are `period` [s] apart.
  Pilot(Particulars ship, double period) : ship_{std::move(ship)}, period_{period} {}

  const Particulars& ship() const { return ship_; }
  double period() const { return period_; }  ///< between decisions [s]

  /// Own ship, which believes to be in the state `x`, by a navigation that states `position_sigma` [m] of
  /// itself. A vehicle that has arrived gives way to everyone.
  Ownship own_ship(const VehicleState& x, double position_sigma, bool has_arrived) const noexcept;

  /// What the method is shown at `time` [s] on the way to the end of `leg`, along its line if it is a
  /// section. The situation points into this pilot, `tracks` and `obstacles`.
  Situation situation(double time, const Ownship& own, const Leg& leg, std::span<const Track> tracks,
                      std::span<const Obstacle> obstacles) const noexcept;

  /// Whether the method is to be asked at `now` [s], `interval` [s] after it could have been asked before:
  /// the instant nearest to one period after the last decision is the one. At once before the first decision.
  bool is_due(double now, double interval) const noexcept;
  /// The next decision is due one period after `now` [s].
  void note_decision(double now) noexcept { next_decision_ = now + period_; }
  /// The next decision is due as soon as there is something to decide.
  void ask_at_once() noexcept { next_decision_ = -std::numeric_limits<double>::infinity(); }

  /// Puts `command` in force, in a current that is estimated to be `current_n` [m/s, NED]. A hold begins
  /// where own ship is unless one is under way, which goes on by holding_yaw(); any other command ends it,
  /// and so does a hold with a turn rate, which says itself how to stay.
  void obey(const Command& command, const Ownship& own, const Vec3& current_n) noexcept;
  /// Ends a hold, so that the next one begins at another place.
  void end_hold() noexcept { holding_ = false; }

  const Command& command() const { return command_; }

  /// The request that carries out the command in force: for `crab` one through the water, in a current that
  /// is estimated to be `current_n` [m/s, NED], and otherwise one over ground. A vehicle that does not avoid
  /// anybody and can stop is steered by `proportional`.
  BodyRequest request(const Ownship& own, const Vec3& current_n, bool avoids = true) const noexcept;
  /// The request that is left to a vehicle that does not know its position: to stand still, or, if it cannot
  /// stop, to turn on the circle's radius at the least speed through the water.
  BodyRequest blind_request() const noexcept;

 private:
  Particulars ship_;
  double period_;
  double next_decision_{-std::numeric_limits<double>::infinity()};
  Command command_;
  HoldPoint hold_;
  bool holding_{false};
};

}  // namespace fairway
