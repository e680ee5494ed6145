// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <chrono>
#include <memory>

#include "bindings/python/batch.hpp"
#include "bindings/python/bindings.hpp"
#include "bindings/python/measures.hpp"
#include "bindings/python/scenarios.hpp"
#include "bindings/python/trajectories.hpp"
#include "bindings/python/user_algorithms.hpp"
#include "bindings/python/values.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/record/recording_writer.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::python {
namespace {

using Clock = std::chrono::steady_clock;

/// `fairway.Run`.
struct Run {
  std::string scenario;
  std::uint64_t seed{};
  double simulated_s{};
  double wall_s{};
  py::dict fleet = py::dict();
  py::list vehicles = py::list();
  py::dict notes = py::dict();
  py::object trajectories = py::none();
};

/// Ends the run on Ctrl-C, and looks for it twenty times a second.
class Interrupts final : public FrameSink {
 public:
  void write(const Frame&) override {
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds{50};
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

 private:
  Clock::time_point next_ = Clock::now();
};

struct RunChoice {
  std::string record;  ///< nowhere if empty
  bool trajectories{};
  bool perception{};
  bool sketches{};
  bool is_own{};  ///< there are algorithms in Python
};

/// What `fairway run` does. Gives back the vehicles' notes by name.
std::vector<std::pair<std::string, std::string>> simulate(const Scenario& scenario, const Catalogs& catalogs,
                                                          const RunChoice& choice,
                                                          std::vector<FrameSink*> sinks, Run& run) {
  Simulation simulation{scenario, catalogs};
  std::unique_ptr<RecordingWriter> writer;
  if (!choice.record.empty()) {
    RecordingInfo info = recording_info(scenario);
    info.perception = choice.perception;
    info.sketches = choice.sketches;
    if (choice.is_own) info.program = python_program;
    simulation.show_thoughts(choice.sketches);
    writer = std::make_unique<RecordingWriter>(choice.record, std::move(info));
    sinks.push_back(writer.get());
  }
  const Clock::time_point begin = Clock::now();
  try {
    simulation.run(sinks);
  } catch (const RunDiverged& broke) {
    if (writer) writer->close({.divergence = broke.what()});
    throw;
  }
  if (writer) writer->close();
  run.wall_s = std::chrono::duration<double>(Clock::now() - begin).count();
  run.simulated_s = simulation.time();
  std::vector<std::pair<std::string, std::string>> notes;
  for (const Agent& agent : simulation.agents()) {
    if (!agent.note.empty()) notes.emplace_back(agent.ship().name, std::string(agent.note));
  }
  return notes;
}

Run run_one(const Scenario& scenario, const py::object& algorithms, const RunChoice& choice) {
  Run run{.scenario = scenario.name, .seed = scenario.seed};
  RunMetrics metrics = metrics_for(scenario);
  Interrupts interrupts;
  TrajectoryColumns columns;
  std::vector<FrameSink*> sinks{&metrics, &interrupts};
  if (choice.trajectories) sinks.push_back(&columns);
  std::vector<std::pair<std::string, std::string>> notes;
  with_algorithms(algorithms, [&](const Catalogs& catalogs, FrameSink& guard) {
    sinks.push_back(&guard);
    notes = simulate(scenario, catalogs, choice, sinks, run);
  });
  for (const auto& [vehicle, note] : notes) run.notes[py::str(vehicle)] = note;

  std::vector<std::string> names;
  for (const VehicleSpec& vehicle : scenario.vehicles) names.push_back(vehicle.name);
  const std::vector<Measure> measures = metrics.measures();
  run.fleet = fleet_dict(measures);
  run.vehicles = vehicle_dicts(measures, names);
  if (choice.trajectories) run.trajectories = columns.take();
  return run;
}

}  // namespace

void bind_runs(py::module_& m) {
  using R = Run;
  py::class_<R>(m, "Run", "What one run came to; the numbers are those of `fairway run --json`, to the bit.")
      .def_readonly("scenario", &R::scenario, "its name")
      .def_readonly("seed", &R::seed, "of the scenario")
      .def_readonly("simulated_s", &R::simulated_s, "[s]")
      .def_readonly("wall_s", &R::wall_s, "how long it took on this machine [s]")
      .def_readonly("fleet", &R::fleet, "{quantity: number} of the whole fleet; units are in the names")
      .def_readonly("vehicles", &R::vehicles, "a dict for each: name, and {quantity: number}")
      .def_readonly("notes", &R::notes, "{vehicle: what its avoider said last}, where one said anything")
      .def_readonly("trajectories", &R::trajectories, "Trajectories, or None unless asked for")
      .def("__repr__",
           [](const R& run) { return "<Run " + run.scenario + ", seed " + std::to_string(run.seed) + ">"; });
  m.def(
      "run",
      [](const py::object& scenario, const py::object& algorithms, const py::object& record,
         bool trajectories, bool perception, bool sketches) {
        const RunChoice choice{.record = record.is_none() ? "" : path_of(record),
                               .trajectories = trajectories,
                               .perception = perception,
                               .sketches = sketches,
                               .is_own = !algorithms.is_none()};
        if (!record.is_none() && choice.record.empty())
          throw InputError("record: is empty; expected an MCAP file to write");
        if ((perception || sketches) && choice.record.empty())
          throw InputError("run: perception and sketches say what is recorded; record is missing");
        const ScenarioText text = scenario_of(scenario);
        check_outputs(std::array{Output{"record", choice.record, recording_file}}, std::array{text.file()},
                      false);
        return run_one(text.scenario(), algorithms, choice);
      },
      py::arg("scenario"), py::arg("algorithms") = py::none(), py::arg("record") = py::none(),
      py::arg("trajectories") = false, py::arg("perception") = false, py::arg("sketches") = false,
      "Runs a Scenario, or that of a file. algorithms: {name: class} written in Python. record: an MCAP file "
      "to write, with what vehicles perceived and what methods draw if asked. trajectories: keep what moved, "
      "as arrays. The interpreter's lock is released; Ctrl-C ends it. Raises InputError, RunDiverged, when "
      "what was recorded ends before the run broke, and whatever an algorithm in Python raises.");
  bind_batch(m);
}

}  // namespace fairway::python
