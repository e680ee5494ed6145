// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film_events.hpp"

#include <algorithm>

namespace fairway {

FilmEvents::FilmEvents(EncounterRules rules, std::size_t vehicles)
    : metric_{rules}, alerts_(vehicles), contacts_(vehicles), phases_(vehicles, Phase::deploying) {}

void FilmEvents::see(const Frame& frame) {
  metric_.see(frame);
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
    see_contacts(frame, i);
    see_phase(frame, i);
  }
}

void FilmEvents::see_contacts(const Frame& frame, std::size_t index) {
  const auto open = metric_.contacts(index);
  const auto add = [&](std::uint32_t other, const char* kind) {
    events_.push_back({frame.time, static_cast<std::uint32_t>(index), other, kind});
  };
  // the metric leaves what is open uncounted when a vehicle is stuck
  const bool counted = frame.vehicles[index].phase != Phase::stuck;
  const auto end = [&](const EncounterMetric::OpenEncounter& left) {
    if (counted) add(left.other, left.worst == Contact::collided ? "collided" : "avoided");
  };

  // both lists ascend
  auto before = contacts_[index].begin();
  const auto last = contacts_[index].end();
  Contact worst = Contact::none;
  for (const EncounterMetric::OpenEncounter& now : open) {
    for (; before != last && before->other < now.other; ++before) end(*before);
    const bool known = before != last && before->other == now.other;
    if (!known || before->worst != now.worst)
      add(now.other, now.worst == Contact::collided ? "collision" : "detected");
    if (known) ++before;
    worst = std::max(worst, now.worst);
  }
  std::for_each(before, last, end);
  contacts_[index].assign(open.begin(), open.end());
  alerts_[index] = static_cast<std::uint8_t>(worst);
}

void FilmEvents::see_phase(const Frame& frame, std::size_t index) {
  const Phase now = frame.vehicles[index].phase;
  if (now == phases_[index]) return;
  phases_[index] = now;
  if (now != Phase::arrived && now != Phase::stuck) return;
  events_.push_back({frame.time, static_cast<std::uint32_t>(index), std::nullopt,
                     now == Phase::arrived ? "arrived" : "stuck"});
}

nlohmann::json FilmEvents::between(double after, double until) const {
  const auto begin = std::ranges::upper_bound(events_, after, {}, &Event::time);
  const auto end = std::ranges::upper_bound(begin, events_.end(), until, {}, &Event::time);
  nlohmann::json all = nlohmann::json::array();
  for (const Event& event : std::span{begin, end}) {
    all.push_back({{"time_s", event.time},
                   {"vehicle", event.vehicle},
                   {"other", event.other ? nlohmann::json(*event.other) : nlohmann::json()},
                   {"kind", event.kind}});
  }
  return all;
}

}  // namespace fairway
