// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fairway/comms/message.hpp"
#include "fairway/core/message_flight.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {

/// How often what is told gets through: whatever is sent, or what was measured at that distance.
enum class RateLaw { constant, measured };

template <>
struct EnumNames<RateLaw> {
  static constexpr std::array names{"constant", "measured"};
};

/// An acoustic modem on every vehicle, and the water between them. docs/exchange.md has the reasons.
struct AcousticParams {
  double update_rate_hz = 0.1;
  RateLaw rate_law = RateLaw::constant;
  bool slots = true;
  bool relay = false;
  double relay_north_m = 0.0;
  double relay_east_m = 0.0;
  double range_m = 80.0;
  double loss_ratio = 0.0;
  double sound_speed_mps = 1500.0;
  double bit_rate_bps = 1600.0;
  int message_bytes_count = 25;
  int overhead_bytes_count = 39;
  int modem_max_bytes_count = 64;
  bool quantised = true;
  double unforeseen_acceleration_mps2 = 0.02;

  static consteval auto fields() {
    using P = AcousticParams;
    return std::tuple{
        field<&P::update_rate_hz>({1e-4, 1000},
                                  "how often a vehicle tells of itself at most; slots, the time that a "
                                  "message takes and the step may allow less"),
        field<&P::rate_law>(
            "constant: what is sent gets through; measured: at a distance d as often as 0.848 - 0.01412 d + "
            "7.76e-5 d^2 Hz, if it is sent as often"),
        field<&P::slots>("vehicles transmit in turn, each in a slot of its own; false: whenever it is due"),
        field<&P::relay>(
            "a vessel on the surface repeats each message within its slot, and vehicles hear it alone"),
        field<&P::relay_north_m>({-1e7, 1e7}, "where that vessel lies"),
        field<&P::relay_east_m>({-1e7, 1e7}, "likewise"),
        field<&P::range_m>({0.1, 1e5}, "nobody farther away hears a message"),
        field<&P::loss_ratio>({0, 1}, "share of messages that are lost, each link by itself"),
        field<&P::sound_speed_mps>({100, 1e9}, "in water"),
        field<&P::bit_rate_bps>({1, 1e12}, "of the modem"),
        field<&P::message_bytes_count>({1, 65536}, "of what is told; the team record takes 25"),
        field<&P::overhead_bytes_count>({0, 65536}, "of what else a packet carries"),
        field<&P::modem_max_bytes_count>({1, 65536}, "the largest packet that the modem takes"),
        field<&P::quantised>("what is told is rounded as the team record does"),
        field<&P::unforeseen_acceleration_mps2>(
            {0, 10}, "standard deviation of what senders do between messages; makes old tracks uncertain"),
    };
  }
};

/// How often what is told gets through at `distance` [m], as measured up to 80 m; beyond 91 m, where the
/// fitted parabola would rise again, as there. [Hz]
double measured_rate(double distance);

/// What became of all messages so far. One that is sent reaches out to everyone else: `sent` times the number
/// of others is the sum of the rest and of what is under way.
struct AcousticCounts {
  std::int64_t sent{};
  std::int64_t received{};
  std::int64_t lost{};          ///< by chance, or because the measured rate was used up
  std::int64_t out_of_range{};  ///< when sent
  std::int64_t drowned{};       ///< the receiver was transmitting while they arrived
};

/// Underwater modems on all vehicles of a team: messages are few, take their time, get lost, and are not
/// heard by whoever is transmitting. A value: a copy is a snapshot. O(n + messages under way) a tick, and as
/// much for each that is sent.
class AcousticChannel {
 public:
  static constexpr std::size_t max_vehicles = 256;

  /// For ticks of `period` [s]. Throws InputError for a message that the modem or the record does not take,
  /// for more than 256 vehicles, or for parameters by which over a million messages might be under way.
  AcousticChannel(const AcousticParams& params, std::size_t vehicle_count, double period, const Rng& rng);

  /// As Exchange.
  void pass_on(Tick now, const Mailbox& said, std::span<const Vec3> places);
  std::span<const Message> heard_by(std::size_t receiver) const;
  void add_under_way(std::vector<MessageFlight>& flights) const;
  double turn_period() const;
  double next_turn(std::size_t vehicle, Tick now) const;

  const AcousticParams& params() const { return params_; }
  const AcousticCounts& counts() const { return counts_; }

  /// How long one message takes [s].
  double transmission_time() const { return transmission_ * period_; }
  /// From one slot's beginning to the next one's: a transmission and the way of sound to the farthest
  /// hearer, rounded up to whole ticks [s].
  double slot_time() const { return static_cast<double>(slot_ticks_) * period_; }

 private:
  struct Transmitter {
    double due{};                 // [ticks]
    std::optional<double> began;  // to transmit, last [ticks]
  };

  struct Link {
    Rng rng;
    double allowance{1.0};  // of messages that the measured rate lets through
  };

  /// A message on its way to one receiver; times in ticks.
  struct Flight {
    Message message;
    std::size_t from{};
    std::size_t to{};
    double sent{};
    double begins{};  // to be heard
    double ends{};
    bool drowned{};
  };

  /// The way of a message to a receiver: its last part, and what of it is over by then.
  struct Leg {
    double distance{};  // [m]
    double before{};    // until it is sent [ticks]
    bool reaches{};     // what sends it
  };

  bool may_transmit(std::size_t vehicle, Tick now) const;
  void transmit(std::size_t from, Tick now, const Mailbox& said, std::span<const Vec3> places);
  bool is_deaf(std::size_t vehicle, const Flight& flight) const;
  bool gets_through(Link& link, double distance, double waited);
  Leg leg(std::size_t from, std::size_t to, std::span<const Vec3> places) const;
  void drown_what_reaches(std::size_t vehicle);
  void hand_over(Tick now);
  Message told(const Message& message, Tick now) const;

  AcousticParams params_;
  std::size_t vehicle_count_;
  double period_;
  double transmission_;      // [ticks]
  double interval_;          // between the times when a vehicle is due [ticks]
  std::int64_t slot_ticks_;  // [ticks]

  std::vector<Transmitter> transmitters_;
  std::vector<Link> links_;      // by sender, then receiver
  std::vector<Flight> flights_;  // the first under_way_ in the order of sending; never resized
  std::size_t under_way_{};
  std::vector<Message> heard_;  // by receiver, then sender
  AcousticCounts counts_;
};

}  // namespace fairway
