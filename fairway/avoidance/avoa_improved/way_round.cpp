// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/way_round.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "fairway/avoidance/avoa_improved/tangent.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::avoa_improved {
namespace {

/// A way may cut a solid this deep: rounding, and what is missed between two samples of an arc [m].
constexpr double way_tolerance = 1e-6;

/// Between samples of an arc [rad]. What pokes through between two of them is shallower than 0.13 % of the
/// radius.
constexpr double arc_step = 0.1;

/// Passing with what is in the way to port costs this much less, so that of two equal ways that to starboard
/// is taken [m].
constexpr double starboard_bonus = 0.05;

constexpr std::size_t most_solids = 2 * Capsules::capacity;
constexpr std::size_t most_ends = 2 * most_solids;
constexpr std::size_t most_legs = 2048;
constexpr int none = -1;

/// A rounded end of a solid.
struct End {
  Vec2 centre = Vec2::Zero();
  double radius{};

  Turn turn(Side side) const { return {centre, radius, side}; }
};

/// A straight line and the turn at its end. The last leg ends at the goal, on no end.
struct Leg {
  int end;
  Side side;
  int before;       ///< the leg before, or none
  double arrival;   ///< angle at which the turn is met [rad]
  double cost;      ///< from the beginning to the end of the line [m]
  double estimate;  ///< cost, and straight on to the goal [m]
  Vec2 from;
  Vec2 to;
};

/// Which turn is left for which: every such line is taken once.
std::size_t line_index(std::size_t from, Side from_side, std::size_t to, Side to_side) {
  const auto turn = [](std::size_t end, Side side) {
    return 2 * end + (side == Side::to_starboard ? 1U : 0U);
  };
  return turn(from, from_side) * 2 * most_ends + turn(to, to_side);
}

/// The first turn along each side of an end, and how far it may be followed.
struct Followed {
  bool is_reached = false;
  double arrival{};  ///< [rad]
  double extent{};   ///< [rad]
  double cost{};     ///< [m]
};

bool is_clear(std::span<const Capsule> solids, const Vec2& p, const Vec2& q) {
  return std::ranges::all_of(
      solids, [&](const Capsule& s) { return distance_to_axis(s, p, q) >= s.radius - way_tolerance; });
}

/// A solid that `own` or `goal` lies in is made just so wide that it does not, by more than rounding.
Capsule narrowed(Capsule solid, const Vec2& own, const Vec2& goal) {
  for (const Vec2& p : {own, goal})
    solid.radius = std::min(solid.radius, (1.0 - 1e-9) * distance_to_axis(solid, p));
  return solid;
}

WayRound straight_way(const Vec2& own, const Vec2& goal) {
  WayRound way{.is_straight = true, .length = (goal - own).norm()};
  if (way.length > 0.0) way.direction = (goal - own) / way.length;
  way.points[0] = own;
  way.points[1] = goal;
  way.point_count = 2;
  return way;
}

class Search {
 public:
  Search(std::span<const Capsule> solids, const Vec2& own, const Vec2& goal, const Preference& preference)
      : own_{own}, goal_{goal}, preference_{preference}, solids_{solids} {
    for (const Capsule& solid : solids) {
      add_end({solid.from, solid.radius});
      if (!solid.is_disc()) add_end({solid.to, solid.radius});
    }
  }

  std::optional<WayRound> find() {
    begin();
    while (heap_count_ > 0) {
      const int leg = pop();
      const Leg& l = legs_[static_cast<std::size_t>(leg)];
      if (l.end != none && !is_first(l)) continue;
      if (!is_clear(solids_, l.from, l.to)) continue;
      if (l.end == none) return told(leg);
      follow(leg);
    }
    return {};
  }

 private:
  void add_end(const End& end) {
    const auto is_same = [&](const End& e) { return e.centre == end.centre && e.radius == end.radius; };
    const auto last = ends_.begin() + static_cast<std::ptrdiff_t>(end_count_);
    if (std::none_of(ends_.begin(), last, is_same)) ends_[end_count_++] = end;
  }

  /// From own ship to every turn.
  void begin() {
    const Turn own{own_, 0.0, Side::to_port};
    for (std::size_t i = 0; i < end_count_; ++i) {
      for (const Side side : {Side::to_port, Side::to_starboard}) {
        const auto line = tangent(own, ends_[i].turn(side));
        if (!line) continue;
        push(ends_[i].turn(side), static_cast<int>(i), none, own_, *line,
             line->length + reluctance(line->heading, side));
      }
    }
  }

  /// What a first line costs beyond its length.
  double reluctance(double heading, Side side) const {
    double extra = side == Side::to_starboard ? starboard_bonus : 0.0;
    const Vec2 direction = unit_at(heading);
    if (preference_.heading)
      extra += preference_.bend * math::acos(std::clamp(preference_.heading->dot(direction), -1.0, 1.0));
    if (preference_.committed) {
      const double agreement = preference_.committed->dot(direction);
      extra += preference_.commitment * 0.5 * (1.0 - agreement);
    }
    return extra;
  }

  bool is_first(const Leg& l) {
    if (l.before == none) return true;
    const Leg& before = legs_[static_cast<std::size_t>(l.before)];
    const std::size_t line = line_index(static_cast<std::size_t>(before.end), before.side,
                                        static_cast<std::size_t>(l.end), l.side);
    if (taken_[line]) return false;
    taken_[line] = true;
    return true;
  }

