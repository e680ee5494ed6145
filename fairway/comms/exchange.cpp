// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/exchange.hpp"

#include <string>

namespace fairway {

Exchange::Exchange(std::string_view kind, const ParamValues& params, std::size_t vehicle_count, double period,
                   Rng rng)
    : period_{period}, way_{way_of(kind, params, vehicle_count, period, rng)} {}

Exchange::Way Exchange::way_of(std::string_view kind, const ParamValues& params, std::size_t vehicle_count,
                               double period, const Rng& rng) {
  require_known(kind, "exchange", exchange_kinds());
  if (kind == "acoustic")
    return AcousticChannel{params_of<AcousticParams>(params), vehicle_count, period, rng};
  if (!params.empty())
    throw InputError({}, params.front().first, std::string(kind) + " exchange takes no parameters");
  if (kind == "none") return Silence{};
  return Everywhere{};
}

void Exchange::pass_on(Tick now, const Mailbox& said, std::span<const Vec3> places,
                       std::span<const Obstacle> obstacles) {
  if (auto* channel = std::get_if<AcousticChannel>(&way_)) channel->pass_on(now, said, places, obstacles);
}

std::optional<AcousticCounts> Exchange::counts() const {
  const auto* channel = std::get_if<AcousticChannel>(&way_);
  return channel != nullptr ? std::optional{channel->counts()} : std::nullopt;
}

std::span<const Message> Exchange::heard_by(std::size_t receiver, std::span<const Message> said) const {
  if (const auto* channel = std::get_if<AcousticChannel>(&way_)) return channel->heard_by(receiver);
  return carries_at_once() ? said : std::span<const Message>{};
}

void Exchange::add_under_way(std::vector<MessageFlight>& flights) const {
  if (const auto* channel = std::get_if<AcousticChannel>(&way_)) channel->add_under_way(flights);
}

bool Exchange::may_take(std::size_t vehicle, Tick now) const {
  const auto* channel = std::get_if<AcousticChannel>(&way_);
  return channel != nullptr ? channel->may_transmit(vehicle, now) : carries_at_once();
}

bool Exchange::has_spoken(std::size_t vehicle, Tick now) const {
  if (const auto* channel = std::get_if<AcousticChannel>(&way_)) return channel->has_spoken(vehicle, now);
  return carries_at_once();
}

double Exchange::turn_period() const {
  const auto* channel = std::get_if<AcousticChannel>(&way_);
  return channel != nullptr ? channel->turn_period() : period_;
}

double Exchange::next_turn(std::size_t vehicle, Tick now) const {
  const auto* channel = std::get_if<AcousticChannel>(&way_);
  return channel != nullptr ? channel->next_turn(vehicle, now) : seconds(next(now), period_);
}

double Exchange::clock_ahead(std::size_t vehicle, Tick now) const {
  const auto* channel = std::get_if<AcousticChannel>(&way_);
  return channel != nullptr ? channel->clock_ahead(vehicle, now) : 0.0;
}

std::span<const std::optional<AcousticRange>> Exchange::ranges_by(std::size_t receiver) const {
  const auto* channel = std::get_if<AcousticChannel>(&way_);
  return channel != nullptr ? channel->ranges_by(receiver) : std::span<const std::optional<AcousticRange>>{};
}

double Exchange::unforeseen_acceleration() const {
  const auto* channel = std::get_if<AcousticChannel>(&way_);
  return channel != nullptr ? channel->params().unforeseen_acceleration_mps2 : 0.0;
}

std::vector<KindInfo> exchange_kinds() {
  return {{.name = "perfect", .title = "Everyone hears everyone at once", .source = "", .params = {}},
          {.name = "none", .title = "Nobody tells anything", .source = "", .params = {}},
          {.name = "acoustic",
           .title = "Acoustic modems: range, rate, delay, loss, half duplex",
           .source = "raja2024 (reach and rate of its team link); docs/exchange.md",
           .params = describe_params<AcousticParams>()}};
}

}  // namespace fairway
