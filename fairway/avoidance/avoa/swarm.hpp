// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/avoidance/avoa/velocity_space.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::avoa {

/// A step of a particle: of its speed and of its heading.
struct PolarStep {
  double speed{};    ///< l [m/s]
  double heading{};  ///< h [rad]
};

/// Particle swarm optimisation over the feasible velocities (campos2019, eqs. 9 and 10, Algorithms 1 and 2;
/// Kennedy and Eberhart 1995). Keeps its particles, so it allocates only when there are more of them.
class Swarm {
 public:
  struct Settings {
    int particles{};         ///< npart
    int iterations{};        ///< maxit
    double accepted_cost{};  ///< a_e
    double inertia{};        ///< phi_1
    double personal{};       ///< phi_2
    double common{};         ///< phi_3
    PolarStep shake;         ///< phi_4
    PolarStep start;         ///< v_ini
  };

  struct Particle {
    PolarVelocity position;  ///< P
    int cell{};              ///< the one nearest to it
    PolarStep step;          ///< V
    PolarVelocity best;      ///< pBest
    double best_cost{};
  };

  /// The best of `first` and all that the swarm comes across. A particle costs what its
  /// velocity does with the danger of the nearest cell, and is feasible if that cell is.
  /// O(particles * iterations)
  Candidate search(const VelocitySpace& space, const VelocityMetric& metric, const Candidate& first,
                   const Settings& settings, Rng& rng);

  /// As they were when the search ended; none if it had no need to begin.
  std::span<const Particle> particles() const { return particles_; }

 private:
  std::vector<Particle> particles_;
};

}  // namespace fairway::avoa
