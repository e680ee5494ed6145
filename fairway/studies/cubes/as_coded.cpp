// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/as_coded.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/avoidance/orca3d/columns.hpp"
#include "fairway/core/math.hpp"

namespace fairway::cubes {
namespace {

std::size_t slot(std::uint32_t id) { return id % (2 * max_team); }

/// A velocity over ground in the axes of a level vehicle.
Vec3 in_body_axes(const Vec3& v_n, double yaw) {
  const auto [s, c] = math::sin_cos(yaw);
  return {c * v_n.x() + s * v_n.y(), c * v_n.y() - s * v_n.x(), v_n.z()};
}

using LibraryAgents = std::array<OrcaAsCoded::LibraryAgent, 2 * max_team>;

/// Those inside the library whom somebody has heard of.
struct Known {
  std::array<OrcaAsCoded::LibraryAgent*, 2 * max_team> all;
  std::size_t count{};

  explicit Known(LibraryAgents& agents) {
    for (OrcaAsCoded::LibraryAgent& agent : agents)
      if (agent.known) all[count++] = &agent;
  }
};

struct Pair {
  std::size_t a, b;  ///< of those known; a < b
};

struct Pairs {
  std::array<Pair, max_team * (2 * max_team - 1)> all;
  std::size_t count{};
};

Pairs near_pairs(const Known& known, double range) {
  Pairs pairs;
  for (std::size_t a = 0; a < known.count; ++a) {
    for (std::size_t b = a + 1; b < known.count; ++b) {
      const Vec3 p = known.all[b]->position - known.all[a]->position;
      if (p.squaredNorm() < range * range) pairs.all[pairs.count++] = {a, b};
    }
  }
  return pairs;
}

/// What their neighbours leave those known, side by side.
struct Allowed {
  std::array<std::size_t, 2 * max_team> counts{};
  alignas(64) double half_spaces[2 * max_team - 1][4][2 * max_team];

  void add(std::size_t agent, const Vec3& normal, double offset) {
    auto& columns = half_spaces[counts[agent]++];
    columns[0][agent] = normal.x();
    columns[1][agent] = normal.y();
    columns[2][agent] = normal.z();
    columns[3][agent] = offset;
  }

