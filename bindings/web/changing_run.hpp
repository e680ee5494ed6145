// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::web {

/// From this tick on a run is that of this scenario.
struct Stretch {
  Tick from{};
  Scenario scenario;
};

/// A run that is changed on its way (Simulation::change).
class ChangingRun {
 public:
  /// `stretches`, of which there is one at least and the first begins the run, ascend and outlive this.
  /// Throws InputError for what cannot be simulated.
  ChangingRun(const std::vector<Stretch>& stretches, const Catalogs& catalogs)
      : stretches_{&stretches}, catalogs_{&catalogs}, simulation_{stretches.front().scenario, catalogs} {}

  /// Throws InputError where what follows cannot follow.
  void step(std::span<FrameSink* const> sinks) {
    for (; next_ < stretches_->size() && (*stretches_)[next_].from <= simulation_.tick(); ++next_)
      simulation_.change((*stretches_)[next_ - 1].scenario, (*stretches_)[next_].scenario, *catalogs_);
    simulation_.step(sinks);
  }

  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }

 private:
  const std::vector<Stretch>* stretches_;
  const Catalogs* catalogs_;
  Simulation simulation_;
  std::size_t next_{1};
};

}  // namespace fairway::web
