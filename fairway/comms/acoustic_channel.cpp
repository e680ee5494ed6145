// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/acoustic_channel.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "fairway/comms/sound.hpp"
#include "fairway/comms/team_record.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"

namespace fairway {
namespace {

/// Times that differ by less are the same: no way of sound or bits is as short [ticks].
constexpr double instant = 1e-5;

/// What every packet has besides for each other vehicle that it may answer: a time between two words, in
/// steps of 10 us up to 167 s.
constexpr int answer_bytes = 3;

/// Of every packet [bytes].
int packet_bytes(const AcousticParams& params, std::size_t vehicle_count) {
  const bool answers = params.ranging == RangingKind::two_way;
  return params.message_bytes_count + params.overhead_bytes_count +
         (answers ? answer_bytes * (static_cast<int>(vehicle_count) - 1) : 0);
}

/// The parameters, if they go together.
const AcousticParams& checked(const AcousticParams& params, std::size_t vehicle_count) {
  check_params(params);
  const auto number = [](auto value) { return number_text(static_cast<double>(value)); };
  const int told = params.message_bytes_count + params.overhead_bytes_count;
  const int packet = packet_bytes(params, vehicle_count);
  if (packet > params.modem_max_bytes_count) {
    const std::string answers = packet > told ? " and " + number(packet - told) + " of answers" : "";
    throw InputError({}, packet > told ? "modem_max_bytes_count" : "message_bytes_count",
                     number(params.message_bytes_count) + " bytes and " +
                         number(params.overhead_bytes_count) + " of overhead" + answers +
                         " are more than the " + number(params.modem_max_bytes_count) +
                         " that the modem takes");
  }
  constexpr int record = std::tuple_size_v<TeamRecord>;
  if (params.quantised && params.message_bytes_count < record) {
    throw InputError({}, "message_bytes_count",
                     number(params.message_bytes_count) + " bytes are less than the " + number(record) +
                         " of the team record; quantised: false does without it");
  }
  if (params.relay && !params.slots)
    throw InputError({}, "slots",
                     "a relay repeats each message in the sender's slot; slots: false leaves it none");
  if (params.relay && params.ranging != RangingKind::none)
    throw InputError({}, "ranging", "what comes by a relay tells no distance; relay: false goes with it");
  if (params.carrier_sense && params.slots)
    throw InputError({}, "carrier_sense", "in slots nobody waits for others; slots: false goes with it");
  // so many in a row at least, where every run of losses is followed by one message that gets through
  const double shortest = std::max(1.0, params.loss_ratio / (1.0 - params.loss_ratio));
  if (params.loss_run_count > 0.0 && params.loss_run_count < shortest) {
    throw InputError({}, "loss_run_count",
                     "a link that loses " + number(params.loss_ratio) + " of its messages loses at least " +
                         number(shortest) + " in a row in the mean; 0: each is lost by itself");
  }
  constexpr std::size_t most = AcousticChannel::max_vehicles;
  if (vehicle_count > most) {
    throw InputError(
        {}, "kind",
        "acoustic exchange is for at most " + number(most) + " vehicles, not " + number(vehicle_count));
  }
  return params;
}

/// How long a packet takes [ticks].
double transmission_of(const AcousticParams& params, std::size_t vehicle_count, double period) {
  const double bits = 8.0 * packet_bytes(params, vehicle_count);
  return bits / params.bit_rate_bps / period;
}

/// [ticks]
double way_of_sound(const AcousticParams& params, double distance, double period) {
  return distance / params.sound_speed_mps / period;
}

/// On the surface [m, NED].
Vec3 relay_of(const AcousticParams& params) { return {params.relay_north_m, params.relay_east_m, 0.0}; }

/// The level of 1 W of sound, 1 m from a source that sends it everywhere [dB re 1 uPa].
constexpr double one_watt = 170.8;

/// Whole ticks that are not over before `time` [ticks].
double whole(double time) { return std::ceil(time - instant); }

/// How many messages may be under way at once.
std::size_t most_under_way(const AcousticParams& params, std::size_t vehicle_count, double period,
                           double interval) {
  // everyone has heard when a slot is over, but hears only after the next has begun
  const double count = static_cast<double>(vehicle_count);
  if (params.slots) return 2 * vehicle_count;

  // in a time t a vehicle that is due every interval transmits at most t / interval + 1 times; one tick more
  // goes by before it does, and one before a message that has arrived is handed over
  const double longest =
      transmission_of(params, vehicle_count, period) + way_of_sound(params, params.range_m, period);
  const double most = count * count * (std::ceil(longest / interval) + 3.0);
  if (most > 1e6)
    throw InputError({}, "update_rate_hz", "more than a million messages might be under way at once");
  return static_cast<std::size_t>(most);
}

}  // namespace

double measured_rate(double distance) {
  constexpr double slowest_at = 0.01412 / (2.0 * 7.76e-5);
  const double d = std::min(distance, slowest_at);
  return 0.848 - 0.01412 * d + 7.76e-5 * d * d;
}

AcousticChannel::AcousticChannel(const AcousticParams& params, std::size_t vehicle_count, double period,
                                 const Rng& rng)
    : params_{checked(params, vehicle_count)},
      vehicle_count_{vehicle_count},
      period_{period},
      transmission_{transmission_of(params, vehicle_count, period)},
      interval_{std::max({1.0 / (params.update_rate_hz * period), whole(transmission_), 1.0})},
      slot_ticks_{std::max<std::int64_t>(
          1, std::llround(whole((params.relay ? 2 : 1) *
                                (transmission_ + way_of_sound(params, params.range_m, period)))))},
      ray_{ray_of(params)},
      flights_(most_under_way(params, vehicle_count, period, interval_)),
      heard_(vehicle_count * vehicle_count, Message{.told = false}),
      ranging_{{params.ranging, params.sound_speed_mps, params.range_deviation_m}, vehicle_count, rng} {
  const double count = static_cast<double>(vehicle_count);
  for (std::size_t i = 0; i < vehicle_count; ++i) {
    Rng clock = rng.stream("clock", i);
    transmitters_.push_back({.backoff = rng.stream("backoff", i), .clock = {}});
    transmitters_[i].clock = {.ahead = params.clock_offset_s * clock.normal() / period,
                              .drift = params.clock_drift_ratio * clock.normal(),
                              .jump = params.clock_jump_s * clock.normal() / period,
                              .jumps_at = clock.uniform(0.0, params.clock_jump_within_s / period)};
    if (!params.slots)
      transmitters_[i].due = std::floor(interval_ * static_cast<double>(i) / count + instant);
    const Rng sender = rng.stream("sender", i);
    for (std::size_t j = 0; j < vehicle_count; ++j) links_.push_back({sender.stream("receiver", j)});
  }
}

AcousticChannel::Ray AcousticChannel::ray_of(const AcousticParams& params) {
  const double frequency = 1e-3 * params.frequency_hz;
  const double level = one_watt + decibels(params.source_power_w);
  const double noise = ambient_noise(frequency, params.shipping_ratio, params.wind_mps);
  return {
      .absorption = francois_garrison_absorption(frequency, {}),
      .bit_energy_at_1m = level - noise - decibels(params.bit_rate_bps) - decibels(params.echo_loss_ratio)};
}

void AcousticChannel::pass_on(Tick now, const Mailbox& said, std::span<const Vec3> places,
                              std::span<const Obstacle> obstacles) {
  for (std::size_t i = 0; i < vehicle_count_; ++i) {
    if (said[i].told && may_transmit(i, now) && !waits_for_silence(i, now))
      transmit(i, now, said, places, obstacles);
  }
  hand_over(now);
}

std::span<const Message> AcousticChannel::heard_by(std::size_t receiver) const {
  return std::span{heard_}.subspan(receiver * vehicle_count_, vehicle_count_);
}

double AcousticChannel::turn_period() const {
  const double interval = interval_ * period_;
  if (!params_.slots) return interval;
  const double cycle = static_cast<double>(slot_ticks_) * static_cast<double>(vehicle_count_) * period_;
  return cycle * std::ceil(interval / cycle - 1e-9);
}

double AcousticChannel::next_turn(std::size_t vehicle, Tick now) const {
  const double due = std::max(transmitters_[vehicle].due, static_cast<double>(count(now)) + 1.0);
  if (!params_.slots) return due * period_;
  const double slot = static_cast<double>(slot_ticks_), cycle = slot * static_cast<double>(vehicle_count_);
  const double first = slot * static_cast<double>(vehicle);
  return (first + cycle * std::ceil((due - instant - first) / cycle)) * period_;
}

double AcousticChannel::clock_ahead(std::size_t vehicle, Tick now) const {
  if (clocks_are_right()) return 0.0;
  return transmitters_[vehicle].clock.ahead_at(static_cast<double>(count(now))) * period_;
}

bool AcousticChannel::clocks_are_right() const {
  return params_.clock_offset_s == 0.0 && params_.clock_drift_ratio == 0.0 && params_.clock_jump_s == 0.0;
}

/// What its clock shows at a true time [ticks] between two ticks [s].
double AcousticChannel::clock(std::size_t vehicle, double ticks) const {
  return transmitters_[vehicle].clock.shown_at(ticks) * period_;
}

void AcousticChannel::add_under_way(std::vector<MessageFlight>& flights) const {
  for (const Flight& flight : std::span{flights_}.first(under_way_)) {
    if (flight.is_noise) continue;
    flights.push_back({.from = static_cast<std::uint32_t>(flight.from),
                       .to = static_cast<std::uint32_t>(flight.to),
                       .sent = flight.sent * period_,
                       .begins = flight.begins * period_,
                       .arrives = flight.ends * period_,
                       .unheard = flight.drowned || flight.collided});
  }
}

bool AcousticChannel::may_transmit(std::size_t vehicle, Tick now) const {
  if (static_cast<double>(count(now)) < transmitters_[vehicle].due - instant) return false;
  if (!params_.slots) return true;
  const std::int64_t slot = count(now) / slot_ticks_;
  const bool begins = count(now) % slot_ticks_ == 0;
  return begins && slot % static_cast<std::int64_t>(vehicle_count_) == static_cast<std::int64_t>(vehicle);
}

bool AcousticChannel::waits_for_silence(std::size_t vehicle, Tick now) {
  if (!params_.carrier_sense) return false;
  const double begin = static_cast<double>(count(now));
  double busy_until = 0.0;
  for (const Flight& flight : std::span{flights_}.first(under_way_)) {
    if (flight.to == vehicle && flight.begins <= begin + instant)
      busy_until = std::max(busy_until, flight.ends);
  }
  Transmitter& transmitter = transmitters_[vehicle];
  if (busy_until <= begin + instant) {
    transmitter.waits = 0;
    return false;
  }
  const double window = math::power(2.0, std::min(++transmitter.waits, 5));
  transmitter.due = busy_until + transmitter.backoff.uniform(0.0, window) * transmission_;
  return true;
}

void AcousticChannel::transmit(std::size_t from, Tick now, const Mailbox& said, std::span<const Vec3> places,
                               std::span<const Obstacle> obstacles) {
  const double begin = static_cast<double>(count(now));
  Transmitter& transmitter = transmitters_[from];
  const double waited = begin - transmitter.began.value_or(begin);
  transmitter.began = begin;
  transmitter.due += interval_;
  if (transmitter.due <= begin) transmitter.due = begin + interval_;  // what was missed is not made up for
  if (params_.carrier_sense) {  // else two that once began together would do so for ever
    transmitter.due += transmitter.backoff.uniform(0.0, 1.0) * transmission_;
  }
  ++counts_.sent;
  drown_what_reaches(from);

  // what the relay has not heard it repeats to nobody; its link is the one that the sender has to itself
  const bool is_repeated = !params_.relay || gets_through(links_[from * vehicle_count_ + from],
                                                          (places[from] - relay_of(params_)).norm(), waited);
  const Message message = told(said[from], now);
  for (std::size_t to = 0; to < vehicle_count_; ++to) {
    if (to == from) continue;
    const Leg last = leg(from, to, places, obstacles);
    const bool is_through = gets_through(links_[from * vehicle_count_ + to], last.distance, waited);
    if (!last.reaches || last.distance > params_.range_m) {
      ++counts_.out_of_range;
      continue;
    }
    const double begins = begin + last.before + way_of_sound(params_, last.distance, period_);
    send({.message = message,
          .from = from,
          .to = to,
          .sent = begin,
          .begins = begins,
          .ends = begins + transmission_,
          .strength = params_.interference ? power_ratio(-loss_on(last.distance)) : 0.0,
          .answered = ranging_.answered(from, to),
          .is_noise = !is_through || !is_repeated});
  }
}

void AcousticChannel::send(Flight flight) {
  if (flight.is_noise) {
    ++counts_.lost;
    if (!params_.interference && !params_.carrier_sense) return;
  }
  flight.drowned = is_deaf(flight.to, flight);
  if (params_.interference) collide(flight);
  flights_[under_way_++] = flight;
}

void AcousticChannel::collide(Flight& flight) {
  for (Flight& other : std::span{flights_}.first(under_way_)) {
    const bool overlap =
        other.to == flight.to && other.ends > flight.begins + instant && flight.ends > other.begins + instant;
    if (!overlap) continue;
    if (other.strength < params_.capture_ratio * flight.strength) other.collided = true;
    if (flight.strength < params_.capture_ratio * other.strength) flight.collided = true;
  }
}

AcousticChannel::Leg AcousticChannel::leg(std::size_t from, std::size_t to, std::span<const Vec3> places,
                                          std::span<const Obstacle> obstacles) const {
  const auto is_clear = [&](const Vec3& a, const Vec3& b) {
    return !params_.shadow ||
           std::ranges::none_of(obstacles, [&](const Obstacle& each) { return is_in_shadow(each, a, b); });
  };
  if (!params_.relay) return {(places[to] - places[from]).norm(), 0.0, is_clear(places[from], places[to])};
  const Vec3 relay = relay_of(params_);
  const double up = (relay - places[from]).norm();
  return {(places[to] - relay).norm(), transmission_ + way_of_sound(params_, up, period_),
          up <= params_.range_m && is_clear(places[from], relay) && is_clear(relay, places[to])};
}

double AcousticChannel::loss_on(double distance) const {
  return transmission_loss(distance, params_.spreading_ratio, ray_.absorption);
}

Message AcousticChannel::told(const Message& message, Tick now) const {
  if (!params_.quantised || !message.speech.empty()) return message;
  Message read = decode(encode(message, period_), now, period_);
  read.from = message.from;  // the modem's address says it in full
  return read;
}

bool AcousticChannel::gets_through(Link& link, double distance, double waited) {
  const bool lucky = is_lucky(link, distance);
  if (params_.rate_law == RateLaw::constant) return lucky;

  // at most one message is saved up
  link.allowance = std::min(link.allowance + measured_rate(distance) * waited * period_, 2.0);
  if (link.allowance < 1.0) return false;
  link.allowance -= 1.0;
  return lucky;
}

bool AcousticChannel::is_lucky(Link& link, double distance) const {
  // drawn in any case, so that nobody's place decides about later draws
  const double draw = link.rng.uniform(0.0, 1.0);
  bool lucky = draw >= params_.loss_ratio;
  if (params_.loss_run_count > 0.0 && link.is_losing) {  // Gilbert (1960): two states, one loses all
    const double ends = 1.0 / params_.loss_run_count;
    const double begins = ends * params_.loss_ratio / (1.0 - params_.loss_ratio);
    lucky = *link.is_losing ? draw < ends : draw >= begins;
  }
  link.is_losing = !lucky;
  if (params_.propagation == Propagation::disc) return lucky;

  const int bits = 8 * packet_bytes(params_, vehicle_count_);
  const double error = packet_error_ratio(ray_.bit_energy_at_1m - loss_on(distance), bits);
  return link.rng.uniform(0.0, 1.0) >= error && lucky;
}

bool AcousticChannel::is_deaf(std::size_t vehicle, const Flight& flight) const {
  const std::optional<double>& began = transmitters_[vehicle].began;
  return began && flight.ends > *began + instant && *began + transmission_ > flight.begins + instant;
}

void AcousticChannel::drown_what_reaches(std::size_t vehicle) {
  for (Flight& flight : std::span{flights_}.first(under_way_)) {
    if (flight.to == vehicle && is_deaf(vehicle, flight)) flight.drowned = true;
  }
}

void AcousticChannel::hand_over(Tick now) {
  const double end = static_cast<double>(count(now)) + instant;
  std::size_t left = 0;
  for (std::size_t i = 0; i < under_way_; ++i) {
    const Flight& flight = flights_[i];
    if (flight.ends > end) {
      flights_[left++] = flight;
    } else if (!flight.is_noise) {
      ++(flight.drowned ? counts_.drowned : flight.collided ? counts_.collided : counts_.received);
      if (flight.drowned || flight.collided) continue;
      ranging_.take(flight.from, flight.to,
                    {clock(flight.from, flight.sent), clock(flight.to, flight.begins)}, flight.answered);
      const Message message = as_read(flight, now);
      Message& known = heard_[flight.to * vehicle_count_ + flight.from];
      if (!known.told || known.sent < message.sent) known = message;
    }
  }
  under_way_ = left;
}

Message AcousticChannel::as_read(const Flight& flight, Tick now) const {
  Message read = flight.message;
  // who speaks tells the time itself
  if (!read.speech.empty() || clocks_are_right()) return read;
  const double wrong = (clock_ahead(flight.from, read.sent) - clock_ahead(flight.to, now)) / period_;
  read.sent =
      std::min(now, Tick{count(read.sent) + std::llround(wrong)});  // nothing is taken to be of the future
  return read;
}

}  // namespace fairway
