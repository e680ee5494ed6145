// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/as_heard.hpp"

#include <algorithm>
#include <cmath>

namespace fairway::cubes {
namespace {

constexpr auto kept = static_cast<std::int64_t>(AsHeard::ticks_kept);

std::size_t place_of(TrackId id) { return number(id) % AsHeard::most_robots; }
std::size_t place_of(std::int64_t tick) { return static_cast<std::size_t>(tick % kept); }

/// Whole ticks in a time, no more than are kept.
std::int64_t ticks_of(double seconds, double period) {
  return std::min<std::int64_t>(std::llround(seconds / period), kept - 1);
}

Vec3 noise(double sigma, Rng& rng) {
  const double n = rng.normal(), e = rng.normal(), d = rng.normal();
  return sigma * Vec3{n, e, d};
}

}  // namespace

void AsHeard::begin(const Situation& s, Memory& memory, Rng& rng) const noexcept {
  memory.begun = true;
  memory.first.fill(-1);
  for (double& phase : memory.phase) phase = params.out_of_step ? rng.uniform(0.0, 1.0) : 0.0;
  memory.own_due = s.time + params.own_period_s * rng.uniform(0.0, 1.0);
  memory.own = s.own;
}

Track AsHeard::heard(const Track& track, const Situation& s, const Memory& memory, Rng& rng) const noexcept {
  const std::size_t place = place_of(track.id);
  const double late = params.late_s + params.jitter_s * rng.uniform(0.0, 1.0);
  const std::int64_t age = std::min(ticks_of(late, s.period), memory.tick - memory.first[place]);
  const Said& said = memory.said[place][place_of(memory.tick - age)];
  Track told = track;
  told.position = said.position - memory.phase[place] * s.period * said.velocity;
  told.velocity = said.velocity;
  told.yaw = said.yaw;
  if (params.noise_m > 0.0) told.position += noise(params.noise_m, rng);
  return told;
}

Command AsHeard::decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept {
  Rng& rng = context.rng;
  if (!memory.begun) begin(s, memory, rng);

  // what it knows of itself
  if (s.time >= memory.own_due) {
    memory.own = s.own;
    if (params.noise_m > 0.0) memory.own.position += noise(params.noise_m, rng);
    memory.own_due += params.own_period_s;
  }

  // what it hears of the others
  std::array<Track, most_robots> tracks;
  std::size_t count = 0;
  for (const Track& track : s.tracks.first(std::min(s.tracks.size(), most_robots))) {
    const std::size_t place = place_of(track.id);
    if (memory.first[place] < 0) memory.first[place] = memory.tick;
    memory.said[place][place_of(memory.tick)] = {track.position, track.velocity, track.yaw};
    if (rng.uniform(0.0, 1.0) >= params.lost_ratio) tracks[count++] = heard(track, s, memory, rng);
  }
  Situation known = s;
  known.own = memory.own;
  known.own.priority = s.own.priority;
  known.tracks = {tracks.data(), count};

  // what becomes of what it decides
  memory.decided[place_of(memory.tick)] = inner.decide(known, context.sketch);
  const std::int64_t ago = std::min(ticks_of(params.command_late_s, s.period), memory.tick);
  Command command = memory.decided[place_of(memory.tick - ago)];
  ++memory.tick;
  return command;
}

}  // namespace fairway::cubes
