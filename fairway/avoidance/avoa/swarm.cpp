// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/swarm.hpp"

#include <cmath>
#include <limits>

namespace fairway::avoa {
namespace {

/// A particle is static if it makes steps below this [m/s, rad].
constexpr double rest = 1e-6;

/// The swarm's moves, in order of the pseudocode.
class Moves {
 public:
  Moves(const VelocitySpace& space, const Swarm::Settings& settings, Rng& rng)
      : space_{space}, settings_{settings}, rng_{rng} {}

  /// Algorithm 1: anywhere in F, with any step up to v_ini.
  void place(Swarm::Particle& particle) {
    const auto feasible = space_.feasible();
    particle.cell = feasible[rng_.index(feasible.size())];
    particle.position = space_.velocity(particle.cell);
    particle.step = any_step(settings_.start);
  }

  /// Eqs. 9 and 10, and back into F from where it is not feasible.
  void move(Swarm::Particle& particle, const PolarVelocity& common_best) {
    const double r1 = settings_.personal * rng_.uniform(0.0, 1.0);
    const double r2 = settings_.common * rng_.uniform(0.0, 1.0);
    PolarVelocity& p = particle.position;
    PolarStep& v = particle.step;
    const bool rests = std::abs(v.speed) < rest && std::abs(v.heading) < rest;

    v.speed = settings_.inertia * v.speed + r1 * (particle.best.speed - p.speed) +
              r2 * (common_best.speed - p.speed);
    v.heading = settings_.inertia * v.heading + r1 * wrapped(particle.best.heading - p.heading) +
                r2 * wrapped(common_best.heading - p.heading);
    if (rests) {
      const PolarStep shake = any_step(settings_.shake);
      v.speed += shake.speed;
      v.heading += shake.heading;
    }

    p.speed += v.speed;
    p.heading = wrapped(p.heading + v.heading);
    particle.cell = p.speed >= 0.0 && !space_.kinematics().contains(p) ? space_.grid().cell_at(p.cartesian())
                                                                       : VelocityGrid::outside;
    if (particle.cell == VelocityGrid::outside || !space_.is_feasible(particle.cell)) place(particle);
  }

 private:
  PolarStep any_step(const PolarStep& largest) {
    const double speed = largest.speed * rng_.uniform(-1.0, 1.0);
    return {speed, largest.heading * rng_.uniform(-1.0, 1.0)};
  }

  const VelocitySpace& space_;
  const Swarm::Settings& settings_;
  Rng& rng_;
};

}  // namespace

Candidate Swarm::search(const VelocitySpace& space, const VelocityMetric& metric, const Candidate& first,
                        const Settings& settings, Rng& rng) {
  Moves moves{space, settings, rng};
  Candidate best = first;
  particles_.clear();
  particles_.reserve(static_cast<std::size_t>(settings.particles));  // whether or not they are needed now
  if (best.cost <= settings.accepted_cost || space.feasible().empty()) return best;

  particles_.resize(static_cast<std::size_t>(settings.particles));
  for (Particle& particle : particles_) {
    moves.place(particle);
    particle.best_cost = std::numeric_limits<double>::infinity();
  }

  for (int i = 0; i < settings.iterations && best.cost > settings.accepted_cost; ++i) {
    // personal and common best
    for (Particle& particle : particles_) {
      const PolarVelocity& p = particle.position;
      const double cost = metric(p, space.danger(particle.cell));
      if (cost < particle.best_cost) {
        particle.best = p;
        particle.best_cost = cost;
      }
      if (cost < best.cost) best = {p, cost};
    }

    for (Particle& particle : particles_) moves.move(particle, best.velocity);
  }
  return best;
}

}  // namespace fairway::avoa
