// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::uuv {
namespace {

constexpr double slower_ratio = 0.97;    // of the speed that there was or should be
constexpr double aside_angle = 0.05236;  // 3 degrees [rad]

/// Between two directions; of a standstill, the largest.
double angle_between(const Vec2& a, const Vec2& b) {
  if (a.isZero(1e-9) || b.isZero(1e-9)) return pi;
  return std::abs(math::atan2(cross(a, b), a.dot(b)));
}

}  // namespace

Timeline::Timeline(const Scenario& scenario)
    : ways_(scenario.vehicles.size()),
      vehicle_gap_{std::numeric_limits<double>::infinity()},
      ship_gap_{std::numeric_limits<double>::infinity()} {
  for (const VehicleSpec& vehicle : scenario.vehicles) radii_.push_back(vehicle.radius_m);
  std::ranges::copy_if(scenario.obstacles, std::back_inserter(ships_), &ObstacleSpec::moves);
}

void Timeline::write(const Frame& frame) {
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
    see_vehicle(frame, i);
    see_ships(frame, i);
  }
}

void Timeline::see_vehicle(const Frame& frame, std::size_t index) {
  const VehicleFrame& vehicle = frame.vehicles[index];
  Sample sample{.time = frame.time,
                .position = vehicle.state.p_n.head<2>(),
                .velocity = vehicle.state.v_n().head<2>(),
                .goal = vehicle.goal.head<2>(),
                .wanted_speed = vehicle.goal_speed,
                .nearest = std::numeric_limits<double>::infinity(),
                .arrived = vehicle.phase == Phase::arrived};
  for (std::size_t j = 0; j < frame.vehicles.size(); ++j) {
    if (j == index) continue;
    const Vec2 towards = frame.vehicles[j].state.p_n.head<2>() - sample.position;
    vehicle_gap_ = math::fmin(vehicle_gap_, towards.norm() - radii_[index] - radii_[j]);
    if (towards.norm() >= sample.nearest) continue;
    sample.nearest = towards.norm();
    sample.towards = towards;
  }
  ways_[index].push_back(sample);
}

void Timeline::see_ships(const Frame& frame, std::size_t index) {
  for (const ObstacleSpec& ship : ships_) {
    const Vec3 there = ship.position + frame.time * ship.velocity;
    const double distance = (there - frame.vehicles[index].state.p_n).norm();
    ship_gap_ = math::fmin(ship_gap_, distance - ship.radius - radii_[index]);
  }
}

Events Timeline::events(std::size_t index) const {
  const Way& way = ways_[index];
  Events events;
  const auto end = std::ranges::find_if(way, &Sample::arrived);
  if (end != way.end()) events.arrive = end->time;
  if (end == way.begin()) return events;
  const Vec2 start = way.front().position;
  const Vec2 goal = way.front().goal;
  const auto off_course = [](const Sample& s) { return angle_between(s.velocity, s.goal - s.position); };

  // first signs of avoiding, and the farthest that it led aside
  double greatest_speed = 0.0, farthest = 0.0;
  for (auto sample = way.begin(); sample != end; ++sample) {
    const double speed = sample->velocity.norm();
    greatest_speed = math::fmax(greatest_speed, speed);
    if (!events.slow_down && speed < slower_ratio * greatest_speed) events.slow_down = sample->time;
    const bool moves = speed > 0.1 * sample->wanted_speed;
    if (!events.aside && moves && off_course(*sample) > aside_angle) events.aside = sample->time;
    const double off_line = std::abs(cross((goal - start).normalized(), sample->position - start));
    if (off_line > farthest) {
      farthest = off_line;
      if (events.aside) events.turn_back = sample->time;
    }
  }

  // the other at its nearest
  const auto pass = std::ranges::min_element(way.begin(), end, {}, &Sample::nearest);
  events.pass = pass->time;
  events.keeps_right = cross(goal - start, pass->towards) < 0.0;

  // the last instant at which it was not yet as it should be
  const auto as_wanted = [&](const Sample& s) {
    return s.velocity.norm() >= slower_ratio * s.wanted_speed && off_course(s) <= aside_angle;
  };
  auto resume = end;
  while (resume != way.begin() && as_wanted(*(resume - 1))) --resume;
  if ((events.aside || events.slow_down) && resume != end) events.resume = resume->time;

  // at its slowest between
  const double begins =
      math::fmin(events.slow_down.value_or(events.pass), events.aside.value_or(events.pass));
  events.least_speed = std::numeric_limits<double>::infinity();
  for (auto sample = way.begin(); sample != resume; ++sample) {
    if (sample->time < begins || sample->velocity.norm() >= events.least_speed) continue;
    events.slowest = sample->time;
    events.least_speed = sample->velocity.norm();
  }
  return events;
}

void Timeline::report(std::vector<Measure>& measures) const {
  double right = 0.0;
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    const Events found = events(i);
    const auto add = [&](std::string quantity, std::optional<double> value) {
      if (value) measures.push_back({std::move(quantity), static_cast<int>(i), *value});
    };
    add("aside_time_s", found.aside);
    add("slow_down_time_s", found.slow_down);
    add("pass_time_s", found.pass);
    if (std::isfinite(found.least_speed)) {
      add("slowest_time_s", found.slowest);
      add("least_speed_mps", found.least_speed);
    }
    add("turn_back_time_s", found.turn_back);
    add("resume_time_s", found.resume);
    add("arrive_time_s", found.arrive);
    right += found.keeps_right ? 1.0 : 0.0;
  }
  const auto add = [&](std::string quantity, double value) {
    measures.push_back({std::move(quantity), Measure::fleet, value});
  };
  add("vehicle_gap_m", vehicle_gap_);
  if (!ships_.empty()) add("ship_gap_m", ship_gap_);
  add("contact_count", (vehicle_gap_ < 0.0 ? 1.0 : 0.0) + (ship_gap_ < 0.0 ? 1.0 : 0.0));
  add("keeps_right_ratio", right / static_cast<double>(ways_.size()));
}

}  // namespace fairway::uuv
