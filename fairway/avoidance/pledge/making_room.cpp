// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/making_room.hpp"

#include <algorithm>
#include <array>

#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr double to_spare = 0.5;  // beyond what has to be between two [m]

/// What own ship has to keep clear of.
struct Surroundings {
  const Agreement& agreement;
  const Chart& chart;
  const Limits& limits;

  double berth_of_own() const { return berth(agreement.own(), agreement.terms().tubes); }

  /// From the place of one who is of that radius, as far as own ship has to be from it.
  bool is_near(const Vec3& a, const Vec3& b, double radius, double spare) const {
    const Tubes& tubes = agreement.terms().tubes;
    return (a - b).norm() < berth_of_own() + radius + tubes.radius + 0.5 * tubes.told + spare;
  }

  static bool is_in(std::span<const Obstacle> obstacles, const Vec3& place, double off) {
    return std::ranges::any_of(
        obstacles, [&](const Obstacle& obstacle) { return nearest_point(obstacle, place).distance < off; });
  }

  /// Whether somebody of another group lies there, or is on its way there.
  bool is_taken(const Vec3& place, double spare) const {
    const auto ends_there = [&](const Passing& other) {
      return is_near(place, other.way.knots().back().position, other.radius, spare);
    };
    return is_in(chart.held(), place, berth_of_own() + spare) ||
           std::ranges::any_of(chart.passing(), ends_there);
  }

  /// Whether somebody else is to go there.
  bool is_wanted(const Vec3& place, double spare) const {
    for (const Bystander& other : agreement.others().bystanders())
      if (other.known && is_near(place, other.destination, other.radius, spare)) return true;
    for (std::size_t i = 0; i < agreement.count(); ++i) {
      const Member& mate = agreement.member(i);
      if (i != agreement.self() && is_near(place, mate.destination, mate.radius, spare)) return true;
    }
    return false;
  }

  bool is_free(const Vec3& place) const {
    for (std::size_t i = 0; i < agreement.count(); ++i) {
      const Member& mate = agreement.member(i);
      if (i != agreement.self() && is_near(place, mate.anchor, mate.radius, to_spare)) return false;
    }
    Member there = agreement.own();
    there.destination = place;
    return place.z() >= math::fmax(limits.min_depth, 0.0) && place.z() <= limits.max_depth &&
           fits(there, agreement.terms().datum) && !is_wanted(place, to_spare) &&
           !is_in(chart.standing(), place, berth_of_own() + to_spare) && !is_taken(place, to_spare);
  }

  /// The first free place about another: back to own ship, below, above, on either side and beyond; or from
  /// another of these on.
  std::optional<Vec3> free_place_about(const Vec3& middle, std::size_t first = 0) const {
    const Vec2 apart = agreement.own().anchor.head<2>() - middle.head<2>();
    const Vec2 back = apart.norm() > 1.0 ? Vec2{apart.normalized()} : Vec2{1.0, 0.0};
    const Vec2 side = starboard_of(back);
    const std::array<Vec3, 6> directions{Vec3{back.x(), back.y(), 0},
                                         Vec3{0, 0, 1},
                                         Vec3{0, 0, -1},
                                         Vec3{side.x(), side.y(), 0},
                                         Vec3{-side.x(), -side.y(), 0},
                                         Vec3{-back.x(), -back.y(), 0}};
    const double least = 2.0 * berth_of_own() + 2.0 * to_spare;
    for (const double ratio : {1.0, 1.5, 2.0, 3.0}) {
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vec3& direction = directions[(first + i) % directions.size()];
        if (direction.z() != 0.0 && limits.max_climb_rate <= 0.0) continue;
        const Vec3 place = middle + ratio * least * direction;
        if (is_free(place)) return place;
      }
    }
    return {};
  }
};

}  // namespace

Aim aim_of(const Agreement& agreement, const Vec3& goal, const Chart& chart, const Limits& limits,
           std::optional<std::size_t> stuck) noexcept {
  const Surroundings about{agreement, chart, limits};
  const Vec3& anchor = agreement.own().anchor;
  if (!about.is_taken(goal, 0.0)) {
    const std::optional<Vec3> other = stuck ? about.free_place_about(anchor, *stuck) : std::nullopt;
    return other ? Aim{Aim::Kind::aside, *other} : Aim{Aim::Kind::goal, goal};
  }
  if (!about.is_wanted(anchor, 0.0)) return {Aim::Kind::none, anchor};
  std::optional<Vec3> place = about.free_place_about(goal);
  if (!place) place = about.free_place_about(anchor);
  return place ? Aim{Aim::Kind::aside, *place} : Aim{Aim::Kind::none, anchor};
}

}  // namespace fairway::pledge
