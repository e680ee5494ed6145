// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/situation_json.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <tuple>

#include "fairway/cli/decide/json_line.hpp"
#include "fairway/scenario/polygon.hpp"

namespace fairway {
namespace {

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

template <class T>
void read_value(const JsonAt& at, double least, T& value) {
  if constexpr (std::same_as<T, double>) {
    value = least == 0.0 ? at.not_negative() : at.number();
  } else if constexpr (std::same_as<T, bool>) {
    value = at.flag();
  } else if constexpr (std::same_as<T, std::int32_t> || std::is_enum_v<T>) {
    using Whole = std::conditional_t<std::is_enum_v<T>, std::uint32_t, std::int32_t>;
    using Bounds = std::numeric_limits<Whole>;
    value = static_cast<T>(static_cast<Whole>(at.whole(Bounds::min(), Bounds::max())));
  } else if constexpr (std::same_as<T, Mat3>) {
    value = read_covariance(at);
  } else {
    value = at.vector();
  }
}

/// A record's members by their names, and nothing else but `others`.
template <RecordType R>
R read_record(const JsonAt& at, std::initializer_list<std::string_view> others = {}) {
  std::vector<std::string_view> known{others};
  for_each_member<R>([&](const auto& m) { known.push_back(m.name); });
  at.expect_keys(known);

  R record;
  for_each_member<R>([&](const auto& m) {
    if (const std::optional<JsonAt> given = m.is_required ? at.at(m.name) : at.find(m.name))
      read_value(*given, m.least, record.*m.at);
  });
  return record;
}

/// One that may have no priority: then the id decides who has the right of way.
template <RecordType R>
R read_ranked(const JsonAt& at) {
  auto record = read_record<R>(at);
  if (!at.find("priority")) record.priority = static_cast<std::int32_t>(number(record.id));
  return record;
}

Limits read_limits(const JsonAt& at) {
  const auto limits = read_record<Limits>(at);
  if (limits.min_depth > limits.max_depth) at.refuse("min_depth is below max_depth; depth counts downwards");
  return limits;
}

Goal read_goal(const JsonAt& line, const Limits& limits) {
  const JsonAt at = line.at("goal");
  Goal goal = read_record<Goal>(at, {"speed"});
  const std::optional<JsonAt> speed = at.find("speed");
  if (at.find("cruise_speed")) {
    if (speed) at.refuse("cruise_speed and speed are the same; keep one");
  } else {
    goal.cruise_speed = speed ? speed->not_negative() : limits.max_speed;
  }
  if (const auto preferred = line.find("preferred_velocity")) {
    if (at.find("velocity")) at.refuse("velocity and preferred_velocity are the same; keep one");
    goal.velocity = preferred->vector();
  }
  return goal;
}

std::vector<Track> read_tracks(const JsonAt& at, const Ownship& own) {
  std::vector<Track> tracks;
  std::vector<std::pair<std::uint32_t, std::size_t>> ids;
  tracks.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    tracks.push_back(read_ranked<Track>(at.item(i)));
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
  s.own = read_ranked<Ownship>(at.at("own"));
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
