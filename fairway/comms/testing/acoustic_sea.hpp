// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "fairway/comms/acoustic_channel.hpp"

// Vehicles at fixed places that tell each other the tick, for tests of the acoustic channel.

namespace fairway::acoustic_sea {

inline constexpr double tick_s = 0.05;

/// Every vehicle says at each tick how many ticks have gone by: its position is {tick, index, 0}.
struct Sea {
  AcousticChannel channel;
  Mailbox said;
  std::vector<Vec3> places;
  Tick now{0};

  Sea(const AcousticParams& params, std::vector<Vec3> where, std::uint64_t seed = 1)
      : channel{params, where.size(), tick_s, Rng{seed}}, said(where.size()), places{std::move(where)} {
    for (std::size_t i = 0; i < said.size(); ++i) said[i].from = VehicleId{static_cast<std::uint32_t>(i)};
  }

  void tick() {
    for (std::size_t i = 0; i < said.size(); ++i) {
      said[i].sent = now;
      said[i].position = {static_cast<double>(count(now)), static_cast<double>(i), 0};
    }
    channel.pass_on(now, said, places);
    now = next(now);
  }

  void run(double duration) {
    const Tick end{count(now) + std::llround(duration / tick_s)};
    while (now < end) tick();
  }

  const Message& heard(std::size_t receiver, std::size_t sender) const {
    return channel.heard_by(receiver)[sender];
  }
  const AcousticCounts& counts() const { return channel.counts(); }
};

/// Two vehicles `distance` apart [m].
inline std::vector<Vec3> pair(double distance) { return {{0, 0, 0}, {0, distance, 0}}; }

/// `n` vehicles in a row, 5 m from one to the next.
inline std::vector<Vec3> row(std::size_t n) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < n; ++i) places.push_back({0, 5.0 * static_cast<double>(i), 0});
  return places;
}

}  // namespace fairway::acoustic_sea
