// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/clearance.hpp"

#include <algorithm>
#include <bit>

namespace fairway::pledge {
namespace {

// so much farther off a gate is than two may be, so that whoever stops at it can be given another plan [m]
constexpr double so_far = 0.05;

constexpr double hair = 0.001;         // of rounding, where something begins too near and comes no nearer [m]
constexpr double least_stride = 0.05;  // along a reference beside what stands [m]

/// Goes along a way beside an obstacle: from each place on by as much as nothing can be in the way.
struct Walk {
  const Obstacle& obstacle;
  double distance;    ///< to be kept [m]
  double ahead{0.0};  ///< for so long nothing can be in the way [m]

  bool is_clear_at(const Vec3& place) {
    const double off = nearest_point(obstacle, place).distance;
    ahead = std::max(off - distance, least_stride);
    return off >= distance;
  }

  /// Along a straight piece.
  bool is_clear_along(const Vec3& from, const Vec3& to) {
    const double length = (to - from).norm();
    double gone = ahead;
    while (gone < length) {
      if (!is_clear_at(from + (gone / length) * (to - from))) return false;
      gone += ahead;
    }
    ahead = gone - length;
    return true;
  }
};

}  // namespace

/// How far two have to be from each other who begin at these places.
double Clearance::apart(std::size_t a, std::size_t b, const Vec3& from, const Vec3& to,
                        double beyond) const noexcept {
  return std::min(least_apart(members_[a], members_[b], tubes_) + beyond, (from - to).norm() - hair);
}

Clearance::Gates Clearance::gates_of(std::size_t member, const Reference& reference) const noexcept {
  Gates gates;
  const Vec3 begin = reference.at(start_);
  for (std::size_t other = 0; other < most_members; ++other) {
    const bool has_none = other == member || !participants_[other] || reference.knots().size() < 2;
    const Vec3& anchor = members_[other].anchor;
    gates[other] = has_none ? never  // nobody comes nearer who stays where it is
                            : first_within(reference, anchor, apart(member, other, begin, anchor, so_far));
  }
  return gates;
}

Stops Clearance::stops_of(std::size_t member, const Reference& reference, const Gates& gates) const noexcept {
  Stops stops;
  for (const double gate : gates)
    if (gate < never) stops.add(gate, reference.at(gate));
  const Member& m = members_[member];
  const double near = first_within(reference, m.destination, m.arrival + tubes_.radius);
  if (near < reference.end()) {
    stops.add(near, reference.at(near));
    stops.add(near, reference.at(0.5 * (near + reference.end())));
  }
  return stops;
}

bool Clearance::are_clear(const Stops& stops, const Reference& of_other, double apart) noexcept {
  for (std::size_t i = 0; i < stops.count; ++i) {
    const Knot stop{stops.all[i].time, stops.all[i].place};
    if (least_distance({&stop, 1}, of_other, stop.time, never, apart) < apart) return false;
  }
  return true;
}

std::optional<std::size_t> Clearance::hindered_by(std::size_t member, const Reference& reference,
                                                  std::size_t suspected) const noexcept {
  static_assert(std::has_single_bit(most_members), "so that the others can be told apart by a bit");
  std::array<double, most_members> apart_from{};
  const Vec3 begin = reference.at(start_);
  for (std::size_t i = 0; i < most_members; ++i) {
    const std::size_t other = i ^ suspected;  // that one first, and everybody once
    if (other == member || !placed_[other]) continue;
    apart_from[other] = apart(member, other, begin, references_[other].at(start_));
    const double apart_here = apart_from[other];
    if (least_distance(reference, references_[other], start_, never, apart_here) < apart_here) return other;
  }
  const Gates gates = gates_of(member, reference);
  if (*std::ranges::min_element(gates) <= start_) return member;
  const Stops stops = stops_of(member, reference, gates);
  for (std::size_t i = 0; i < most_members; ++i) {
    const std::size_t other = i ^ suspected;
    if (other != member && placed_[other] &&
        (!are_clear(stops, references_[other], apart_from[other]) ||
         !are_clear(stops_[other], reference, apart_from[other])))
      return other;
  }
  return {};
}

bool Clearance::passes(std::size_t member, const Reference& reference,
                       std::span<const Passing> passing) const noexcept {
  if (passing.empty()) return true;
  const Stops stops = stops_of(member, reference, gates_of(member, reference));
  const Vec3 begin = reference.at(start_);
  return std::ranges::all_of(passing, [&](const Passing& other) {
    const double needed = least_apart(members_[member].radius, other.radius, tubes_);
    const double apart_here = std::min(needed, (begin - other.way.at(start_)).norm() - hair);
    return least_distance(reference, other.way, start_, never, apart_here) >= apart_here &&
           are_clear(stops, other.way, apart_here) && are_clear(other.stops, reference, apart_here);
  });
}

Passing Clearance::passing(std::size_t member, const Reference& reference) const noexcept {
  return {.vehicle = member,
          .radius = members_[member].radius,
          .way = reference,
          .stops = stops_of(member, reference, gates_of(member, reference))};
}

void Clearance::place(std::size_t member, const Reference& reference) noexcept {
  references_[member] = reference;
  gates_[member] = gates_of(member, reference);
  stops_[member] = stops_of(member, reference, gates_[member]);
  placed_.set(member);
}

bool keeps_off(const Reference& reference, const Obstacle& obstacle, double distance, double from,
               double to) noexcept {
  const std::span<const Knot> all = reference.knots();
  Vec3 place = reference.at(std::max(from, all.front().time));
  Walk walk{obstacle, std::min(distance, nearest_point(obstacle, place).distance - hair)};
  for (const Knot& knot : all) {
    if (knot.time <= from) continue;
    const Vec3 next = knot.time < to ? knot.position : reference.at(to);
    if (!walk.is_clear_along(place, next)) return false;
    place = next;
    if (knot.time >= to) break;
  }
  return walk.is_clear_at(place);
}

bool keeps_off(const Reference& reference, const Chart& chart, double distance, double from,
               double to) noexcept {
  for (const std::span<const Obstacle> part : chart.parts())
    for (const Obstacle& obstacle : part)
      if (!keeps_off(reference, obstacle, distance, from, to)) return false;
  return true;
}

}  // namespace fairway::pledge
