// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/core/tick.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/world/sea/sea.hpp"

namespace fairway {

/// Where the page shows currents [m, down]: nowhere in still water, at the surface where the water is the
/// same at all depths, else at the depths of the profile, eight at most.
std::vector<double> current_depths(const WaterSpec& water);

/// The currents of a run without what waves do: the scenario's sea, moved on tick by tick as the run does.
class FilmWater {
 public:
  explicit FilmWater(const Scenario& scenario);

  /// Ticks ascend. O(ticks since the last).
  void move_to(Tick tick);

  /// At each of the depths [m/s, NED], as of the last tick.
  std::span<const Vec3> currents() const { return currents_; }

 private:
  void look();

  Sea sea_;
  double period_;
  Tick tick_{0};
  std::vector<double> depths_;
  std::vector<Vec3> currents_;
};

}  // namespace fairway
