// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway::velocity_obstacle {

/// Two who follow what the same method commands them as fast as their acceleration allows, 0.1 s a step,
/// each straight for its goal at its cruise speed at first.
struct Meeting {
  std::array<Ownship, 2> vessels;
  std::array<Goal, 2> goals;
  double max_acceleration{};  ///< [m/s2]

  double gap() const {
    return (vessels[0].position - vessels[1].position).norm() - vessels[0].radius - vessels[1].radius;
  }
};

/// From anywhere 8 to 16 m round a point to as far beyond it at 0.3 to 1.5 m/s, radii of 0.5 to 2 m, 0.2 to
/// 1 m/s2; a start that leaves less than 6 m of room, or goals less than 1 m, is drawn again.
inline Meeting any_meeting(Rng rng) {
  Meeting m;
  double room_to_stay = 0.0;
  do {
    m.max_acceleration = rng.uniform(0.2, 1.0);
    const double radius = rng.uniform(0.5, 2.0);
    for (std::uint32_t k = 0; k < 2; ++k) {
      const double angle = k == 0 ? rng.uniform(-pi, pi) : 0.0;
      const Vec3 out = rng.uniform(8.0, 16.0) * Vec3{std::cos(angle), std::sin(angle), 0.0};
      const double speed = rng.uniform(0.3, 1.5);
      m.vessels[k] = {.id = VehicleId{k},
                      .position = out,
                      .velocity = -speed * unit(out),
                      .yaw = std::atan2(-out.y(), -out.x()),
                      .radius = radius};
      m.goals[k] = {.position = -out, .cruise_speed = speed};
    }
    room_to_stay = (m.goals[0].position - m.goals[1].position).norm() - 2.0 * radius;
  } while (m.gap() < 6.0 || room_to_stay < 1.0);
  return m;
}

struct Outcome {
  double least_gap{};        ///< [m]
  bool arrived = false;      ///< both, within 150 s
  bool port_to_port = true;  ///< each had the other to port when they were nearest
};

/// Both decide by `algorithm`, which remembers nothing.
template <class Algorithm>
Outcome outcome_of(Meeting m, const Algorithm& algorithm) {
  constexpr double period = 0.1;
  Outcome outcome{.least_gap = m.gap()};
  for (int step = 0; step < 1500 && !outcome.arrived; ++step) {
    std::array<Command, 2> commands;
    for (std::uint32_t k = 0; k < 2; ++k) {
      const Ownship& other = m.vessels[1 - k];
      const std::array<Track, 1> tracks{
          encounters::track(1 - k, other.position, other.velocity, other.radius)};
      Rng rng{0};
      Context context{rng};
      NoMemory memory;
      commands[k] = algorithm.decide({.period = period,
                                      .own = m.vessels[k],
                                      .goal = m.goals[k],
                                      .limits = {.max_speed = 1.5, .max_acceleration = m.max_acceleration},
                                      .tracks = tracks},
                                     memory, context);
    }
    for (std::uint32_t k = 0; k < 2; ++k) {
      Ownship& own = m.vessels[k];
      own.velocity += clamp_norm(commands[k].velocity - own.velocity, m.max_acceleration * period);
      own.position += period * own.velocity;
      own.yaw = std::atan2(own.velocity.y(), own.velocity.x());
    }
    if (m.gap() < outcome.least_gap) {
      outcome.least_gap = m.gap();
      const Vec3 p = m.vessels[1].position - m.vessels[0].position;
      const auto side = [&](const Vec3& v) { return v.x() * p.y() - v.y() * p.x(); };
      outcome.port_to_port = side(m.vessels[0].velocity) < 0.0 && side(m.vessels[1].velocity) > 0.0;
    }
    const auto left = [&](std::size_t k) { return (m.goals[k].position - m.vessels[k].position).norm(); };
    outcome.arrived = left(0) < 0.5 && left(1) < 0.5;
  }
  return outcome;
}

/// What many meetings came to.
struct Tally {
  int touched = 0;
  int arrived = 0;
  double least_gap = Limits::none;  ///< [m]
};

template <class Algorithm>
Tally tally(int meetings, const Algorithm& algorithm) {
  Tally all;
  for (int i = 0; i < meetings; ++i) {
    const Outcome outcome =
        outcome_of(any_meeting(Rng{2}.stream("meeting", static_cast<std::uint64_t>(i))), algorithm);
    all.touched += outcome.least_gap < -1e-9 ? 1 : 0;
    all.arrived += outcome.arrived ? 1 : 0;
    all.least_gap = std::min(all.least_gap, outcome.least_gap);
  }
  return all;
}

/// Two of one kind on one line, end to end, heading for each other on a course turned by `angle`.
inline Meeting head_to_head(double distance, double speed, double max_acceleration, double angle) {
  Meeting m{.max_acceleration = max_acceleration};
  for (std::uint32_t k = 0; k < 2; ++k) {
    const double course = angle + pi * k;
    const Vec3 ahead{std::cos(course), std::sin(course), 0.0};
    m.vessels[k] = {.id = VehicleId{k},
                    .position = -0.5 * distance * ahead,
                    .velocity = speed * ahead,
                    .yaw = wrap_angle(course)};
    m.goals[k] = {.position = 0.5 * distance * ahead, .cruise_speed = speed};
  }
  return m;
}

/// The same, of 10 to 30 m, 0.3 to 1.5 m/s, 0.2 to 1 m/s2, on any course.
inline Meeting any_head_to_head(Rng rng) {
  const double distance = rng.uniform(10.0, 30.0);
  const double speed = rng.uniform(0.3, 1.5);
  const double max_acceleration = rng.uniform(0.2, 1.0);
  return head_to_head(distance, speed, max_acceleration, rng.uniform(-pi, pi));
}

/// Two alike who meet head to head, on 200 such courses: each passes the other port to port, without a touch.
template <class Algorithm>
void expect_port_to_port(const Algorithm& algorithm) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Outcome outcome = outcome_of(any_head_to_head(Rng{3}.stream("head to head", i)), algorithm);
    EXPECT_TRUE(outcome.port_to_port) << i;
    EXPECT_TRUE(outcome.arrived) << i;
    EXPECT_GT(outcome.least_gap, -1e-9) << i;
  }
}

}  // namespace fairway::velocity_obstacle
