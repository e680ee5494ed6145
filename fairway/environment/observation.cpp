// SPDX-License-Identifier: Apache-2.0
#include "fairway/environment/observation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway::environment {
namespace {

/// Fills a row from its front.
class Row {
 public:
  Row(std::span<float> numbers, Axes axes, double yaw)
      : numbers_{numbers},
        cos_{axes == Axes::heading ? math::cos(yaw) : 1.0},
        sin_{axes == Axes::heading ? math::sin(yaw) : 0.0} {}

  void put(double value) { numbers_[used_++] = static_cast<float>(value); }
  void put(const Vec3& v_n) {
    put(cos_ * v_n.x() + sin_ * v_n.y());
    put(cos_ * v_n.y() - sin_ * v_n.x());
    put(v_n.z());
  }
  void zeros(int count) {
    for (int i = 0; i < count; ++i) put(0.0);
  }

 private:
  std::span<float> numbers_;
  std::size_t used_{0};
  double cos_;
  double sin_;
};

void put_own(Row& row, const Sight& sight) {
  const Ownship& own = sight.own;
  row.put(own.velocity);
  row.put(math::sin(own.yaw));
  row.put(math::cos(own.yaw));
  row.put(own.yaw_rate);
  row.put(Vec3{sight.goal.position - own.position});
  row.put(sight.goal.cruise_speed);
  row.put(own.position.z());
  row.put(own.radius);
}

void put_tracks(Row& row, const Sight& sight, int count) {
  const int seen = std::min(count, static_cast<int>(sight.tracks.size()));
  for (const Track& track : sight.tracks.first(static_cast<std::size_t>(seen))) {
    row.put(1.0);
    row.put(Vec3{track.position - sight.own.position});
    row.put(track.velocity);
    row.put(track.radius);
    row.put(track.age);
  }
  row.zeros((count - seen) * ObservationShape::track_size);
}

void put_obstacles(Row& row, const Sight& sight, int count) {
  std::array<SurfacePoint, ObservationShape::most_obstacles> nearest;
  int seen = 0;
  for (const Obstacle& obstacle : sight.obstacles) {
    const SurfacePoint point = nearest_point(obstacle, sight.own.position);
    int at = seen;
    while (at > 0 && point.distance < nearest[static_cast<std::size_t>(at - 1)].distance) --at;
    if (at == count) continue;
    seen = std::min(seen + 1, count);
    for (int i = seen - 1; i > at; --i)
      nearest[static_cast<std::size_t>(i)] = nearest[static_cast<std::size_t>(i - 1)];
    nearest[static_cast<std::size_t>(at)] = point;
  }
  for (int i = 0; i < seen; ++i) {
    row.put(1.0);
    row.put(Vec3{nearest[static_cast<std::size_t>(i)].point - sight.own.position});
  }
  row.zeros((count - seen) * ObservationShape::obstacle_size);
}

}  // namespace

std::vector<std::string> ObservationShape::names() const {
  const std::array<std::string, 3> axis = axes == Axes::ned
                                              ? std::array<std::string, 3>{"north", "east", "down"}
                                              : std::array<std::string, 3>{"ahead", "starboard", "down"};
  std::vector<std::string> all;
  const auto add = [&](const std::string& name, const std::string& unit) { all.push_back(name + unit); };
  const auto add_vector = [&](const std::string& name, const std::string& unit) {
    for (const std::string& direction : axis) add(name + "_" + direction, unit);
  };
  add_vector("velocity", "_mps");
  add("sin_yaw", "_ratio");
  add("cos_yaw", "_ratio");
  add("yaw_rate", "_radps");
  add_vector("goal", "_m");
  add("cruise_speed", "_mps");
  add("depth", "_m");
  add("radius", "_m");
  for (int i = 0; i < tracks; ++i) {
    const std::string track = "track" + std::to_string(i);
    add(track + "_present", "_ratio");
    add_vector(track + "_position", "_m");
    add_vector(track + "_velocity", "_mps");
    add(track + "_radius", "_m");
    add(track + "_age", "_s");
  }
  for (int i = 0; i < obstacles; ++i) {
    const std::string obstacle = "obstacle" + std::to_string(i);
    add(obstacle + "_present", "_ratio");
    add_vector(obstacle + "_point", "_m");
  }
  return all;
}

void observe(const ObservationShape& shape, const Sight& sight, std::span<float> numbers) noexcept {
  Row row{numbers, shape.axes, sight.own.yaw};
  put_own(row, sight);
  put_tracks(row, sight, shape.tracks);
  put_obstacles(row, sight, shape.obstacles);
}

Vec3 to_axes(Axes axes, double yaw, const Vec3& v) noexcept {
  if (axes == Axes::ned) return v;
  Vec3 in_axes = v;
  in_axes.head<2>() = turned(v.head<2>(), -yaw);
  return in_axes;
}

Vec3 from_axes(Axes axes, double yaw, const Vec3& v) noexcept { return to_axes(axes, -yaw, v); }

}  // namespace fairway::environment
