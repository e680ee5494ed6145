// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/situation_json.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <tuple>

#include "fairway/cli/decide/json_line.hpp"
#include "fairway/core/math.hpp"
#include "fairway/scenario/block.hpp"
#include "fairway/scenario/polygon.hpp"

namespace fairway {
namespace {

using yaml::Value;

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double farthest = 1e30;  // whatever the unit, no vehicle is beyond it
constexpr yaml::Bounds any{-farthest, farthest};
constexpr yaml::Bounds not_negative{0.0, farthest};

Mat3 read_covariance(const Value& value) {
  if (!value.tree().is_list() || value.tree().items.size() != 3)
    value.expected("three rows of three numbers");
  Mat3 covariance;
  for (int row = 0; row < 3; ++row)
    covariance.row(row) = value.entry(static_cast<std::size_t>(row)).vector({-unlimited, unlimited});
  if (covariance != covariance.transpose()) value.refuse("expected a symmetric matrix");

  // what is singular may come out below zero by rounding
  const double largest = covariance.cwiseAbs().maxCoeff();
  const Eigen::SelfAdjointEigenSolver<Mat3> axes{covariance, Eigen::EigenvaluesOnly};
  if (!(axes.eigenvalues()[0] >= -1e-9 * largest))
    value.refuse("the variance along some direction is negative");
  return covariance;
}

template <class T>
void read_member(const Value& value, double least, T& member) {
  if constexpr (std::same_as<T, double>) {
    member = value.number({math::fmax(least, -farthest), farthest});
  } else if constexpr (std::same_as<T, bool>) {
    member = value.flag();
  } else if constexpr (std::same_as<T, std::int32_t>) {
    member = value.whole<std::int32_t>();
  } else if constexpr (std::is_enum_v<T>) {
    member = T{value.whole<std::uint32_t>()};
  } else if constexpr (std::same_as<T, Mat3>) {
    member = read_covariance(value);
  } else {
    member = value.vector(any);
  }
}

/// A record's members by their names, and nothing else but `others`.
template <RecordType R>
R read_record(const Value& value, std::initializer_list<std::string_view> others = {}) {
  std::vector<std::string_view> known{others};
  for_each_member<R>([&](const auto& m) { known.push_back(m.name); });
  value.expect_keys(known);

  R record;
  for_each_member<R>([&](const auto& m) {
    if (const std::optional<Value> given = m.is_required ? value.at(m.name) : value.find(m.name))
      read_member(*given, m.least, record.*m.at);
  });
  return record;
}

/// One that may have no priority: then the id decides who has the right of way.
template <RecordType R>
R read_ranked(const Value& value) {
  auto record = read_record<R>(value);
  if (!value.find("priority")) record.priority = static_cast<std::int32_t>(number(record.id));
  return record;
}

Limits read_limits(const Value& at) {
  const auto limits = read_record<Limits>(at);
  if (limits.min_depth > limits.max_depth) at.refuse("min_depth is below max_depth; depth counts downwards");
  return limits;
}

Goal read_goal(const Value& line, const Limits& limits) {
  const Value at = line.at("goal");
  Goal goal = read_record<Goal>(at, {"speed"});
  const std::optional<Value> speed = at.find("speed");
  if (at.find("cruise_speed")) {
    if (speed) at.refuse("cruise_speed and speed are the same; keep one");
  } else {
    goal.cruise_speed = speed ? speed->number(not_negative) : limits.max_speed;
  }
  if (const auto preferred = line.find("preferred_velocity")) {
    if (at.find("velocity")) at.refuse("velocity and preferred_velocity are the same; keep one");
    goal.velocity = preferred->vector(any);
  }
  return goal;
}

std::vector<Track> read_tracks(const Value& list, const Ownship& own) {
  list.expect_list("tracks");
  const std::size_t count = list.tree().items.size();
  std::vector<Track> tracks;
  std::vector<std::pair<std::uint32_t, std::size_t>> ids;
  tracks.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    tracks.push_back(read_ranked<Track>(list.entry(i)));
    ids.emplace_back(number(tracks.back().id), i);
    if (ids.back().first == number(own.id))
      list.entry(i).refuse(fmt::format("id {} is own.id", ids.back().first));
  }

  std::ranges::sort(ids);
  const auto twice = std::ranges::adjacent_find(ids, {}, &std::pair<std::uint32_t, std::size_t>::first);
  if (twice != ids.end())
    list.entry((twice + 1)->second)
        .refuse(fmt::format("id {} is that of tracks[{}]", twice->first, twice->second));

  std::ranges::sort(tracks, {}, [&](const Track& t) {
    return std::tuple{(t.position - own.position).squaredNorm(), number(t.id)};
  });
  return tracks;
}

std::vector<Vec3> read_vertices(const Value& list) {
  list.expect_list("vertices");
  std::vector<Vec3> vertices;
  for (std::size_t i = 0; i < list.tree().items.size(); ++i) vertices.push_back(list.entry(i).vector(any));
  if (vertices.size() < 3) list.refuse(fmt::format("expected at least three, got {}", vertices.size()));
  const double area = signed_area(vertices);
  if (!(area >= 0.0)) list.refuse("they run clockwise; write them counter-clockwise with n as x and e as y");
  if (area == 0.0) list.refuse("they lie on one line; a polygon needs an area");
  return vertices;
}

void read_obstacles(const Value& list, DecideRequest& request) {
  list.expect_list("obstacles");
  const std::size_t count = list.tree().items.size();
  request.vertices.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Value item = list.entry(i);
    item.expect_map("kind, and the keys of that kind");
    const Value kind = item.at("kind");

    if (kind.text() == "sphere") {
      item.expect_keys({"kind", "position", "radius", "charted"});
      request.obstacles.push_back({.kind = Obstacle::Kind::sphere,
                                   .position = item.at("position").vector(any),
                                   .radius = item.at("radius").number(not_negative)});
    } else if (kind.text() == "segment") {
      item.expect_keys({"kind", "from", "to", "charted"});
      request.obstacles.push_back({.kind = Obstacle::Kind::segment,
                                   .from = item.at("from").vector(any),
                                   .to = item.at("to").vector(any)});
    } else if (kind.text() == "polygon") {
      item.expect_keys({"kind", "vertices", "charted"});
      request.vertices.push_back(read_vertices(item.at("vertices")));
      request.obstacles.push_back({.kind = Obstacle::Kind::polygon, .vertices = request.vertices.back()});
    } else {
      kind.expected("sphere, segment or polygon");
    }
    if (const auto charted = item.find("charted")) request.obstacles.back().charted = charted->flag();
  }
}

}  // namespace

DecideRequest parse_situation(std::string_view text, std::size_t line) {
  const yaml::Tree tree = parse_json(text, line);
  yaml::Reading reading;
  const Value root{tree, "", reading};
  root.expect_keys(
      {"time", "period", "own", "goal", "preferred_velocity", "limits", "params", "tracks", "obstacles"});

  DecideRequest request;
  Situation& s = request.without_others;
  if (const auto time = root.find("time")) s.time = time->number(any);
  s.period = root.at("period").number(yaml::above_to(0.0, unlimited));
  s.own = read_ranked<Ownship>(root.at("own"));
  s.limits = read_limits(root.at("limits"));
  s.goal = read_goal(root, s.limits);
  if (const auto tracks = root.find("tracks")) request.tracks = read_tracks(*tracks, s.own);
  if (const auto obstacles = root.find("obstacles")) read_obstacles(*obstacles, request);
  if (const auto params = root.find("params")) request.params = yaml::read_params(*params);
  return request;
}

}  // namespace fairway
