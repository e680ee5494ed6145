// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/situation_json.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "fairway/cli/decide/json_line.hpp"
#include "fairway/scenario/polygon.hpp"

namespace fairway {
namespace {

std::uint32_t read_id(const JsonAt& at) {
  return static_cast<std::uint32_t>(at.whole(0, std::numeric_limits<std::uint32_t>::max()));
}

/// The smaller number has the right of way; without one, the id decides.
std::int32_t read_priority(const JsonAt& object, std::uint32_t id) {
  const std::optional<JsonAt> given = object.find("priority");
  if (!given) return static_cast<std::int32_t>(id);
  return static_cast<std::int32_t>(
      given->whole(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()));
}

Ownship read_own(const JsonAt& at) {
  at.expect_keys({"id", "position", "velocity", "yaw", "yaw_rate", "radius", "priority"});
  const std::uint32_t id = read_id(at.at("id"));
  const std::optional<JsonAt> yaw_rate = at.find("yaw_rate");
  return {.id = VehicleId{id},
          .position = at.at("position").vector(),
          .velocity = at.at("velocity").vector(),
          .yaw = at.at("yaw").number(),
          .yaw_rate = yaw_rate ? yaw_rate->number() : 0.0,
          .radius = at.at("radius").not_negative(),
          .priority = read_priority(at, id)};
}

Limits read_limits(const JsonAt& at) {
  at.expect_keys({"max_speed", "max_climb_rate", "max_acceleration", "max_turn_rate", "min_depth",
                  "max_depth", "min_speed", "sternway", "sway"});
  Limits limits{.max_speed = at.at("max_speed").not_negative()};
  if (const auto given = at.find("max_climb_rate")) limits.max_climb_rate = given->not_negative();
  if (const auto given = at.find("max_acceleration")) limits.max_acceleration = given->not_negative();
  if (const auto given = at.find("max_turn_rate")) limits.max_turn_rate = given->not_negative();
  if (const auto given = at.find("min_depth")) limits.min_depth = given->number();
  if (const auto given = at.find("max_depth")) limits.max_depth = given->number();
  if (const auto given = at.find("min_speed")) limits.min_speed = given->not_negative();
  if (const auto given = at.find("sternway")) limits.sternway = given->flag();
  if (const auto given = at.find("sway")) limits.sway = given->flag();
  if (limits.min_depth > limits.max_depth) at.refuse("min_depth is below max_depth; depth counts downwards");
  return limits;
}

Goal read_goal(const JsonAt& line, const Limits& limits) {
  const JsonAt at = line.at("goal");
  at.expect_keys({"position", "cruise_speed", "speed"});
  Goal goal{.position = at.at("position").vector(), .cruise_speed = limits.max_speed};
  const std::optional<JsonAt> cruise_speed = at.find("cruise_speed");
  const std::optional<JsonAt> speed = at.find("speed");
  if (cruise_speed && speed) at.refuse("cruise_speed and speed are the same; keep one");
  if (cruise_speed) goal.cruise_speed = cruise_speed->not_negative();
  if (speed) goal.cruise_speed = speed->not_negative();
  if (const auto preferred = line.find("preferred_velocity")) goal.velocity = preferred->vector();
  return goal;
}

Mat3 read_covariance(const JsonAt& at) {
  if (at.size() != 3) at.refuse("expected three rows of three numbers");
  Mat3 covariance;
  for (int row = 0; row < 3; ++row) covariance.row(row) = at.item(static_cast<std::size_t>(row)).vector();
  if (covariance != covariance.transpose()) at.refuse("expected a symmetric matrix");

  // what is singular may come out below zero by rounding
  const double largest = covariance.cwiseAbs().maxCoeff();
  const Eigen::SelfAdjointEigenSolver<Mat3> axes{covariance, Eigen::EigenvaluesOnly};
  if (!(axes.eigenvalues()[0] >= -1e-9 * largest)) at.refuse("the variance along some direction is negative");
  return covariance;
}

Track read_track(const JsonAt& at) {
  at.expect_keys({"id", "position", "velocity", "radius", "yaw", "age", "priority", "destination", "reacts",
                  "position_covariance"});
  const std::uint32_t id = read_id(at.at("id"));
  Track track{.id = TrackId{id},
              .position = at.at("position").vector(),
              .velocity = at.at("velocity").vector(),
              .radius = at.at("radius").not_negative(),
              .priority = read_priority(at, id)};
  if (const auto yaw = at.find("yaw")) track.yaw = yaw->number();
  if (const auto age = at.find("age")) track.age = age->not_negative();
  if (const auto destination = at.find("destination")) track.destination = destination->vector();
  if (const auto reacts = at.find("reacts")) track.reacts = reacts->flag();
  if (const auto given = at.find("position_covariance")) track.position_covariance = read_covariance(*given);
  return track;
}

std::vector<Track> read_tracks(const JsonAt& at, const Ownship& own) {
  std::vector<Track> tracks;
  std::vector<std::pair<std::uint32_t, std::size_t>> ids;
  tracks.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    tracks.push_back(read_track(at.item(i)));
    ids.emplace_back(number(tracks.back().id), i);
    if (ids.back().first == number(own.id))
      at.item(i).refuse(fmt::format("id {} is own.id", ids.back().first));
  }

