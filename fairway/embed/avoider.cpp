// SPDX-License-Identifier: Apache-2.0
#include "fairway/embed/avoider.hpp"

#include <algorithm>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/core/envelope_numbers.hpp"
#include "fairway/core/text.hpp"
#include "fairway/embed/nearest.hpp"

namespace fairway::embed {
namespace {

static_assert(static_cast<int>(ObstacleKind::polygon) == static_cast<int>(fairway::Obstacle::Kind::polygon));
static_assert(static_cast<int>(Mode::infeasible) == static_cast<int>(fairway::Mode::infeasible));

Vec3 vec(const Triple& a) { return {a[0], a[1], a[2]}; }
Triple triple(const Vec3& a) { return {a.x(), a.y(), a.z()}; }
Mat3 matrix(const Matrix3& a) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(a.data());
}
Wrench wrench(const SixAxes& a) { return Eigen::Map<const Wrench>(a.data()); }

fairway::Ownship converted(const Ownship& own) {
  return {.id = VehicleId{own.id},
          .position = vec(own.position),
          .velocity = vec(own.velocity),
          .yaw = own.yaw,
          .yaw_rate = own.yaw_rate,
          .radius = own.radius,
          .priority = own.priority,
          .position_sigma = own.position_sigma};
}

fairway::Track converted(const Track& track) {
  fairway::Track t{.id = TrackId{track.id},
                   .position = vec(track.position),
                   .velocity = vec(track.velocity),
                   .yaw = track.yaw,
                   .radius = track.radius,
                   .age = track.age,
                   .priority = track.priority,
                   .reacts = track.reacts,
                   .position_covariance = matrix(track.position_covariance),
                   .velocity_covariance = matrix(track.velocity_covariance)};
  if (track.has_destination) t.destination = vec(track.destination);
  return t;
}

/// Without its vertices.
fairway::Obstacle converted(const Obstacle& obstacle) {
  return {.kind = static_cast<fairway::Obstacle::Kind>(obstacle.kind),
          .position = vec(obstacle.position),
          .radius = obstacle.radius,
          .from = vec(obstacle.from),
          .to = vec(obstacle.to),
          .charted = obstacle.charted};
}

fairway::Goal converted(const Goal& goal) {
  fairway::Goal g{.position = vec(goal.position), .cruise_speed = goal.cruise_speed, .arrival = goal.arrival};
  if (goal.has_velocity) g.velocity = vec(goal.velocity);
  return g;
}

fairway::Limits converted(const Limits& limits) {
  return {.max_speed = limits.max_speed,
          .max_climb_rate = limits.max_climb_rate,
          .max_acceleration = limits.max_acceleration,
          .max_turn_rate = limits.max_turn_rate,
          .min_depth = limits.min_depth,
          .max_depth = limits.max_depth,
          .min_speed = limits.min_speed,
          .sternway = limits.sternway,
          .sway = limits.sway};
}

fairway::OnboardModel converted(const OnboardModel& model) {
  return {.mass = wrench(model.mass),
          .linear_damping = wrench(model.linear_damping),
          .quadratic_damping = wrench(model.quadratic_damping),
          .restoring = wrench(model.restoring),
          .least = wrench(model.least),
          .greatest = wrench(model.greatest)};
}

/// From one of the two kinds of envelope to the other.
template <typename To, typename From>
To same_numbers(const From& envelope) {
  return {.ahead = envelope.ahead,
          .astern = envelope.astern,
          .sideways = envelope.sideways,
          .up = envelope.up,
          .down = envelope.down,
          .least = envelope.least,
          .acceleration = envelope.acceleration,
          .deceleration = envelope.deceleration,
          .surge_lag = envelope.surge_lag,
          .turn_acceleration = envelope.turn_acceleration,
          .turn_lag = envelope.turn_lag,
          .pivot = envelope.pivot,
          .sway_lag = envelope.sway_lag,
          .turn_rates = envelope.turn_rates,
          .following_errors = envelope.following_errors,
          .deceleration_lost = envelope.deceleration_lost,
          .turn_tail = envelope.turn_tail,
          .slip_square = envelope.slip_square,
          .turn_plateau = envelope.turn_plateau,
          .foresight_error = envelope.foresight_error};
}

Command converted(const fairway::Command& command, std::size_t left_out) {
  Command c;
  c.velocity = triple(command.velocity);
  c.mode = static_cast<Mode>(command.mode);
  c.astern = command.astern;
  c.has_heading = command.heading.has_value();
  c.heading = command.heading.value_or(0.0);
  c.has_turn_rate = command.turn_rate.has_value();
  c.turn_rate = command.turn_rate.value_or(0.0);
  c.has_wrench = command.wrench.has_value();
  if (command.wrench) std::copy_n(command.wrench->data(), c.wrench.size(), c.wrench.begin());
  c.note = command.note;
  c.left_out = left_out;
  return c;
}

/// A polygon's vertices are one after the other, so that those of all are in one room.
std::size_t vertex_count(const Obstacle& obstacle) {
  return obstacle.kind == ObstacleKind::polygon ? obstacle.vertex_count : 0;
}

bool has_what_it_counts(const Situation& s) {
  if ((s.tracks == nullptr && s.track_count > 0) || (s.obstacles == nullptr && s.obstacle_count > 0)) {
    return false;
  }
  return std::all_of(s.obstacles, s.obstacles + s.obstacle_count,
                     [](const Obstacle& o) { return o.vertices != nullptr || vertex_count(o) == 0; });
}

/// "name=value" in two.
std::pair<std::string, std::string> named(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError("setting \"" + setting + "\": expected name=value");
  }
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

Command standstill(std::string_view why) {
  Command command;
  command.mode = Mode::infeasible;
  command.note = why;
  return command;
}

ParamValues values_of(const std::vector<std::string>& settings) {
  ParamValues values;
  for (const std::string& setting : settings) {
    const auto [name, value] = named(setting);
    if (std::ranges::find(values, name, &ParamValues::value_type::first) != values.end()) {
      throw InputError("setting " + name + ": given twice");
    }
    values.emplace_back(name, parse_value(value));
  }
  return values;
}

fairway::Avoider made_without_link(std::string_view algorithm, const std::vector<std::string>& settings,
                                   std::uint64_t seed) {
  fairway::Avoider made = builtin_avoiders().make(algorithm, values_of(settings), Rng{seed});
  if (made.speaks())
    throw InputError(std::string{algorithm} +
                     " decides nothing without a link to the others, which this interface has not");
  return made;
}

}  // namespace

