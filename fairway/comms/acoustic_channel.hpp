// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fairway/comms/message.hpp"
#include "fairway/comms/ranging.hpp"
#include "fairway/core/message_flight.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/record.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/shapes.hpp"

namespace fairway {

/// How often what is told gets through: whatever is sent, or what was measured at that distance.
enum class RateLaw { constant, measured };

template <>
struct EnumNames<RateLaw> {
  static constexpr std::array names{"constant", "measured"};
};

/// How far sound carries: as far as a range, or as the sonar equation says.
enum class Propagation { disc, sonar };

template <>
struct EnumNames<Propagation> {
  static constexpr std::array names{"disc", "sonar"};
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
  double loss_run_count = 0.0;
  Propagation propagation = Propagation::disc;
  double source_power_w = 1.4;
  double frequency_hz = 26000.0;
  double spreading_ratio = 1.5;
  double wind_mps = 5.0;
  double shipping_ratio = 0.5;
  double echo_loss_ratio = 10.0;
  bool shadow = false;
  bool interference = false;
  double capture_ratio = 10.0;
  bool carrier_sense = false;
  double clock_offset_s = 0.0;
  double clock_drift_ratio = 0.0;
  double clock_jump_s = 0.0;
  double clock_jump_within_s = 100.0;
  RangingKind ranging = RangingKind::none;
  double range_deviation_m = 0.2;
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
        field<&P::loss_run_count>(
            {0, 1e6}, "mean number of messages that a link loses in a row; 0: each is lost by itself"),
        field<&P::propagation>(
            "disc: whoever is within range_m hears; sonar: as likely as the sonar equation says"),
        field<&P::source_power_w>({1e-6, 1e6}, "sonar, interference: of the sound that a modem sends"),
        field<&P::frequency_hz>({400, 1e6}, "sonar, interference: in the middle of the band"),
        field<&P::spreading_ratio>({1, 2},
                                   "sonar, interference: 1 between surface and bottom, 2 in the open"),
        field<&P::wind_mps>({0, 50}, "sonar: makes noise"),
        field<&P::shipping_ratio>({0, 1}, "sonar: makes noise; 0 far from all ships, 1 in a busy lane"),
        field<&P::echo_loss_ratio>(
            {1, 1e6},
            "sonar: how many times less of a bit's energy counts, for echoes and an imperfect modem"),
        field<&P::shadow>("nobody hears through a fixed obstacle"),
        field<&P::interference>("messages that overlap at a receiver spoil each other"),
        field<&P::capture_ratio>(
            {1, 1e9}, "interference: a message as many times as strong as another is heard in spite of it"),
        field<&P::carrier_sense>(
            "without slots: a vehicle that hears a message waits until it is over, and a random time more"),
        field<&P::clock_offset_s>({0, 1000}, "standard deviation of the vehicles' clocks as a run begins"),
        field<&P::clock_drift_ratio>({0, 0.1},
                                     "standard deviation of how much too fast they go; 1e-6 is 1 ppm"),
        field<&P::clock_jump_s>({0, 1000}, "standard deviation of one jump of each vehicle's clock"),
        field<&P::clock_jump_within_s>({0, 1e6},
                                       "which comes at a time drawn evenly from the first so many seconds"),
        field<&P::ranging>(
            "none; one_way: of each word how long it took, by the sender's clock and the receiver's; "
            "two_way: "
            "of a word and its answer, which takes 3 bytes more of every packet for each other vehicle"),
        field<&P::range_deviation_m>({0, 1000}, "ranging: standard deviation of one measurement"),
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
  std::int64_t lost{};          ///< by chance, by noise, or because the measured rate was used up
  std::int64_t out_of_range{};  ///< when sent, or hidden
  std::int64_t drowned{};       ///< the receiver was transmitting while they arrived
  std::int64_t collided{};      ///< with another message at the receiver