  /// From the turn at the end of a leg to every other one, and to the goal.
  void follow(int leg) {
    const Leg l = legs_[static_cast<std::size_t>(leg)];
    const Turn turn = ends_[static_cast<std::size_t>(l.end)].turn(l.side);
    Followed& first =
        followed_[2 * static_cast<std::size_t>(l.end) + (l.side == Side::to_starboard ? 1U : 0U)];
    if (first.is_reached) {
      const double sweep = turn.sweep(first.arrival, l.arrival);
      if (sweep <= first.extent && first.cost + (turn.radius + preference_.bend) * sweep <= l.cost) return;
    }
    const double extent = extent_of(turn, l.arrival);
    if (!first.is_reached) first = {true, l.arrival, extent, l.cost};

    const auto leave = [&](const Turn& next, int end) {
      const auto line = tangent(turn, next);
      if (!line) return;
      const double sweep = turn.sweep(l.arrival, line->departure);
      if (sweep > extent) return;
      push(next, end, leg, turn.at(line->departure), *line,
           l.cost + (turn.radius + preference_.bend) * sweep + line->length);
    };
    leave({goal_, 0.0, Side::to_port}, none);
    for (std::size_t i = 0; i < end_count_; ++i) {
      if (static_cast<int>(i) == l.end) continue;
      for (const Side side : {Side::to_port, Side::to_starboard})
        leave(ends_[i].turn(side), static_cast<int>(i));
    }
  }

  /// How far a turn may be followed until a solid is in the way [rad].
  double extent_of(const Turn& turn, double arrival) const {
    std::array<const Capsule*, most_solids> near;
    std::size_t near_count = 0;
    for (const Capsule& solid : solids_) {
      if (distance_to_axis(solid, turn.centre) < solid.radius + turn.radius) near[near_count++] = &solid;
    }
    constexpr int most_steps = static_cast<int>(2.0 * pi / arc_step);
    for (int k = 1; k <= most_steps; ++k) {
      const Vec2 p = turn.at(arrival + sign_of(turn.side) * arc_step * k);
      for (std::size_t i = 0; i < near_count; ++i) {
        if (distance_to_axis(*near[i], p) < near[i]->radius - way_tolerance) return arc_step * k;
      }
    }
    return 2.0 * pi;
  }

  /// The leg that leaves the turn after `before` at `from` for the turn `to` along a line.
  void push(const Turn& to, int end, int before, const Vec2& from, const Tangent& line, double cost) {
    if (leg_count_ == most_legs) return;
    const Vec2 touch = to.at(line.arrival);
    const double estimate = cost + (goal_ - touch).norm();
    legs_[leg_count_] = {end, to.side, before, line.arrival, cost, estimate, from, touch};
    heap_[heap_count_++] = static_cast<int>(leg_count_++);
    std::push_heap(heap_.begin(), heap_.begin() + heap_count_,
                   [this](int a, int b) { return is_later(a, b); });
  }

  int pop() {
    std::pop_heap(heap_.begin(), heap_.begin() + heap_count_,
                  [this](int a, int b) { return is_later(a, b); });
    return heap_[static_cast<std::size_t>(--heap_count_)];
  }

  bool is_later(int a, int b) const {
    const double one = legs_[static_cast<std::size_t>(a)].estimate;
    const double other = legs_[static_cast<std::size_t>(b)].estimate;
    return one != other ? one > other : a > b;
  }

  WayRound told(int last) const {
    WayRound way{.length = legs_[static_cast<std::size_t>(last)].cost};
    const auto add = [&](const Vec2& p) {
      if (way.point_count < WayRound::most_points) way.points[way.point_count++] = p;
    };
    int first = last;
    for (int leg = last; leg != none; leg = legs_[static_cast<std::size_t>(leg)].before) {
      add(legs_[static_cast<std::size_t>(leg)].to);
      add(legs_[static_cast<std::size_t>(leg)].from);
      first = leg;
    }
    std::reverse(way.points.begin(), way.points.begin() + static_cast<std::ptrdiff_t>(way.point_count));

    // on a turn already, its direction is that of the turn: the line to it has no length
    const Leg& begin = legs_[static_cast<std::size_t>(first)];
    const double heading = begin.arrival + 0.5 * pi * sign_of(begin.side);
    way.direction = unit_at(heading);
    return way;
  }

  Vec2 own_;
  Vec2 goal_;
  Preference preference_;
  std::span<const Capsule> solids_;
  std::array<End, most_ends> ends_;
  std::size_t end_count_ = 0;
  std::array<Leg, most_legs> legs_;
  std::size_t leg_count_ = 0;
  std::array<int, most_legs> heap_;
  std::ptrdiff_t heap_count_ = 0;
  std::array<Followed, 2 * most_ends> followed_;
  std::bitset<4 * most_ends * most_ends> taken_;
};

}  // namespace

std::optional<WayRound> way_round(std::span<const Capsule> solids, const Vec2& own, const Vec2& goal,
                                  const Preference& preference) noexcept {
  std::array<Capsule, most_solids> narrow;
  const std::size_t count = std::min(solids.size(), most_solids);
  for (std::size_t i = 0; i < count; ++i) narrow[i] = narrowed(solids[i], own, goal);
  const std::span<const Capsule> in_the_way{narrow.data(), count};
  if (is_clear(in_the_way, own, goal)) return straight_way(own, goal);
  return Search{in_the_way, own, goal, preference}.find();
}

}  // namespace fairway::avoa_improved
