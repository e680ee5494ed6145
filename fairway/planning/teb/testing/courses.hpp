// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "fairway/planning/teb/teb.hpp"

/// The courses on which the original was measured: from (0, 0), heading north, to (25, 0), own radius 0.75 m,
/// buoys of 0.3 m, a vessel of 0.75 m that keeps its course, and a decision every 0.2 s.
namespace fairway::courses {

struct Course {
  std::vector<Obstacle> buoys;
  std::optional<Track> vessel;
};

inline Obstacle disc(double n, double e, double radius = 0.3) {
  return {.kind = Obstacle::Kind::sphere, .position = {n, e, 0}, .radius = radius};
}

inline Track vessel(const Vec3& position, const Vec3& velocity) {
  return {.id = TrackId{1}, .position = position, .velocity = velocity, .radius = 0.75, .reacts = false};
}

inline Course u_wall() {
  Course course;
  for (int e = -3; e <= 3; ++e) course.buoys.push_back(disc(6, e));
  for (int n = 3; n <= 5; ++n) {
    course.buoys.push_back(disc(n, -3));
    course.buoys.push_back(disc(n, 3));
  }
  return course;
}

inline Course cluttered() {
  return {
      {disc(5, 0.5), disc(6, -3.5), disc(6.5, 4), disc(9, -1.5), disc(10, 2.5), disc(11, -5), disc(13, 0.5),
       disc(14, -3.5), disc(14.5, 4.5), disc(17, -1), disc(18, 2.5), disc(19, -4.5), disc(21, 0.8)},
      {}};
}

inline Course orthogonal() {
  return {{disc(10, 4), disc(16, -4), disc(18, 3.5)}, vessel({12.5, -6.5, 0}, {0, 0.55, 0})};
}

inline Course diagonal() {
  return {{disc(9, -4), disc(16, 5), disc(19, -3.5)}, vessel({15, -6, 0}, {-0.388909, 0.388909, 0})};
}

/// A vessel that does what it is told at once.
struct Voyage {
  Course course;
  Teb teb;
  Teb::Memory memory{};
  Rng rng{7};
  Vec2 position = Vec2::Zero();
  double yaw{};
  double speed{};
  double yaw_rate{};
  double time{};
  double clearance = 1e9;       ///< least so far, between the spheres [m]
  std::vector<Track> tracks{};  ///< as shown last

  static constexpr double period = 0.2;  ///< between decisions [s]

  Situation situation() {
    tracks.clear();
    if (course.vessel) {
      tracks.push_back(*course.vessel);
      tracks.back().position += time * course.vessel->velocity;
    }
    Situation s;
    s.time = time;
    s.period = period;
    s.own.position = {position.x(), position.y(), 0.0};
    s.own.velocity = {speed * std::cos(yaw), speed * std::sin(yaw), 0.0};
    s.own.yaw = yaw;
    s.own.yaw_rate = yaw_rate;
    s.own.radius = 0.75;
    s.goal = {.position = {25, 0, 0}, .cruise_speed = 1.2, .velocity = {}};
    s.limits.max_speed = 1.5;
    s.tracks = tracks;
    s.obstacles = course.buoys;
    return s;
  }

  Command decide() {
    Context context{rng};
    return teb.decide(situation(), memory, context);
  }

  /// One decision and what follows of it.
  void step() {
    const Command command = decide();
    speed = std::cos(yaw) * command.velocity.x() + std::sin(yaw) * command.velocity.y();
    yaw_rate = command.turn_rate.value_or(0.0);
    constexpr int parts = 10;
    for (int i = 0; i < parts; ++i) {
      yaw += yaw_rate * period / parts;
      position += speed * period / parts * Vec2{std::cos(yaw), std::sin(yaw)};
    }
    time += period;
    clearance = std::fmin(clearance, room());
  }

  /// Until within 0.5 m of the goal; nothing if that takes longer than `limit` [s].
  std::optional<double> arrival(double limit) {
    while (time < limit) {
      step();
      if ((position - Vec2{25, 0}).norm() < 0.5) return time;
    }
    return {};
  }

  /// From the nearest buoy or the vessel [m].
  double room() const {
    double least = 1e9;
    const auto look = [&](const Vec3& there, double radius) {
      least = std::fmin(least, (there.head<2>() - position).norm() - radius - 0.75);
    };
    for (const Obstacle& buoy : course.buoys) look(buoy.position, buoy.radius);
    if (course.vessel) look(course.vessel->position + time * course.vessel->velocity, course.vessel->radius);
    return least;
  }
};

}  // namespace fairway::courses