  std::ranges::sort(ids);
  const auto twice = std::ranges::adjacent_find(ids, {}, &std::pair<std::uint32_t, std::size_t>::first);
  if (twice != ids.end())
    at.item((twice + 1)->second)
        .refuse(fmt::format("id {} is that of tracks[{}]", twice->first, twice->second));

  std::ranges::sort(tracks, {}, [&](const Track& t) {
    return std::tuple{(t.position - own.position).squaredNorm(), number(t.id)};
  });
  return tracks;
}

std::vector<Vec3> read_vertices(const JsonAt& polygon) {
  const JsonAt at = polygon.at("vertices");
  std::vector<Vec3> vertices;
  for (std::size_t i = 0; i < at.size(); ++i) vertices.push_back(at.item(i).vector());
  if (vertices.size() < 3) at.refuse(fmt::format("expected at least three, got {}", vertices.size()));
  const double area = signed_area(vertices);
  if (!(area >= 0.0)) at.refuse("they run clockwise; write them counter-clockwise with n as x and e as y");
  if (area == 0.0) at.refuse("they lie on one line; a polygon needs an area");
  return vertices;
}

void read_obstacles(const JsonAt& at, DecideRequest& request) {
  request.vertices.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const JsonAt item = at.item(i);
    if (item.value().kind != Json::Kind::object) item.refuse("expected an object");
    const JsonAt kind_at = item.at("kind");
    const std::string& kind = kind_at.text();

    if (kind == "sphere") {
      item.expect_keys({"kind", "position", "radius", "charted"});
      request.obstacles.push_back({.kind = Obstacle::Kind::sphere,
                                   .position = item.at("position").vector(),
                                   .radius = item.at("radius").not_negative()});
    } else if (kind == "segment") {
      item.expect_keys({"kind", "from", "to", "charted"});
      request.obstacles.push_back(
          {.kind = Obstacle::Kind::segment, .from = item.at("from").vector(), .to = item.at("to").vector()});
    } else if (kind == "polygon") {
      item.expect_keys({"kind", "vertices", "charted"});
      request.vertices.push_back(read_vertices(item));
      request.obstacles.push_back({.kind = Obstacle::Kind::polygon, .vertices = request.vertices.back()});
    } else {
      kind_at.refuse("expected sphere, segment or polygon");
    }
    if (const auto charted = item.find("charted")) request.obstacles.back().charted = charted->flag();
  }
}

/// Each entry of `object` as `prefix` + its key; a list of objects as its length and its flat items.
void read_params(const JsonAt& object, const std::string& prefix, ParamValues& params) {
  for (const std::string& key : object.keys()) {
    const JsonAt at = object.at(key);
    if (at.value().kind != Json::Kind::list || !prefix.empty()) {
      params.emplace_back(prefix + key, at.param());
      continue;
    }
    params.emplace_back(key, static_cast<double>(at.size()));
    for (std::size_t i = 0; i < at.size(); ++i) {
      const JsonAt item = at.item(i);
      if (item.value().kind != Json::Kind::object) item.refuse("expected an object");
      read_params(item, fmt::format("{}[{}].", key, i), params);
    }
  }
}

}  // namespace

DecideRequest parse_situation(std::string_view text, std::size_t line) {
  const Json json = parse_json(text, line);
  const JsonAt at{json, line};
  at.expect_keys(
      {"time", "period", "own", "goal", "preferred_velocity", "limits", "params", "tracks", "obstacles"});

  DecideRequest request;
  Situation& s = request.without_others;
  if (const auto time = at.find("time")) s.time = time->number();
  const JsonAt period = at.at("period");
  s.period = period.number();
  if (!(s.period > 0.0)) period.refuse("expected a number above 0");
  s.own = read_own(at.at("own"));
  s.limits = read_limits(at.at("limits"));
  s.goal = read_goal(at, s.limits);
  if (const auto tracks = at.find("tracks")) request.tracks = read_tracks(*tracks, s.own);
  if (const auto obstacles = at.find("obstacles")) read_obstacles(*obstacles, request);

  if (const auto params = at.find("params")) {
    if (params->value().kind != Json::Kind::object) params->refuse("expected an object");
    read_params(*params, "", request.params);
  }
  return request;
}

}  // namespace fairway
