// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/core/crew.hpp"
#include "fairway/metrics/metric.hpp"
#include "fairway/metrics/neighbours.hpp"

namespace fairway {

/// How encounters are counted: raja2024, section IV-B, and its published code.
struct EncounterRules {
  double crit_dist_m{6.0};        ///< a neighbour this near is detected
  double safety_distance_m{3.0};  ///< centres this near have collided
};

/// The six quantities of raja2024, for each vehicle, from its first tick under way until it arrives or is
/// stuck. The worst state of a neighbour is latched while it stays within the detection distance, and
/// counted once when it leaves or the vehicle finishes, and a collision when the run ends, too; each vehicle
/// counts for itself, so one encounter of a pair counts twice. Who is stuck leaves its open ones uncounted.
class EncounterMetric final : public Metric {
 public:
  static const std::vector<QuantityInfo>& quantities();

  /// The worst that a neighbour was to a vehicle since it came within the detection distance.
  enum class Contact : std::uint8_t { none, near, collided };

  /// Another vehicle, by index, and the worst that it was.
  struct OpenEncounter {
    std::uint32_t other{};
    Contact worst{};
  };

  explicit EncounterMetric(EncounterRules rules) : rules_{rules}, neighbours_{rules.crit_dist_m} {}
  void see(const Frame& frame) override;
  void begin(const Frame& frame, std::size_t hands);
  double reach(const Frame& frame, std::size_t index) const;
  void see(const Frame& frame, std::span<const Neighbour> near, std::size_t index, std::size_t hand);
  void report(std::vector<Measure>& measures) const override;

  /// A vehicle's open encounters as of the last frame, in ascending order of the other; none before it is
  /// under way and after it has finished. Valid until the next frame. O(1).
  std::span<const OpenEncounter> contacts(std::size_t index) const { return counts_[index].open; }

 private:
  struct Count {
    bool started{};
    bool finished{};
    bool stuck{};
    int avoided{};
    int collisions{};
    double start_distance{};
    double navigation_time{};
    double avoidance_time{};
    double distance{};
    Vec3 last_position = Vec3::Zero();
    std::vector<OpenEncounter> open;
    Occasion first_collision;
  };

  void set_out(const Frame& frame, std::size_t index);
  bool update_contacts(const Frame& frame, std::size_t index, std::span<const Neighbour> near,
                       std::vector<OpenEncounter>& detected);
  static int open_of(const Count& count, Contact worst);
  static void count_closed(Count& count, Contact worst) {
    ++(worst == Contact::collided ? count.collisions : count.avoided);
  }

  EncounterRules rules_;
  Neighbours neighbours_;
  std::vector<Count> counts_;
  std::vector<OfOneHand<std::vector<OpenEncounter>>> detected_;  // by the vehicle in each hand
  std::vector<Neighbour> near_;                                  // memory to work in
};

}  // namespace fairway
