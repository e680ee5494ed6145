// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "fairway/metrics/encounters.hpp"
#include "fairway/record/frame.hpp"

namespace fairway {

/// What happens to vehicles in a run, by the metric that counts it: fed with every frame.
class FilmEvents {
 public:
  FilmEvents(EncounterRules rules, std::size_t vehicles);

  void see(const Frame& frame);

  /// The alert of each vehicle as of the last frame: 0 clear, 1 somebody detected, 2 a collision until that
  /// one leaves.
  std::span<const std::uint8_t> alerts() const { return alerts_; }

  /// The page's events at times in (after, until].
  nlohmann::json between(double after, double until) const;

 private:
  using Contact = EncounterMetric::Contact;

  struct Event {
    double time;
    std::uint32_t vehicle;
    std::optional<std::uint32_t> other;
    const char* kind;
  };

  void see_contacts(const Frame& frame, std::size_t index);
  void see_phase(const Frame& frame, std::size_t index);

  EncounterMetric metric_;
  std::vector<std::uint8_t> alerts_;
  std::vector<std::vector<EncounterMetric::OpenEncounter>> contacts_;  // as of the last frame, by vehicle
  std::vector<Phase> phases_;                                          // likewise
  std::vector<Event> events_;                                          // times ascend
};

}  // namespace fairway
