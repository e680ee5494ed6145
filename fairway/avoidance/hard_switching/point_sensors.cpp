// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/hard_switching/point_sensors.hpp"

#include <array>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

Vec3 sensor_at(const Ownship& own, const PointSensors& sensors, int index) {
  const double bearing = own.yaw + 2.0 * pi * index / sensors.count;
  const auto [sine, cosine] = math::sin_cos(bearing);
  return own.position + sensors.arm * Vec3{cosine, sine, 0.0};
}

}  // namespace

std::optional<Detection> nearest_detected(const Situation& s, const PointSensors& sensors) noexcept {
  std::optional<Detection> nearest;
  const auto see = [&](const Detection& d) {
    if (d.distance <= sensors.range && (!nearest || d.distance < nearest->distance)) nearest = d;
  };
  const auto from_all = [&](auto distance_from) {
    double least = distance_from(sensor_at(s.own, sensors, 0));
    for (int i = 1; i < sensors.count; ++i)
      least = math::fmin(least, distance_from(sensor_at(s.own, sensors, i)));
    return least;
  };

  for (const Obstacle& obstacle : s.obstacles) {
    const auto distance = [&](const Vec3& sensor) { return nearest_point(obstacle, sensor).distance; };
    see({centre_of(obstacle), Vec3::Zero(), from_all(distance)});
  }
  for (const Track& track : s.tracks) {
    const auto distance = [&](const Vec3& sensor) { return (track.position - sensor).norm() - track.radius; };
    see({track.position, track.velocity, from_all(distance)});
  }
  return nearest;
}

void draw(const PointSensors& sensors, const Ownship& own, const std::optional<Detection>& detected,
          std::string_view meaning, Sketch& sketch) {
  for (int i = 0; i < sensors.count; ++i)
    sketch.sphere(sensor_at(own, sensors, i), sensors.range, "range of a sensor");
  if (detected) sketch.path(std::array{own.position, detected->centre}, meaning);
}

}  // namespace fairway
