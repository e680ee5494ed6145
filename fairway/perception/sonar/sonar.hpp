// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/core/echo.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/perception/fan.hpp"
#include "fairway/perception/scene.hpp"
#include "fairway/perception/sonar/sonar_params.hpp"
#include "fairway/perception/sonar/sweep.hpp"

namespace fairway {

/// A forward-looking multibeam sonar at a vehicle's origin. It looks at the truth; what its echoes come to is
/// for ContactFinder. Holds scratch memory only.
class Sonar {
 public:
  /// Throws InputError where the parameters contradict each other.
  explicit Sonar(const SonarParams& params);

  /// The echoes of one ping, by bearing, then range: the first surface along each beam, some missed, all
  /// noisy, some false. `rng` decides on misses and noise, `false_rng` on false echoes. Does not allocate
  /// once `echoes` has the capacity.
  void ping(const VehicleState& truth, const Scene& scene, Rng& rng, Rng& false_rng,
            std::vector<Echo>& echoes);

  /// What a ping from this state looks into.
  Fan fan(const VehicleState& state) const;

 private:
  void add_true(Rng& rng, std::vector<Echo>& echoes) const;
  void add_false(Rng& rng, std::vector<Echo>& echoes) const;

  SonarParams params_;
  Sweep sweep_;
};

}  // namespace fairway