struct Avoider::Self {
  Self(fairway::Avoider made, const Capacity& wanted) : avoider{std::move(made)}, capacity{wanted} {
    tracks.reserve(capacity.tracks);
    obstacles.reserve(capacity.obstacles);
    vertices.resize(capacity.vertices);
    nearest_tracks.reserve(capacity.tracks);
    nearest_obstacles.reserve(capacity.obstacles);
    rehearse();
  }
  Self(const Self& other) : Self{other.avoider, other.capacity} {}
  Self& operator=(const Self&) = delete;

  /// So that the method has room for all that may come: as many as possible, some of them in the way.
  void rehearse() {
    for (std::size_t i = 0; i < capacity.tracks; ++i) {
      const auto ahead = static_cast<double>(i);
      tracks.push_back({.id = TrackId{static_cast<std::uint32_t>(i + 1)},
                        .position = {4.0 + ahead, 0.0, 0.0},
                        .velocity = {-1.0, 0.0, 0.0}});
    }
    for (std::size_t i = 0; i < capacity.obstacles; ++i) {
      obstacles.push_back({.position = {0.0, 50.0 + static_cast<double>(i), 0.0}, .radius = 1.0});
    }
    avoider.rehearse({.period = 0.1,
                      .own = {.id = VehicleId{0}, .velocity = {1.0, 0.0, 0.0}},
                      .goal = {.position = {1000.0, 0.0, 0.0}, .cruise_speed = 1.0},
                      .limits = {.max_speed = 1.5},
                      .tracks = tracks,
                      .obstacles = obstacles});
  }

  /// The nearest tracks that there is room for, nearest first.
  void take_tracks(const Situation& s) noexcept {
    const Vec3 own = vec(s.own.position);
    nearest_tracks.clear();
    for (std::size_t i = 0; i < s.track_count; ++i) {
      const double range2 = (vec(s.tracks[i].position) - own).squaredNorm();
      nearest_tracks.offer({range2, s.tracks[i].id, i});
    }
    nearest_tracks.sort();
    tracks.clear();
    for (const Near& near : nearest_tracks.kept()) tracks.push_back(converted(s.tracks[near.index]));
  }