  /// Gives each of the first `agents` as many as the one has who has most.
  std::size_t even_out(std::size_t agents) {
    const std::size_t most = *std::ranges::max_element(counts);
    for (std::size_t agent = 0; agent < agents; ++agent)
      while (counts[agent] < most) add(agent, Vec3::Zero(), lanes::Programs::nothing);
    return most;
  }
};

/// One of a pair is to change as the other is, the other way round: it is reckoned once for both, of as many
/// pairs at a time as there are lanes, as if the first stood still at the origin and took all of the change.
void allow(const Pairs& pairs, const Known& known, double radius, const OrcaAsCoded::Params& params,
           Allowed& allowed) {
  const lanes::Kernel& kernel = lanes::kernel_for(pairs.count);
  const std::size_t width = kernel.lanes;
  alignas(64) std::array<double, lanes::columns> origin;
  alignas(64) std::array<double, lanes::columns * lanes::most_lanes> others;
  alignas(64) std::array<double, 4 * lanes::most_lanes> change;
  orca::write_columns(Vec3::Zero(), Vec3::Zero(), radius, 0.0, 1, origin.data());
  for (std::size_t first = 0; first < pairs.count; first += width) {
    const std::size_t here = std::min(width, pairs.count - first);
    for (std::size_t lane = 0; lane < width; ++lane) {
      const Pair& pair = pairs.all[first + std::min(lane, here - 1)];
      const OrcaAsCoded::LibraryAgent &a = *known.all[pair.a], &b = *known.all[pair.b];
      orca::write_columns(b.position - a.position, b.velocity - a.velocity, radius, 1.0, width,
                          others.data() + lane);
    }
    kernel.half_spaces(params.time_horizon_s, params.time_step_s, origin.data(), others.data(),
                       change.data());
    for (std::size_t lane = 0; lane < here; ++lane) {
      const auto [a, b] = pairs.all[first + lane];
      const Vec3 normal{change[lane], change[width + lane], change[2 * width + lane]};
      const double half = 0.5 * change[3 * width + lane];
      allowed.add(a, normal, normal.dot(known.all[a]->velocity) + half);
      allowed.add(b, -normal, half - normal.dot(known.all[b]->velocity));
    }
  }
}

/// Has all of them choose, as many at a time as there are lanes.
void choose(const Known& known, Allowed& allowed, double max_speed) {
  constexpr std::size_t most = 2 * max_team;
  const lanes::Kernel& kernel = lanes::kernel_for(known.count);
  alignas(64) std::array<double, 3 * most> preferred{};
  alignas(64) std::array<double, 3 * lanes::most_lanes> chosen;
  for (std::size_t i = 0; i < known.count; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      preferred[c * most + i] = known.all[i]->preferred[static_cast<Eigen::Index>(c)];
  const std::size_t width = kernel.lanes;
  const std::size_t half_spaces = allowed.even_out((known.count + width - 1) / width * width);
  for (std::size_t first = 0; first < known.count; first += width) {
    kernel.choose({half_spaces, most, allowed.half_spaces[0][0] + first, preferred.data() + first, max_speed},
                  chosen.data());
    for (std::size_t lane = 0; lane < std::min(width, known.count - first); ++lane)
      known.all[first + lane]->velocity = {chosen[lane], chosen[width + lane], chosen[2 * width + lane]};
  }
}

}  // namespace

std::span<const std::size_t> MessageOrder::of(std::span<const Track> tracks, Rng& rng) {
  if (!drawn_) {
    for (double& phase : phase_) phase = rng.uniform(0.0, 1.0);
    drawn_ = true;
  }
  const std::size_t count = std::min(tracks.size(), order_.size());
  for (std::size_t i = 0; i < count; ++i) order_[i] = i;
  std::sort(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(count),
            [&](std::size_t a, std::size_t b) {
              return phase_[slot(number(tracks[a].id))] < phase_[slot(number(tracks[b].id))];
            });
  return {order_.data(), count};
}

Command ApfAsCoded::decide(const Situation& s, Memory& memory, Context&) const noexcept {
  // each message adds its repulsion; the sum is zeroed only as the last neighbour leaves
  for (const Track& track : s.tracks) {
    const Vec3 away = s.own.position - track.position;
    const double distance = away.norm();
    bool& near = memory.near[slot(number(track.id))];
    const bool was_near = near;
    near = distance <= params.crit_dist_m;
    if (near && distance > 0.0) {
      memory.v_obs += (params.crit_dist_m - distance) / params.crit_dist_m * (away / distance);
    } else if (was_near && std::ranges::none_of(memory.near, [](bool n) { return n; })) {
      memory.v_obs.setZero();
    }
  }
  const bool anyone_near = std::ranges::any_of(memory.near, [](bool n) { return n; });

  const Vec3 v_f = params.w1_ratio * unit(s.goal.position - s.own.position) + params.w2_ratio * memory.v_obs;
  const double speed = s.goal.cruise_speed;
  const double horizontal = horizontal_norm(v_f);
  const double surge = params.bang_bang ? speed : math::fmin(horizontal, speed);
  Vec3 velocity = horizontal > 0.0 ? Vec3{surge / horizontal * v_f} : Vec3{Vec3::Zero()};
  velocity.z() = params.bang_bang ? std::copysign(speed, v_f.z()) : std::clamp(v_f.z(), -speed, speed);
  return {.velocity = velocity, .mode = anyone_near ? Mode::avoid : Mode::cruise, .astern = anyone_near};
}

void OrcaAsCoded::step_library(Memory& memory, const Situation& s) const noexcept {
  // everyone in the library chooses on the same instant
  const Known known{memory.agents};
  Allowed allowed;
  allow(near_pairs(known, params.crit_dist_m), known, s.own.radius, params, allowed);
  choose(known, allowed, s.goal.cruise_speed);

  // and moves, until its own next message puts it back
  for (LibraryAgent* agent : std::span{known.all}.first(known.count))
    agent->position += params.time_step_s * agent->velocity;
}

Command OrcaAsCoded::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  LibraryAgent& own = memory.agents[slot(number(s.own.id))];
  const double speed = s.goal.cruise_speed;
  const Vec3 own_velocity = in_body_axes(s.own.velocity, s.own.yaw);
  const LibraryAgent told{s.own.position, own_velocity, speed * unit(s.goal.position - s.own.position), true};
  bool anyone_near = false;

  for (const std::size_t i : memory.order.of(s.tracks, context.rng)) {
    const Track& track = s.tracks[i];
    anyone_near = anyone_near || (track.position - s.own.position).norm() <= params.crit_dist_m;

    LibraryAgent& neighbour = memory.agents[slot(number(track.id))];
    if (track.destination) neighbour.preferred = speed * unit(*track.destination - track.position);
    neighbour.position = track.position;
    neighbour.velocity = in_body_axes(track.velocity, track.yaw);
    neighbour.known = true;
    own = told;
    step_library(memory, s);
  }
  const Vec3 velocity = s.tracks.empty() ? s.preferred_velocity() : own.velocity;
  return {.velocity = velocity, .mode = anyone_near ? Mode::avoid : Mode::cruise, .astern = anyone_near};
}

Command StopAndWaitAsCoded::decide(const Situation& s, Avoider& inner, Memory& memory,
                                   Context& context) const noexcept {
  Command command = StopAndWait{{.crit_dist_m = params.crit_dist_m}}.decide(s, inner, memory.rule, context);
  if (command.mode == Mode::hold) {
    memory.waiting = true;
    memory.released = s.time + params.release_s;
    return command;
  }
  memory.waiting = memory.waiting && s.time < memory.released;
  return memory.waiting ? Command{.mode = Mode::hold} : command;
}

}  // namespace fairway::cubes
