// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/embed/avoider.hpp"

namespace fairway::embed {

inline Triple plain(const Vec3& a) { return {a.x(), a.y(), a.z()}; }
inline SixAxes plain(const Wrench& a) { return {a[0], a[1], a[2], a[3], a[4], a[5]}; }
inline Matrix3 plain(const Mat3& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

inline Envelope plain(const fairway::Envelope& e) {
  return {e.ahead,
          e.astern,
          e.sideways,
          e.up,
          e.down,
          e.least,
          e.acceleration,
          e.deceleration,
          e.surge_lag,
          e.turn_acceleration,
          e.turn_lag,
          e.pivot,
          e.sway_lag,
          e.turn_rates,
          e.following_errors,
          e.deceleration_lost,
          e.turn_tail,
          e.slip_square,
          e.turn_plateau,
          e.foresight_error};
}

/// A situation of the C++20 library as a host would put it, with what it points to.
struct PlainSituation {
  explicit PlainSituation(const fairway::Situation& s) {
    for (const fairway::Track& t : s.tracks) {
      Track track;
      track.position = plain(t.position);
      track.velocity = plain(t.velocity);
      track.destination = plain(t.destination.value_or(Vec3::Zero()));
      track.has_destination = t.destination.has_value();
      track.position_covariance = plain(t.position_covariance);
      track.velocity_covariance = plain(t.velocity_covariance);
      track.yaw = t.yaw;
      track.radius = t.radius;
      track.age = t.age;
      track.id = number(t.id);
      track.priority = t.priority;
      track.reacts = t.reacts;
      tracks.push_back(track);
    }
    corners.reserve(s.obstacles.size());
    for (const fairway::Obstacle& o : s.obstacles) {
      std::vector<Triple>& vertices = corners.emplace_back();
      for (const Vec3& v : o.vertices) vertices.push_back(plain(v));
      Obstacle obstacle;
      obstacle.position = plain(o.position);
      obstacle.from = plain(o.from);
      obstacle.to = plain(o.to);
      obstacle.radius = o.radius;
      obstacle.vertices = vertices.data();
      obstacle.vertex_count = vertices.size();
      obstacle.kind = static_cast<ObstacleKind>(o.kind);
      obstacle.charted = o.charted;
      obstacles.push_back(obstacle);
    }
    situation.own = {plain(s.own.position), plain(s.own.velocity), s.own.yaw,     s.own.yaw_rate,
                     s.own.radius,          number(s.own.id),      s.own.priority};
    situation.goal = {plain(s.goal.position), plain(s.goal.velocity.value_or(Vec3::Zero())),
                      s.goal.cruise_speed, s.goal.velocity.has_value(), s.goal.arrival};
    situation.limits = {s.limits.max_speed,     s.limits.max_climb_rate, s.limits.max_acceleration,
                        s.limits.max_turn_rate, s.limits.min_depth,      s.limits.max_depth,
                        s.limits.min_speed,     s.limits.sternway,       s.limits.sway};
    situation.time = s.time;
    situation.period = s.period;
    situation.current = plain(s.current);
    if (s.model != nullptr) {
      model = {plain(s.model->mass),      plain(s.model->linear_damping), plain(s.model->quadratic_damping),
               plain(s.model->restoring), plain(s.model->least),          plain(s.model->greatest)};
    }
    if (s.envelope != nullptr) envelope = plain(*s.envelope);
  }

  /// Valid while this is, and until it is changed.
  Situation view() const {
    Situation s = situation;
    s.tracks = tracks.data();
    s.track_count = tracks.size();
    s.obstacles = obstacles.data();
    s.obstacle_count = obstacles.size();
    s.model = model ? &*model : nullptr;
    s.envelope = envelope ? &*envelope : nullptr;
    return s;
  }

  Situation situation;
  std::vector<Track> tracks;
  std::vector<Obstacle> obstacles;
  std::vector<std::vector<Triple>> corners;
  std::optional<OnboardModel> model;
  std::optional<Envelope> envelope;
};

/// Every number of two answers is the same, to the bit as far as == tells.
inline bool same(const Command& a, const fairway::Command& b) {
  return a.velocity == plain(b.velocity) && static_cast<int>(a.mode) == static_cast<int>(b.mode) &&
         a.astern == b.astern && a.has_heading == b.heading.has_value() &&
         a.heading == b.heading.value_or(0.0) && a.has_turn_rate == b.turn_rate.has_value() &&
         a.turn_rate == b.turn_rate.value_or(0.0) && a.has_wrench == b.wrench.has_value() &&
         a.wrench == plain(b.wrench.value_or(Wrench::Zero())) && a.note == b.note;
}

}  // namespace fairway::embed
