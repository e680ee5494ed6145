// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/core/angles.hpp"

/// Situations with names a mariner would use, for tests, benchmarks and examples. Own ship has id 0,
/// radius 1 m, makes 1 m/s of at most 1.5 m/s, and decides every 0.1 s, unless said otherwise.
namespace fairway::encounters {

/// A situation that owns what it shows.
struct OwnedSituation {
  std::vector<Track> tracks;
  std::vector<Obstacle> obstacles;
  Situation situation;
  std::vector<std::shared_ptr<const std::vector<Vec3>>> corners;  ///< what polygons show; shared with copies

  operator Situation() const {  // NOLINT(google-explicit-constructor): read as a situation
    Situation s = situation;
    s.tracks = tracks;
    s.obstacles = obstacles;
    return s;
  }

  /// A prism; the vertices counter-clockwise, n as x and e as y.
  void add_polygon(std::vector<Vec3> vertices) {
    corners.push_back(std::make_shared<const std::vector<Vec3>>(std::move(vertices)));
    obstacles.push_back({.kind = Obstacle::Kind::polygon, .vertices = *corners.back()});
  }

  /// Tracks nearest first, equal ranges by id, as every Situation has them.
  OwnedSituation& sorted() {
    const auto rank = [&](const Track& t) {
      return std::pair{(t.position - situation.own.position).squaredNorm(), number(t.id)};
    };
    std::ranges::sort(tracks, {}, rank);
    return *this;
  }
};

/// What a method answers to a situation that is the first it meets.
template <AvoidanceAlgorithm A>
Command decide(const Situation& s, const typename A::Params& params = {}, Sketch* sketch = nullptr) {
  Rng rng{1};
  Context context{rng, sketch};
  typename A::Memory memory;
  return A{params}.decide(s, memory, context);
}

/// Answers with the command that it was made with.
struct Always {
  static constexpr AlgorithmInfo info{.name = "always"};
  using Params = NoParams;
  using Memory = NoMemory;
  Params params;
  Command command;
  Command decide(const Situation&, Memory&, Context&) const noexcept { return command; }
};

inline Obstacle sphere(double north, double east, double radius, double depth = 0.0) {
  return {.kind = Obstacle::Kind::sphere, .position = {north, east, depth}, .radius = radius};
}

inline Obstacle wall(const Vec3& from, const Vec3& to) {
  return {.kind = Obstacle::Kind::segment, .from = from, .to = to};
}

inline Track track(std::uint32_t id, const Vec3& position, const Vec3& velocity, double radius = 1.0) {
  return {.id = TrackId{id},
          .position = position,
          .velocity = velocity,
          .radius = radius,
          .priority = static_cast<std::int32_t>(id)};
}

/// Northbound at 50 m depth, goal far ahead, nobody around.
inline OwnedSituation open_water(double speed = 1.0) {
  OwnedSituation e;
  e.situation = {.time = 0.0,
                 .period = 0.1,
                 .own = {.id = VehicleId{0}, .position = {0, 0, 50}, .velocity = {speed, 0, 0}},
                 .goal = {.position = {1000, 0, 50}, .cruise_speed = speed},
                 .limits = {.max_speed = 1.5}};
  return e;
}

/// Somebody dead ahead on the reciprocal course.
inline OwnedSituation head_on(double range = 8.0, double speed = 1.0) {
  OwnedSituation e = open_water(speed);
  e.tracks = {track(1, {range, 0, 50}, {-speed, 0, 0})};
  return e;
}

/// Somebody from starboard, to meet after `time` seconds.
inline OwnedSituation crossing(double time = 6.0, double speed = 1.0) {
  OwnedSituation e = open_water(speed);
  e.tracks = {track(1, {speed * time, speed * time, 50}, {0, -speed, 0})};
  return e;
}

inline Vec3 direction(Rng& rng) { return unit(Vec3{rng.normal(), rng.normal(), rng.normal()}); }

/// Slower than `most` [m/s]. The speed is drawn first, whatever order a compiler takes for factors.
inline Vec3 velocity(double most, Rng& rng) {
  const double speed = rng.uniform(0.0, most);
  return speed * direction(rng);
}

/// `count` vehicles placed between `nearest` and `farthest` [m] and moving, both at random in space;
/// the goal too lies anywhere.
inline OwnedSituation swarm(int count, double nearest, double farthest, Rng rng) {
  OwnedSituation e = open_water();
  Situation& s = e.situation;
  s.own.velocity = velocity(1.0, rng);
  s.own.yaw = std::atan2(s.own.velocity.y(), s.own.velocity.x());
  s.goal.position = s.own.position + 40.0 * direction(rng);
  for (int i = 0; i < count; ++i) {
    const double range = std::cbrt(rng.uniform(nearest * nearest * nearest, farthest * farthest * farthest));
    const Vec3 position = s.own.position + range * direction(rng);
    e.tracks.push_back(track(static_cast<std::uint32_t>(i + 1), position, velocity(1.0, rng)));
  }
  return e.sorted();
}

/// Room to pass: nobody touches own ship, and ORCA nearly always finds a velocity.
inline OwnedSituation crowd(int count, Rng rng) { return swarm(count, 3.0, 15.0, rng); }

/// No room: hulls (R = 2 m) nearly touch or overlap, and often no velocity is safe.
inline OwnedSituation congested(int count, Rng rng) { return swarm(count, 1.8, 4.0, rng); }

/// Room to pass, among what does not give way: half of a crowd drifts, and there are two rocks, a quay and a
/// pier, 2 m or more from own ship at its depth.
inline OwnedSituation harbour(int count, Rng rng) {
  OwnedSituation e = crowd(count, rng);
  for (Track& t : e.tracks) t.reacts = number(t.id) % 2 == 0;
  const auto spot = [&](double nearest, Vec3& abeam) {
    const double bearing = rng.uniform(-pi, pi);
    const Vec3 out{std::cos(bearing), std::sin(bearing), 0.0};
    abeam = {-out.y(), out.x(), 0.0};
    return Vec3{e.situation.own.position + rng.uniform(nearest, nearest + 8.0) * out};
  };
  Vec3 abeam;
  for (int i = 0; i < 2; ++i) {
    const double radius = rng.uniform(0.5, 2.0);
    e.obstacles.push_back(
        {.kind = Obstacle::Kind::sphere, .position = spot(2.0 + radius, abeam), .radius = radius});
  }
  const Vec3 quay = spot(2.0, abeam);
  e.obstacles.push_back(
      {.kind = Obstacle::Kind::segment, .from = quay - 3.0 * abeam, .to = quay + 4.7 * abeam});
  const Vec3 pier = spot(4.0, abeam);  // its corners are 1.5 m from its middle
  e.add_polygon(
      {pier + Vec3{1.5, 0, 0}, pier + Vec3{0, 1.5, 0}, pier - Vec3{1.5, 0, 0}, pier - Vec3{0, 1.5, 0}});
  return e;
}

/// The cubes of raja2024: vehicle `own` of `count` (2 to 8) at a vertex of a cube of edge `edge` [m], all
/// making 0.5 m/s for the opposite vertex, safety radius 3 m, `progress` (0 to 1) of the way gone.
inline OwnedSituation cube_centre(int count = 8, int own = 0, double edge = 20.0, double progress = 0.3) {
  const double h = edge / 2.0;
  const std::vector<Vec3> vertices{{h, h, 0},       {-h, -h, 0},   {h, -h, 2 * h}, {-h, h, 2 * h},
                                   {-h, -h, 2 * h}, {h, h, 2 * h}, {-h, h, 0},     {h, -h, 0}};
  const Vec3 centre{0, 0, h};
  OwnedSituation e;
  Situation& s = e.situation;
  s.period = 0.5;
  s.limits.max_speed = 0.5;
  for (int i = 0; i < count; ++i) {
    const Vec3& start = vertices[static_cast<std::size_t>(i)];
    const Vec3 goal = 2.0 * centre - start;
    const Vec3 position = start + progress * (goal - start);
    const Vec3 velocity = 0.5 * unit(Vec3{goal - start});
    if (i == own) {
      s.own = {.id = VehicleId{static_cast<std::uint32_t>(i)},
               .position = position,
               .velocity = velocity,
               .yaw = std::atan2(velocity.y(), velocity.x()),
               .radius = 3.0,
               .priority = i};
      s.goal = {.position = goal, .cruise_speed = 0.5};
    } else {
      e.tracks.push_back(track(static_cast<std::uint32_t>(i), position, velocity, 3.0));
    }
  }
  return e.sorted();
}

/// One period later, if the command was carried out at once and the others kept their course.
inline void carry_out(OwnedSituation& e, const Command& command) {
  Situation& s = e.situation;
  s.time += s.period;
  s.own.velocity = command.velocity;
  s.own.position += s.period * command.velocity;
  for (Track& t : e.tracks) t.position += s.period * t.velocity;
  e.sorted();
}

/// Changes every point of what does not move; `mirrors` where that turns left into right.
template <class Change>
void change_obstacles(OwnedSituation& e, Change change, bool mirrors = false) {
  for (Obstacle& o : e.obstacles) {
    for (Vec3* point : {&o.position, &o.from, &o.to}) *point = change(*point);
    if (o.vertices.empty()) continue;
    std::vector<Vec3> vertices(o.vertices.size());
    std::ranges::transform(o.vertices, vertices.begin(), change);
    if (mirrors) std::ranges::reverse(vertices);  // still counter-clockwise
    e.corners.push_back(std::make_shared<const std::vector<Vec3>>(std::move(vertices)));
    o.vertices = *e.corners.back();
  }
}

/// The same scene elsewhere.
inline OwnedSituation shifted(OwnedSituation e, const Vec3& by) {
  e.situation.own.position += by;
  e.situation.goal.position += by;
  e.situation.limits.min_depth += by.z();
  e.situation.limits.max_depth += by.z();
  for (Track& t : e.tracks) t.position += by;
  change_obstacles(e, [&](const Vec3& p) -> Vec3 { return p + by; });
  return e;
}

/// The same scene turned by `angle` about the vertical through the origin [rad].
inline OwnedSituation turned(OwnedSituation e, double angle) {
  const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
  Situation& s = e.situation;
  s.own.position = turn * s.own.position;
  s.own.velocity = turn * s.own.velocity;
  s.own.yaw = wrap_angle(s.own.yaw + angle);
  s.goal.position = turn * s.goal.position;
  if (s.goal.velocity) s.goal.velocity = turn * *s.goal.velocity;
  for (Track& t : e.tracks) {
    t.position = turn * t.position;
    t.velocity = turn * t.velocity;
    t.yaw = wrap_angle(t.yaw + angle);
  }
  change_obstacles(e, [&](const Vec3& p) -> Vec3 { return turn * p; });
  return e;
}

/// The same scene in a mirror that stands along north through the origin: what was to port is to starboard.
inline OwnedSituation mirrored(OwnedSituation e) {
  const auto flip = [](Vec3& v) { v.y() = -v.y(); };
  Situation& s = e.situation;
  flip(s.own.position);
  flip(s.own.velocity);
  s.own.yaw = -s.own.yaw;
  s.own.yaw_rate = -s.own.yaw_rate;
  flip(s.goal.position);
  if (s.goal.velocity) flip(*s.goal.velocity);
  for (Track& t : e.tracks) {
    flip(t.position);
    flip(t.velocity);
    t.yaw = -t.yaw;
  }
  change_obstacles(
      e,
      [](const Vec3& p) -> Vec3 {
        return {p.x(), -p.y(), p.z()};
      },
      true);
  return e;
}

}  // namespace fairway::encounters
