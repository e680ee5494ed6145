// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/core/math.hpp"
#include "fairway/planning/path_planner.hpp"

namespace fairway::teb {
namespace {

constexpr int iterations = 500;  // of the search: at most 0.06 % over the optimum in planning's README.md

/// A point of a way.
struct Place {
  std::size_t leg{};
  double along{};  ///< from the beginning of the leg [m]
};

Place nearest_on(std::span<const Vec2> way, const Vec2& own) {
  Place nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Vec2 leg = way[i + 1] - way[i];
    const double length = leg.norm();
    const double along = length > 0.0 ? std::clamp((own - way[i]).dot(leg) / length, 0.0, length) : 0.0;
    const Vec2 point = length > 0.0 ? Vec2{way[i] + along * leg / length} : way[i];
    if (const double distance = (own - point).norm(); distance < least) {
      least = distance;
      nearest = {i, along};
    }
  }
  return nearest;
}

PlanarMap known_to(const TebParams& params, const Situation& s, double clearance) {
  std::vector<Obstacle> known{s.obstacles.begin(), s.obstacles.end()};
  for (const Track& track : s.tracks) {
    if (params.include_dynamic_obstacles) break;
    known.push_back({.kind = Obstacle::Kind::sphere, .position = track.position, .radius = track.radius});
  }
  return {known, s.own.radius + clearance};
}

}  // namespace

WayAhead ahead_on(std::span<const Vec2> way, const Vec2& own, double lookahead) {
  Place place = nearest_on(way, own);
  WayAhead ahead{.points = {own}, .end = {}};
  const auto leg = [&] { return Vec2{way[place.leg + 1] - way[place.leg]}; };
  double reach = place.along + lookahead;
  while (place.leg + 2 < way.size() && reach > leg().norm()) {
    reach -= leg().norm();
    ahead.points.push_back(way[++place.leg]);
  }
  const double length = leg().norm();
  ahead.end.position = way[place.leg + 1];
  if (length > 0.0) ahead.end.position = way[place.leg] + math::fmin(reach, length) * leg() / length;
  const Vec2 course = length > 0.0 ? leg() : Vec2{ahead.end.position - own};
  ahead.end.heading = math::atan2(course.y(), course.x());
  ahead.points.push_back(ahead.end.position);
  return ahead;
}

bool is_blocked(const TebParams& params, std::span<const Vec2> way, const Situation& s) {
  const PlanarMap map = known_to(params, s, 0.0);
  const Place place = nearest_on(way, seen_from_above(s.own.position));
  const Vec2 leg = way[place.leg + 1] - way[place.leg];
  Vec2 from = way[place.leg];
  if (leg.norm() > 0.0) from += place.along * leg / leg.norm();
  for (std::size_t i = place.leg + 1; i < way.size(); ++i) {
    if (!map.is_free(from, way[i])) return true;
    from = way[i];
  }
  return false;
}

std::optional<std::vector<Vec2>> plan_way(const TebParams& params, const Situation& s, const Vec2& goal,
                                          Rng& rng) {
  const PathRequest request{.start = seen_from_above(s.own.position),
                            .goal = goal,
                            .iterations_count = iterations,
                            .seed = static_cast<std::uint32_t>(rng.next() >> 32U)};
  for (const double clearance : {params.min_obstacle_dist_m, 0.0}) {
    PathResult path = plan_path(known_to(params, s, clearance), request);
    if (path.status == PathStatus::found && path.waypoints.size() > 1) return std::move(path.waypoints);
  }
  return {};
}

}  // namespace fairway::teb
