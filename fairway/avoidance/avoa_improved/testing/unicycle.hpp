// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "fairway/avoidance/avoa_improved/avoa_improved.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/angles.hpp"

/// A vessel that turns like a ship, and the courses it is to sail, for tests and measurements.
namespace fairway::avoa_improved {

/// Speed and turn rate follow what is commanded with a lag, within limits; no sideslip.
struct Unicycle {
  Vec2 position = Vec2::Zero();  ///< [m, NED]
  double yaw{};                  ///< [rad]
  double yaw_rate{};             ///< [rad/s]
  double speed{};                ///< through the water [m/s]

  double max_speed{1.5};
  double max_reverse{0.5};
  double max_turn_rate{0.3751};
  double max_acceleration{0.5};
  double max_turn_acceleration{0.5};
  double time_constant{0.5};
  double turn_gain{1.0};
  Vec2 current = Vec2::Zero();  ///< [m/s, NED]

  Vec2 velocity() const { return speed * Vec2{std::cos(yaw), std::sin(yaw)} + current; }

  /// Carries out a command for `duration` seconds.
  void sail(const Command& command, double duration) {
    constexpr int parts = 20;
    const double h = duration / parts;
    const Vec2 wanted = command.velocity.head<2>();
    double surge = wanted.norm();
    double rate = 0.0;
    if (command.turn_rate) {
      surge = wanted.dot(Vec2{std::cos(yaw), std::sin(yaw)});
      rate = *command.turn_rate;
    } else if (surge > 0.0) {
      rate = turn_gain * wrap_angle(std::atan2(wanted.y(), wanted.x()) - yaw);
    }
    surge = std::clamp(surge, -max_reverse, max_speed);
    rate = std::clamp(rate, -max_turn_rate, max_turn_rate);
    for (int i = 0; i < parts; ++i) {
      speed += h * std::clamp((surge - speed) / time_constant, -max_acceleration, max_acceleration);
      yaw_rate +=
          h * std::clamp((rate - yaw_rate) / time_constant, -max_turn_acceleration, max_turn_acceleration);
      yaw = wrap_angle(yaw + h * yaw_rate);
      position += h * velocity();
    }
  }
};

/// What a vessel of 0.75 m meets between the origin and its goal.
struct Course {
  std::vector<Obstacle> buoys;
  std::vector<Track> vessels;
  Unicycle start;
  Vec2 goal{25.0, 0.0};
  double sight = 1e9;  ///< from own sphere to the surface of what is seen [m]
};

inline Obstacle buoy(double north, double east) {
  return {.kind = Obstacle::Kind::sphere, .position = {north, east, 0.0}, .radius = 0.3};
}

/// A U of buoys 1 m apart, open towards the start: a wall at `north`, arms of `depth` at +-`half` [m].
inline Course u_shape(int north, int half, int depth) {
  Course course;
  for (int e = -half; e <= half; ++e) course.buoys.push_back(buoy(north, e));
  for (int k = 1; k <= depth; ++k) {
    course.buoys.push_back(buoy(north - k, -half));
    course.buoys.push_back(buoy(north - k, half));
  }
  return course;
}

struct Passage {
  double clearance = 1e9;  ///< least, between hulls [m]
  double arrival = -1.0;   ///< first within 1 m of the goal [s]
  int side_changes = 0;    ///< of the turn commanded, where it is more than 30 degrees to either side
  int infeasible = 0;      ///< decisions
  std::vector<Vec2> path;  ///< at each decision
};

/// Sails a course with decisions at 5 Hz, at 1.2 m/s of at most 1.5 m/s.
inline Passage passage(const Course& course, Avoider avoider, double duration = 120.0) {
  constexpr double period = 0.2;
  Unicycle boat = course.start;
  std::vector<Track> vessels = course.vessels;
  std::vector<Obstacle> in_sight;
  Passage p;
  double last_side = 0.0;
  for (int k = 0; k < static_cast<int>(duration / period); ++k) {
    // what it sees
    in_sight.clear();
    for (const Obstacle& b : course.buoys) {
      const double gap = (b.position.head<2>() - boat.position).norm() - b.radius - 0.75;
      p.clearance = std::fmin(p.clearance, gap);
      if (gap <= course.sight) in_sight.push_back(b);
    }
    for (const Track& t : vessels)
      p.clearance = std::fmin(p.clearance, (t.position.head<2>() - boat.position).norm() - t.radius - 0.75);
    p.path.push_back(boat.position);
    if ((boat.position - course.goal).norm() <= 1.0) {
      p.arrival = k * period;
      break;
    }
    Situation s{.time = k * period, .period = period};
    s.own = {.id = VehicleId{0},
             .position = {boat.position.x(), boat.position.y(), 0.0},
             .velocity = {boat.velocity().x(), boat.velocity().y(), 0.0},
             .yaw = boat.yaw,
             .yaw_rate = boat.yaw_rate,
             .radius = 0.75};
    s.goal = {.position = {course.goal.x(), course.goal.y(), 0.0}, .cruise_speed = 1.2};
    s.limits = {.max_speed = 1.5, .max_acceleration = 0.5, .max_turn_rate = boat.max_turn_rate};
    s.tracks = vessels;
    s.obstacles = in_sight;

    // what it does
    const Command command = avoider.decide(s);
    p.infeasible += command.mode == Mode::infeasible ? 1 : 0;
    const double heading = std::atan2(command.velocity.y(), command.velocity.x());
    const double turn = command.velocity.isZero(0.0) ? 0.0 : wrap_angle(heading - boat.yaw);
    if (std::abs(turn) > radians(30.0)) {
      const double side = turn > 0.0 ? 1.0 : -1.0;
      p.side_changes += last_side * side < 0.0 ? 1 : 0;
      last_side = side;
    }
    boat.sail(command, period);
    for (Track& t : vessels) t.position += period * t.velocity;
  }
  return p;
}

}  // namespace fairway::avoa_improved
