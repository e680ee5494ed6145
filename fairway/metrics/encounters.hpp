// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/metrics/metric.hpp"

namespace fairway {

/// How encounters are counted: raja2024, section IV-B, and its published code.
struct EncounterRules {
  double crit_dist_m{6.0};        ///< a neighbour this near is detected
  double safety_distance_m{3.0};  ///< centres this near have collided
};

/// The six quantities of raja2024, for each vehicle, from its first tick under way until it arrives or is
/// stuck. The worst state of a neighbour is latched while it stays within the detection distance, and
/// counted once when it leaves or the vehicle finishes; each vehicle counts for itself, so one
/// encounter of a pair counts twice.
class EncounterMetric final : public Metric {
 public:
  static const std::vector<QuantityInfo>& quantities();

  /// The worst that a neighbour was to a vehicle since it came within the detection distance.
  enum class Contact : std::uint8_t { none, near, collided };

  explicit EncounterMetric(EncounterRules rules) : rules_{rules} {}
  void see(const Frame& frame) override;
  void report(std::vector<Measure>& measures) const override;

  /// A vehicle's open encounters as of the last frame, by index of the other; empty before it is under way
  /// and after it has finished. Valid until the next frame. O(1).
  std::span<const Contact> contacts(std::size_t index) const { return counts_[index].contacts; }

 private:
  struct Count {
    bool started{};
    bool finished{};
    bool stuck{};
    double start_distance{};
    double navigation_time{};
    double avoidance_time{};
    double distance{};
    int avoided{};
    int collisions{};
    Vec3 last_position = Vec3::Zero();
    std::vector<Contact> contacts;  ///< by index of the other vehicle
    Occasion first_collision;
  };

  void see(const Frame& frame, std::size_t index);
  void begin(const Frame& frame, std::size_t index);
  bool update_contacts(const Frame& frame, std::size_t index);

  EncounterRules rules_;
  std::vector<Count> counts_;
};

}  // namespace fairway
