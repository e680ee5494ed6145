// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/clearance.hpp"

#include <algorithm>

namespace fairway::pledge {
namespace {

// so much farther off a gate is than two may be, so that whoever stops at it can be given another plan [m]
constexpr double beyond = 0.05;

}  // namespace

double Clearance::apart(std::size_t a, std::size_t b) const noexcept {
  return members_[a].radius + members_[b].radius + 2.0 * tubes_.radius + tubes_.told;
}

Clearance::Gates Clearance::gates_of(std::size_t member, const Reference& reference) const noexcept {
  Gates gates;
  for (std::size_t other = 0; other < most_members; ++other) {
    const bool has_none = other == member || !participants_[other] || reference.knots().size() < 2;
    gates[other] = has_none ? never  // nobody comes nearer who stays where it is
                            : first_within(reference, members_[other].anchor, apart(member, other) + beyond);
  }
  return gates;
}

Clearance::Stops Clearance::stops_of(std::size_t member, const Reference& reference,
                                     const Gates& gates) const noexcept {
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

bool Clearance::are_clear(std::size_t member, const Stops& stops, std::size_t other,
                          const Reference& of_other) const noexcept {
  for (std::size_t i = 0; i < stops.count; ++i) {
    if (least_distance(Reference{stops.all[i].place}, of_other, stops.all[i].time) < apart(member, other))
      return false;
  }
  return true;
}

bool Clearance::accepts(std::size_t member, const Reference& reference) const noexcept {
  for (std::size_t other = 0; other < most_members; ++other) {
    if (other != member && placed_[other] &&
        least_distance(reference, references_[other], start_) < apart(member, other))
      return false;
  }
  const Gates gates = gates_of(member, reference);
  if (*std::ranges::min_element(gates) <= start_) return false;
  const Stops stops = stops_of(member, reference, gates);
  for (std::size_t other = 0; other < most_members; ++other) {
    if (other != member && placed_[other] &&
        (!are_clear(member, stops, other, references_[other]) ||
         !are_clear(other, stops_[other], member, reference)))
      return false;
  }
  return true;
}

void Clearance::place(std::size_t member, const Reference& reference) noexcept {
  references_[member] = reference;
  gates_[member] = gates_of(member, reference);
  stops_[member] = stops_of(member, reference, gates_[member]);
  placed_.set(member);
}

}  // namespace fairway::pledge
