// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/datum.hpp"

#include <cmath>

namespace fairway::pledge {
namespace {

constexpr int enough = 2;           // misfits in a row: a member may have been held elsewhere meanwhile
constexpr double deviations = 4.0;  // of a measurement, that are its own error

double distance_at(const Reference& a, const Reference& b, double time) noexcept {
  return (a.at(time) - b.at(time)).norm();
}

}  // namespace

void DatumWatch::look(const Agreement& agreement, std::span<const AcousticRange> ranges, bool rests,
                      double unsure) noexcept {
  const bool is_held = agreement.status() == Status::held || agreement.status() == Status::arrived;
  if (agreement.way() == nullptr && !(is_held && rests)) return;
  const Groups& groups = agreement.rounds().groups();
  const std::size_t own_group = groups.group_of(agreement.vehicle());
  const Reference own = agreement.way() != nullptr ? *agreement.way() : Reference{agreement.own().anchor};
  const Tubes& tubes = agreement.terms().tubes;
  for (const AcousticRange& range : ranges) {
    const std::size_t vehicle = number(range.to);
    if (vehicle >= groups.vehicles || groups.group_of(vehicle) != own_group || range.out >= range.back)
      continue;
    const std::size_t member = groups.member_of(vehicle);
    Known& known = known_[member];
    const Reference other = agreement.whereabouts(member);
    if (range.back <= known.back || other.empty() || agreement.is_lost(member)) continue;
    known.back = range.back;
    const double promised = 0.5 * (distance_at(own, other, range.out) + distance_at(own, other, range.back));
    const double allowed = 2.0 * (tubes.radius + tubes.told + unsure) + deviations * range.deviation;
    known.misfits = std::abs(range.distance - promised) > allowed ? known.misfits + 1 : 0;
  }
}

Members DatumWatch::doubted() const noexcept {
  Members all;
  for (std::size_t i = 0; i < most_members; ++i) all[i] = known_[i].misfits >= enough;
  return all;
}

}  // namespace fairway::pledge
