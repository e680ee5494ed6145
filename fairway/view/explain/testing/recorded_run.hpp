// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/record/recording_writer.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::testing {

/// A file of scenarios/, with overrides.
inline Scenario scenario_of(const std::string& name, const Overrides& overrides = {}) {
  return load_scenario(std::string(FAIRWAY_SOURCE_DIR) + "/scenarios/" + name + ".yaml", overrides);
}

/// Changes the vehicles of a frame before they are recorded.
using Forgery = std::function<void(const Frame&, std::vector<VehicleFrame>&)>;

/// Passes frames on, forged.
class Forger final : public FrameSink {
 public:
  Forger(FrameSink& sink, Forgery forgery) : sink_{sink}, forgery_{std::move(forgery)} {}
  void write(const Frame& frame) override {
    vehicles_.assign(frame.vehicles.begin(), frame.vehicles.end());
    if (forgery_) forgery_(frame, vehicles_);
    Frame forged = frame;
    forged.vehicles = vehicles_;
    sink_.write(forged);
  }

 private:
  FrameSink& sink_;
  Forgery forgery_;
  std::vector<VehicleFrame> vehicles_;
};

/// The recording of a scenario, of every `stride`-th frame.
inline Recording recorded(const Scenario& scenario, std::int64_t stride = 1, const Forgery& forgery = {}) {
  const TemporaryFolder folder;
  RecordingWriter writer{folder.file("run.mcap"), recording_info(scenario), stride};
  Forger forger{writer, forgery};
  const std::array<FrameSink*, 1> sinks{&forger};
  Simulation{scenario, builtin_catalogs()}.run(sinks);
  writer.close();
  return Recording::read(folder.file("run.mcap"));
}

}  // namespace fairway::testing
