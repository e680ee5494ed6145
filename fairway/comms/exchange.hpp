// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "fairway/comms/acoustic_channel.hpp"
#include "fairway/comms/message.hpp"
#include "fairway/core/kind_info.hpp"
#include "fairway/core/message_flight.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {

/// How vehicles hear of each other: `perfect`, everyone hears everyone at once; `none`, nobody hears
/// anything; `acoustic`, by modems under water. A value: a copy is a snapshot.
class Exchange {
 public:
  /// Throws InputError for an unknown kind or parameter, or for parameters that do not go together.
  Exchange(std::string_view kind, const ParamValues& params, std::size_t vehicle_count, double period,
           Rng rng);

  /// One tick: takes what everyone would say now and hands over what has arrived by now. `places` is where
  /// the vehicles truly are [m, NED], since sound travels there, and `obstacles` what may be in its way.
  /// Called once a tick, with ticks in order. Does not allocate after the first tick.
  void pass_on(Tick now, const Mailbox& said, std::span<const Vec3> places,
               std::span<const Obstacle> obstacles = {});

  /// Whether pass_on() may take at `now` what a vehicle says; where telling takes time only in its turn.
  bool may_take(std::size_t vehicle, Tick now) const;

  /// The last message that `receiver` has heard of each vehicle, `said` being what was passed on last; its
  /// own may be among them, and so may vehicles that never told anything (`told` is false). Valid until the
  /// next pass_on(), and for as long as `said` is.
  std::span<const Message> heard_by(std::size_t receiver, std::span<const Message> said) const;

  /// Adds the messages that are under way, in the order in which they were sent; none where telling takes no
  /// time.
  void add_under_way(std::vector<MessageFlight>& flights) const;

  /// Whether `vehicle` put what it says on the air at the tick `now`, which was passed on last.
  bool has_spoken(std::size_t vehicle, Tick now) const;

  /// What became of all that was sent so far; nothing where telling takes no time.
  std::optional<AcousticCounts> counts() const;

  /// True if everyone hears what everyone says, at once: heard_by() is then what is said, by vehicle.
  bool carries_at_once() const { return std::holds_alternative<Everywhere>(way_); }

  /// False if nobody ever hears anything.
  bool carries_anything() const { return !std::holds_alternative<Silence>(way_); }

  /// From one turn of a vehicle to speak to its next at most [s], and when the next one after `now` begins
  /// [s]. Where telling takes no time every tick is a turn.
  double turn_period() const;
  double next_turn(std::size_t vehicle, Tick now) const;

  /// By how much a vehicle's own clock is ahead of the true time [s].
  double clock_ahead(std::size_t vehicle, Tick now) const;

  /// The last distance to each of the others that `receiver` has measured by sound, by vehicle; empty where
  /// nothing is measured.
  std::span<const std::optional<AcousticRange>> ranges_by(std::size_t receiver) const;

  /// Standard deviation of what a sender does to its velocity between messages, which no prediction knows
  /// [m/s2].
  double unforeseen_acceleration() const;

 private:
  struct Everywhere {};
  struct Silence {};
  using Way = std::variant<Everywhere, Silence, AcousticChannel>;

  static Way way_of(std::string_view kind, const ParamValues& params, std::size_t vehicle_count,
                    double period, const Rng& rng);

  double period_;
  Way way_;
};

/// All that a scenario may choose.
std::vector<KindInfo> exchange_kinds();

}  // namespace fairway
