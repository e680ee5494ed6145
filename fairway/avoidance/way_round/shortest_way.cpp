// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/way_round/shortest_way.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/avoidance/avoa_improved/way_round.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using avoa_improved::Capsule;
using avoa_improved::Capsules;

constexpr double wider = 2.0;          // than what the inner avoider keeps: who strays from the way may go on
constexpr double narrow_share = 0.25;  // of the margin, where the whole leaves no way
constexpr double standing_mps = 1e-3;  // who is slower is believed to stand still
constexpr double leg_ahead_s = 20.0;   // to where a goal that is only a velocity leads

/// The depths on the way to the goal; all of them for a method to which depth makes no difference.
avoa_improved::DepthRange depths_on_the_way(const Situation& s, bool thinks_in_plane) {
  if (thinks_in_plane) return {};
  const double own = s.own.position.z();
  const double goal = s.goal.velocity ? own + leg_ahead_s * s.goal.velocity->z() : s.goal.position.z();
  return {std::min(own, goal), std::max(own, goal)};
}

/// Whether it is as good as an obstacle: it is not known to make way, and is believed to stand still.
bool stands(const Track& track) { return !track.reacts && track.velocity.norm() < standing_mps; }

/// What has been seen that does not move.
Capsules standing(const Situation& s, const ShortestWay::Memory& memory) {
  const Vec2 own = s.own.position.head<2>();
  Capsules found;
  for (const Capsule& solid : memory.chart.view()) found.add_near(solid, own);
  for (const Track& track : s.tracks) {
    const Vec2 place = track.position.head<2>();
    if (stands(track)) found.add_near({place, place, track.radius}, own);
  }
  return found;
}

/// The way with all of `solids` wider by `kept` than they are.
std::optional<avoa_improved::WayRound> way_with(const ShortestWay::Params& params, const Situation& s,
                                                const ShortestWay::Memory& memory, Capsules solids,
                                                double kept) {
  for (Capsule& solid : solids.view()) solid.radius += s.own.radius + kept;
  const Vec2 own = s.own.position.head<2>();
  const Vec2 goal = s.goal.velocity ? Vec2{own + leg_ahead_s * s.preferred_velocity().head<2>()}
                                    : Vec2{s.goal.position.head<2>()};
  return avoa_improved::way_round(solids.view(), own, goal,
                                  {.committed = memory.committed,
                                   .commitment = params.commitment_m,
                                   .heading = Vec2{math::cos(s.own.yaw), math::sin(s.own.yaw)},
                                   .bend = params.bend_m});
}

}  // namespace

Command ShortestWay::decide(const Situation& s, Avoider& inner, Memory& memory,
                            Context& context) const noexcept {
  const double margin = std::max(params.way_margin_m, wider * inner.kept_margin()) + s.own.position_error();
  memory.chart.enter(s, true, params.same_place_m, depths_on_the_way(s, inner.thinks_in_plane()),
                     s.own.radius + margin);
  const Capsules solids = standing(s, memory);
  std::optional<avoa_improved::WayRound> way = way_with(params, s, memory, solids, margin);
  if (!way) way = way_with(params, s, memory, solids, narrow_share * margin);
  memory.committed.reset();
  if (!way) return inner.decide_usable(s, context.sketch);
  Situation shown = s;
  shown.is_led = true;
  if (way->is_straight) return inner.decide_usable(shown, context.sketch);

  memory.committed = way->direction;
  const Vec3 preferred = s.preferred_velocity();
  const Vec2 along = horizontal_norm(preferred) * way->direction;
  shown.goal.velocity = Vec3{along.x(), along.y(), preferred.z()};
  if (context.sketch) {
    std::array<Vec3, avoa_improved::WayRound::most_points> points;
    for (std::size_t i = 0; i < way->point_count; ++i)
      points[i] = {way->points[i].x(), way->points[i].y(), s.own.position.z()};
    context.sketch->path({points.data(), way->point_count}, "way round");
  }
  return inner.decide(shown, context.sketch);
}

}  // namespace fairway
