// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/neighbours.hpp"

#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"
#include "fairway/metrics/run_metrics.hpp"

namespace fairway {
namespace {

/// Counts what comparing every pair comes to, as the metrics define it.
class EveryPair {
 public:
  explicit EveryPair(std::size_t count)
      : n{count},
        set_out(n),
        nearest(n, INFINITY),
        nearest_with(n, -1),
        touching(n * n),
        contact(n * n),
        avoided(n),
        collided(n) {}

  void see(const std::vector<VehicleFrame>& vehicles) {
    for (std::size_t i = 0; i < n; ++i) set_out[i] = set_out[i] || has_set_out(vehicles[i].phase);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (i == j) continue;
        const double distance = (vehicles[i].state.p_n - vehicles[j].state.p_n).norm();
        see_encounter(vehicles[i].phase, i, j, distance);
        if (set_out[i] && distance < nearest[i]) {
          nearest[i] = distance;
          nearest_with[i] = static_cast<int>(j);
        }
        if (i > j || !(set_out[i] || set_out[j])) continue;
        if (distance <= 3.0 && !touching[i * n + j]) ++pair_events;
        touching[i * n + j] = distance <= 3.0;
      }
    }
  }

  /// Of those that are near at the end.
  int open_collisions(std::size_t i) const {
    const auto row = contact.begin() + static_cast<std::ptrdiff_t>(i * n);
    return static_cast<int>(std::count(row, row + static_cast<std::ptrdiff_t>(n), 2));
  }

  std::size_t n;
  std::vector<bool> set_out;
  std::vector<double> nearest;
  std::vector<int> nearest_with;
  int pair_events{};
  std::vector<bool> touching;
  std::vector<int> contact;  // 1 detected, 2 collided
  std::vector<int> avoided, collided;

 private:
  void see_encounter(Phase phase, std::size_t i, std::size_t j, double distance) {
    int& worst = contact[i * n + j];
    if (phase != Phase::under_way) return;
    if (distance <= 6.0) {
      worst = std::max(worst, distance <= 3.0 ? 2 : 1);
    } else if (worst > 0) {
      ++(worst == 2 ? collided : avoided)[i];
      worst = 0;
    }
  }
};

/// A crowd that drifts by up to `drift` and stumbles by up to `stumble` along each axis and tick [m].
void hold_to_every_pair(std::size_t count, double drift, double stumble) {
  Rng rng{count};
  const auto any = [&](double most) {
    return Vec3{rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most)};
  };
  const double size = 4.0 * std::cbrt(static_cast<double>(count));
  std::vector<VehicleFrame> vehicles(count);
  std::vector<Vec3> velocities;
  for (VehicleFrame& vehicle : vehicles) {
    vehicle.state.p_n = any(size);
    vehicle.phase = Phase::under_way;
    velocities.push_back(any(drift));
  }
  RunMetrics metrics{{6.0, 3.0}};
  EveryPair every{count};
  for (std::int64_t tick = 0; tick < 300; ++tick) {
    for (std::size_t i = 0; i < count; ++i) vehicles[i].state.p_n += velocities[i] + any(stumble);
    vehicles[0].phase = tick % 20 < 5 ? Phase::deploying : Phase::under_way;  // sets out later, and pauses
    vehicles[1].phase = tick < 150 ? Phase::waiting : Phase::under_way;
    metrics.write({Tick{tick}, static_cast<double>(tick), 1.0, vehicles});
    every.see(vehicles);
  }
  for (const Measure& m : metrics.measures()) {
    const auto i = static_cast<std::size_t>(std::max(m.vehicle, 0));
    if (m.quantity == "pair_collision_count") {
      EXPECT_EQ(m.value, every.pair_events);
      EXPECT_GT(m.value, 0.0);
    } else if (m.quantity == "nearest_m") {
      EXPECT_EQ(m.value, every.nearest[i]);
      EXPECT_EQ(m.occasion.other, every.nearest_with[i]);
    } else if (m.quantity == "avoided_count" && i > 0) {  // the first one begins and pauses
      EXPECT_EQ(m.value, every.avoided[i]);
    } else if (m.quantity == "collision_count" && i > 0) {
      EXPECT_EQ(m.value, every.collided[i] + every.open_collisions(i));
    }
  }
}

TEST(RunMetrics, WhoIsNearIsFoundAsByComparingEveryPair) {
  for (const std::size_t count : {12U, 60U, 300U}) {
    SCOPED_TRACE(count);
    hold_to_every_pair(count, 0.05, 0.0);
    hold_to_every_pair(count, 0.0, 1.0);
    hold_to_every_pair(count, 0.02, 0.02);
  }
}

}  // namespace
}  // namespace fairway
