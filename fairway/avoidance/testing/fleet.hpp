// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway::encounters {

/// Some who each go for a place in the plane and take up what is decided with a lag.
struct Fleet {
  double cruise_speed = 0.5;  ///< [m/s]
  double max_speed = 0.5;     ///< [m/s]
  double lag = 0.5;           ///< [s]
  std::vector<Ownship> ships;
  std::vector<Vec3> goals;
  std::vector<Obstacle> obstacles;
  double separation = 1e9;  ///< least so far, between centres [m]

  void add(const Vec3& from, const Vec3& to) {
    ships.push_back({.id = VehicleId{static_cast<std::uint32_t>(ships.size())}, .position = from});
    goals.push_back(to);
  }

  int arrived() const {
    int count = 0;
    for (std::size_t i = 0; i < ships.size(); ++i) count += (ships[i].position - goals[i]).norm() < 1.0;
    return count;
  }

  std::vector<Track> seen_by(std::size_t own) const {
    std::vector<Track> tracks;
    for (std::size_t i = 0; i < ships.size(); ++i) {
      if (i == own) continue;
      tracks.push_back(track(number(ships[i].id), ships[i].position, ships[i].velocity));
    }
    const auto distance = [&](const Track& t) { return (t.position - ships[own].position).norm(); };
    std::ranges::stable_sort(tracks, {}, distance);
    return tracks;
  }

  /// Under `avoider_of(i)`, from rest.
  template <class AvoiderOf>
  void sail(double duration, AvoiderOf avoider_of) {
    constexpr double period = 0.1;
    std::vector<Avoider> avoiders;
    for (std::size_t i = 0; i < ships.size(); ++i) avoiders.push_back(avoider_of(i));
    for (int tick = 0; tick * period < duration; ++tick) {
      std::vector<Vec3> wanted;
      for (std::size_t i = 0; i < ships.size(); ++i) {
        const std::vector<Track> tracks = seen_by(i);
        if (!tracks.empty())
          separation = std::fmin(separation, (tracks[0].position - ships[i].position).norm());
        wanted.push_back(avoiders[i]
                             .decide({.time = tick * period,
                                      .period = period,
                                      .own = ships[i],
                                      .goal = {.position = goals[i], .cruise_speed = cruise_speed},
                                      .limits = {.max_speed = max_speed, .max_climb_rate = 0.0},
                                      .tracks = tracks,
                                      .obstacles = obstacles})
                             .velocity);
      }
      for (std::size_t i = 0; i < ships.size(); ++i) {
        ships[i].velocity += period / lag * (wanted[i] - ships[i].velocity);
        ships[i].position += period * ships[i].velocity;
      }
    }
  }
};

}  // namespace fairway::encounters
