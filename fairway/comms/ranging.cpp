// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/ranging.hpp"

#include <cstdint>

namespace fairway {

Ranging::Ranging(const Settings& settings, std::size_t vehicle_count, const Rng& rng)
    : settings_{settings}, vehicle_count_{vehicle_count} {
  if (settings.kind == RangingKind::none) return;
  for (std::size_t to = 0; to < vehicle_count; ++to) {
    const Rng receiver = rng.stream("ranging", to);
    for (std::size_t from = 0; from < vehicle_count; ++from)
      pairs_.push_back({receiver.stream("sender", from)});
  }
  ranges_.resize(pairs_.size());
}

std::optional<Ranging::Way> Ranging::answered(std::size_t from, std::size_t to) const {
  if (settings_.kind != RangingKind::two_way) return {};
  return pairs_[from * vehicle_count_ + to].latest;
}

void Ranging::take(std::size_t from, std::size_t to, const Way& way, const std::optional<Way>& answered) {
  if (settings_.kind == RangingKind::none) return;
  const std::size_t place = to * vehicle_count_ + from;
  Pair& pair = pairs_[place];
  if (pair.latest && pair.latest->sent >= way.sent) return;
  pair.latest = way;
  if (settings_.kind == RangingKind::two_way && !answered) return;

  const double took =
      answered ? 0.5 * ((way.heard - answered->sent) - (way.sent - answered->heard)) : way.heard - way.sent;
  ranges_[place] =
      AcousticRange{.to = VehicleId{static_cast<std::uint32_t>(from)},
                    .distance = settings_.sound_speed * took + settings_.deviation * pair.noise.normal(),
                    .deviation = settings_.deviation,
                    .out = answered ? answered->sent : way.heard,
                    .back = way.heard};
}

std::span<const std::optional<AcousticRange>> Ranging::by(std::size_t receiver) const {
  if (ranges_.empty()) return {};
  return std::span{ranges_}.subspan(receiver * vehicle_count_, vehicle_count_);
}

}  // namespace fairway