  static consteval auto members() {
    using R = AcousticCounts;
    return std::tuple{
        member<&R::sent>("", "transmissions"),
        member<&R::received>("", "receptions, one for each receiver"),
        member<&R::lost>("", "by chance, by noise, or because the measured rate was used up"),
        member<&R::out_of_range>("", "too far or hidden when sent"),
        member<&R::drowned>("", "the receiver was transmitting while they arrived"),
        member<&R::collided>("", "with another message at the receiver"),
    };
  }
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
  void pass_on(Tick now, const Mailbox& said, std::span<const Vec3> places,
               std::span<const Obstacle> obstacles = {});
  /// Whether it is its turn, if nobody else is heard.
  bool may_transmit(std::size_t vehicle, Tick now) const;
  std::span<const Message> heard_by(std::size_t receiver) const;
  void add_under_way(std::vector<MessageFlight>& flights) const;
  bool has_spoken(std::size_t vehicle, Tick now) const {
    return transmitters_[vehicle].began == static_cast<double>(count(now));
  }
  double turn_period() const;
  double next_turn(std::size_t vehicle, Tick now) const;
  double clock_ahead(std::size_t vehicle, Tick now) const;
  std::span<const std::optional<AcousticRange>> ranges_by(std::size_t receiver) const {
    return ranging_.by(receiver);
  }

  const AcousticParams& params() const { return params_; }
  const AcousticCounts& counts() const { return counts_; }

  /// How long one message takes [s].
  double transmission_time() const { return transmission_ * period_; }
  /// From one slot's beginning to the next one's: a transmission and the way of sound to the farthest
  /// hearer, rounded up to whole ticks [s].
  double slot_time() const { return static_cast<double>(slot_ticks_) * period_; }

 private:
  /// All in ticks.
  struct Clock {
    double ahead{};  // as the run begins
    double drift{};  // by which it goes too fast
    double jump{};
    double jumps_at{};

    double jumped(double time) const { return time < jumps_at ? 0.0 : jump; }
    double ahead_at(double time) const { return ahead + drift * time + jumped(time); }
    double shown_at(double time) const { return time + ahead + drift * time + jumped(time); }
  };

  struct Transmitter {
    double due{};                 // [ticks]
    std::optional<double> began;  // to transmit, last [ticks]
    Rng backoff;
    int waits{};  // in a row, for others to be silent
    Clock clock;
  };

  struct Link {
    Rng rng;
    double allowance{1.0};            // of messages that the measured rate lets through
    std::optional<bool> is_losing{};  // in a run of losses
  };

  /// A ray of sound from one modem to another: what the sonar equation has that does not change.
  struct Ray {
    double absorption{};        // [dB/km]
    double bit_energy_at_1m{};  // over noise, echoes included [dB]
  };

  /// A message on its way to one receiver; times in ticks.
  struct Flight {
    Message message;
    std::size_t from{};
    std::size_t to{};
    double sent{};
    double begins{};  // to be heard
    double ends{};
    double strength{};  // by the receiver's place, of 1 at 1 m
    std::optional<Ranging::Way> answered{};
    bool is_noise{};  // lost, and yet in the others' way
    bool drowned{};
    bool collided{};
  };

  /// The way of a message to a receiver: its last part, and what of it is over by then.
  struct Leg {
    double distance{};  // [m]
    double before{};    // until it is sent [ticks]
    bool reaches{};     // what sends it
  };

  static Ray ray_of(const AcousticParams& params);
  bool clocks_are_right() const;
  double clock(std::size_t vehicle, double ticks) const;
  bool waits_for_silence(std::size_t vehicle, Tick now);
  void transmit(std::size_t from, Tick now, const Mailbox& said, std::span<const Vec3> places,
                std::span<const Obstacle> obstacles);
  void send(Flight flight);
  void collide(Flight& flight);
  bool is_deaf(std::size_t vehicle, const Flight& flight) const;
  bool gets_through(Link& link, double distance, double waited);
  bool is_lucky(Link& link, double distance) const;
  double loss_on(double distance) const;
  Leg leg(std::size_t from, std::size_t to, std::span<const Vec3> places,
          std::span<const Obstacle> obstacles) const;
  void drown_what_reaches(std::size_t vehicle);
  void hand_over(Tick now);
  Message told(const Message& message, Tick now) const;
  Message as_read(const Flight& flight, Tick now) const;

  AcousticParams params_;
  std::size_t vehicle_count_;
  double period_;
  double transmission_;      // [ticks]
  double interval_;          // between the times when a vehicle is due [ticks]
  std::int64_t slot_ticks_;  // [ticks]
  Ray ray_;

  std::vector<Transmitter> transmitters_;
  std::vector<Link> links_;      // by sender, then receiver
  std::vector<Flight> flights_;  // the first under_way_ in the order of sending; never resized
  std::size_t under_way_{};
  std::vector<Message> heard_;  // by receiver, then sender
  Ranging ranging_;
  AcousticCounts counts_;
};

}  // namespace fairway