  /// The nearest obstacles that there is room for, in the order in which they are given.
  void take_obstacles(const Situation& s) noexcept {
    const Vec3 own = vec(s.own.position);
    nearest_obstacles.clear();
    for (std::size_t i = 0; i < s.obstacle_count; ++i) {
      if (vertex_count(s.obstacles[i]) > vertices.size()) continue;
      const double range = nearest_point(with_vertices(s.obstacles[i], 0), own).distance;
      nearest_obstacles.offer({range, 0, i});
    }
    nearest_obstacles.sort();

    std::size_t room = vertices.size();
    nearest_obstacles.keep_if([&](const Near& near) {
      const std::size_t count = vertex_count(s.obstacles[near.index]);
      if (count > room) return false;
      room -= count;
      return true;
    });
    nearest_obstacles.sort_as_given();

    obstacles.clear();
    std::size_t next = 0;
    for (const Near& near : nearest_obstacles.kept()) {
      obstacles.push_back(with_vertices(s.obstacles[near.index], next));
      next += vertex_count(s.obstacles[near.index]);
    }
  }

  /// Its vertices are put into the room for them, from `first` on.
  fairway::Obstacle with_vertices(const Obstacle& obstacle, std::size_t first) noexcept {
    fairway::Obstacle o = converted(obstacle);
    const std::size_t count = vertex_count(obstacle);
    for (std::size_t i = 0; i < count; ++i) vertices[first + i] = vec(obstacle.vertices[i]);
    o.vertices = std::span{vertices}.subspan(first, count);
    return o;
  }

  Command decide(const Situation& s) noexcept {
    if (!has_what_it_counts(s)) return standstill("a pointer is null where its count is not 0");
    take_tracks(s);
    take_obstacles(s);
    if (s.model != nullptr) model = converted(*s.model);
    if (s.envelope != nullptr) envelope = same_numbers<fairway::Envelope>(*s.envelope);
    const fairway::Command command = avoider.decide({.time = s.time,
                                                     .period = s.period,
                                                     .own = converted(s.own),
                                                     .goal = converted(s.goal),
                                                     .limits = converted(s.limits),
                                                     .model = s.model != nullptr ? &model : nullptr,
                                                     .envelope = s.envelope != nullptr ? &envelope : nullptr,
                                                     .current = vec(s.current),
                                                     .tracks = tracks,
                                                     .obstacles = obstacles});
    return converted(command, s.track_count - tracks.size() + s.obstacle_count - obstacles.size());
  }

  fairway::Avoider avoider;
  Capacity capacity;
  std::vector<fairway::Track> tracks;
  std::vector<fairway::Obstacle> obstacles;
  std::vector<Vec3> vertices;
  Nearest nearest_tracks;
  Nearest nearest_obstacles;
  fairway::OnboardModel model;
  fairway::Envelope envelope;
};

Avoider::Avoider(std::string_view algorithm, const std::vector<std::string>& settings,
                 const Capacity& capacity, std::uint64_t seed)
    : self_{std::make_unique<Self>(made_without_link(algorithm, settings, seed), capacity)} {}

Avoider::Avoider(const Avoider& other) : self_{std::make_unique<Self>(*other.self_)} {}
Avoider& Avoider::operator=(const Avoider& other) { return *this = Avoider{other}; }
Avoider::Avoider(Avoider&& other) noexcept = default;
Avoider& Avoider::operator=(Avoider&& other) noexcept = default;
Avoider::~Avoider() = default;

Command Avoider::decide(const Situation& situation) noexcept { return self_->decide(situation); }

Envelope envelope_of(const std::vector<std::string>& numbers) {
  std::vector<std::pair<std::string, std::string>> given;
  std::ranges::transform(numbers, std::back_inserter(given), named);
  return same_numbers<Envelope>(envelope_of_numbers(given));
}

std::vector<std::string> algorithms() {
  const Catalog catalog = builtin_avoiders();
  std::vector<std::string> names;
  for (const Catalog::Entry& entry : catalog.entries())
    if (!entry.info.needs_link) names.emplace_back(entry.info.name);
  return names;
}

}  // namespace fairway::embed
