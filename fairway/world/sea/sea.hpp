// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/core/state.hpp"
#include "fairway/core/water.hpp"
#include "fairway/world/sea/current.hpp"
#include "fairway/world/sea/wave_component.hpp"

namespace fairway {

/// The water of a run, everywhere and at all times: waves, superposed linearly, on currents, which add to
/// them and do not change them. Everyone in a run is in the same sea. A value: a copy is a snapshot.
/// docs/sea.md has the equations and what is left out.
class Sea {
 public:
  /// Waves draw from `rng`'s stream "waves", the current from "current".
  Sea(const WaterSpec& spec, const Rng& rng);

  /// Moves what wanders on by `h` [s].
  void advance(double h) noexcept;

  /// At `p_n` [m, NED] at `time` [s] since the start, with the currents as they wander now. What is above the
  /// calm surface is taken as in it. O(waves): a sine, a cosine and, below the surface, an exponential each;
  /// without waves and shear it is a copy.
  Water water_at(const Vec3& p_n, double time) const noexcept {
    return is_uniform() ? uniform_ : water_there(p_n, time);
  }

  /// What whoever is in the state `x` meets halfway through a step of `h` [s] from `time`. Held over the
  /// step, it brings an error of second order in h; the water at the step's beginning would bring one of
  /// first.
  Water water_halfway(const VehicleState& x, double time, double h) const noexcept {
    return is_uniform() ? uniform_ : water_there(x.p_n + 0.5 * h * x.v_n(), time + 0.5 * h);
  }

  /// What flows at `depth` [m, down] without the waves' orbital motion, as it wanders now [m/s, NED].
  Vec3 current_at(double depth) const noexcept;

  /// What the surface is the sum of; empty where it is calm.
  std::span<const WaveComponent> waves() const { return waves_; }

 private:
  /// Whether it is the same everywhere and at all times.
  bool is_uniform() const noexcept { return waves_.empty() && !sheared_ && !wandering_; }

  Water water_there(const Vec3& p_n, double time) const noexcept;
  void add_waves(const Vec3& p_n, double time, Water& water) const noexcept;

  Water uniform_;
  std::vector<WaveComponent> waves_;
  std::optional<ShearedCurrent> sheared_;
  std::optional<GaussMarkovCurrent> wandering_;
};

}  // namespace fairway
