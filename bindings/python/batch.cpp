// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/batch.hpp"

#include <array>
#include <chrono>
#include <utility>

#include "bindings/python/in_parallel.hpp"
#include "bindings/python/measures.hpp"
#include "bindings/python/parameters.hpp"
#include "bindings/python/scenarios.hpp"
#include "bindings/python/user_algorithms.hpp"
#include "bindings/python/values.hpp"
#include "fairway/experiment/executor.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/sim/divergence.hpp"

namespace fairway::python {
namespace {

/// `fairway.Batch`.
struct Batch {
  std::vector<std::string> names;  ///< of the scenarios
  py::array scenario;
  py::array seed;
  MeasureColumns columns;
  py::dict failures;
  double wall_s{};
};

/// One run of a batch and what became of it.
struct BatchRun {
  std::size_t scenario{};
  std::uint64_t seed{};
  std::vector<Measure> measures;
  std::string failure;  ///< in words
  bool diverged{};      ///< that is the failure
  py::object raised;    ///< by an algorithm in Python; touched with the interpreter's lock alone
};

/// The exception with its traceback. With the lock held.
py::object exception_of(const py::error_already_set& error) {
  py::object value = error.value();
  if (error.trace()) PyException_SetTraceback(value.ptr(), error.trace().ptr());
  return value;
}

/// Without the lock held. `algorithms` are objects of this run's own.
std::vector<Measure> measured(const ScenarioText& scenario, const py::object& algorithms,
                              const Catalogs& builtin, const std::atomic<bool>& stop, BatchRun& run) {
  if (algorithms.is_none()) return measure_run(scenario.drawn(run.seed), builtin, &stop);
  const py::gil_scoped_acquire locked;
  std::vector<Measure> measures;
  try {
    with_algorithms(algorithms, [&](const Catalogs& catalogs, FrameSink& guard) {
      std::array<FrameSink*, 1> guards{&guard};
      measures = measure_run(scenario.drawn(run.seed), catalogs, &stop, guards);
    });
  } catch (py::error_already_set& error) {
    run.raised = exception_of(error);
    throw std::runtime_error(error.what());
  }
  return measures;
}

/// Throws InputError for what no seed can mend: names that nobody has.
void check_names(const std::vector<ScenarioText>& scenarios, const Catalogs& catalogs) {
  for (const ScenarioText& text : scenarios) {
    for (const VehicleSpec& vehicle : text.scenario().vehicles) {
      catalogs.vehicles.find(vehicle.model->name);
      catalogs.avoiders.params(vehicle.avoider->name);
    }
  }
}

std::vector<ScenarioText> scenarios_of(const py::object& given) {
  if (!py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given)) return {scenario_of(given)};
  std::vector<ScenarioText> all;
  for (const py::handle item : given) all.push_back(scenario_of(py::reinterpret_borrow<py::object>(item)));
  if (all.empty()) throw InputError("scenario: expected at least one");
  return all;
}

std::vector<BatchRun> plan_of(const std::vector<ScenarioText>& scenarios, const py::object& seeds) {
  std::vector<BatchRun> runs;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    if (seeds.is_none()) {
      runs.push_back({.scenario = i, .seed = scenarios[i].scenario().seed});
    } else {
      for (const std::uint64_t seed : Read<std::vector<std::uint64_t>>::from(seeds, "seeds"))
        runs.push_back({.scenario = i, .seed = seed});
    }
  }
  return runs;
}

void make_all(const std::vector<ScenarioText>& scenarios, const py::object& algorithms, unsigned jobs,
              const py::object& progress, std::vector<BatchRun>& runs) {
  static const Catalogs builtin = builtin_catalogs();
  check_names(scenarios, algorithms.is_none() ? builtin : UserAlgorithms{algorithms}.catalogs());
  std::atomic<bool> stop{false};
  const auto make = [&](std::size_t i) {
    BatchRun& run = runs[i];
    try {
      run.measures = measured(scenarios[run.scenario], algorithms, builtin, stop, run);
    } catch (const RunAbandoned&) {  // only once everything stops
    } catch (const std::exception& error) {
      run.diverged = dynamic_cast<const RunDiverged*>(&error) != nullptr;
      run.failure = error.what();
    }
  };
  std::function<void(std::size_t)> tell;
  if (!progress.is_none()) tell = [&](std::size_t done) { progress(done, runs.size()); };
  in_parallel(runs.size(), jobs, stop, make, tell);
}

Batch batch_of(const std::vector<ScenarioText>& scenarios, std::vector<BatchRun> runs, double wall_s) {
  Batch batch{.wall_s = wall_s};
  for (const ScenarioText& text : scenarios) batch.names.push_back(text.scenario().name);
  const py::module_ core = py::module_::import("fairway._core");
  std::vector<std::int64_t> scenario;
  std::vector<std::uint64_t> seed;
  std::vector<std::vector<Measure>> measures;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    scenario.push_back(static_cast<std::int64_t>(runs[i].scenario));
    seed.push_back(runs[i].seed);
    measures.push_back(std::move(runs[i].measures));
    if (runs[i].failure.empty()) continue;
    const py::object kind = core.attr(runs[i].diverged ? "RunDiverged" : "InputError");
    batch.failures[py::int_(i)] = runs[i].raised ? runs[i].raised : kind(runs[i].failure);
  }
  const auto count = static_cast<py::ssize_t>(runs.size());
  batch.columns = measure_columns(measures);
  batch.scenario = owned_array(std::move(scenario), {count});
  batch.seed = owned_array(std::move(seed), {count});
  return batch;
}

constexpr const char* run_batch_doc =
    R"(Runs of one scenario, or of each of a list, for every one of seeds (without: for the scenario's own), on `jobs`
threads (0: all cores) without the interpreter's lock. The results do not depend on jobs, and are those of
`fairway run FILE --seed N` to the bit. algorithms: {name: class} written in Python, an object for each vehicle of
each run; they take turns for the interpreter. progress: called with (runs done, runs) some twenty times a second;
what it raises ends the batch. Ctrl-C ends it.

A run that fails does not end the others: its numbers are NaN and Batch.failures has why. A name that nobody has
raises InputError before anything runs.)";

}  // namespace

void bind_batch(py::module_& m) {
  using B = Batch;
  py::class_<B>(m, "Batch", "What many runs came to, as columns; scenario by scenario, seed by seed.")
      .def_readonly("scenario_names", &B::names, "of the scenarios")
      .def_readonly("scenarios", &B::scenario, "of each run: index of its scenario")
      .def_readonly("seeds", &B::seed, "of each run")
      .def_property_readonly(
          "fleet", [](const B& b) { return b.columns.fleet; },
          "{quantity: array of runs}; units are in the names, NaN where a run failed")
      .def_property_readonly(
          "vehicles", [](const B& b) { return b.columns.vehicles; },
          "{quantity: array of runs x vehicles}; NaN where there is none")
      .def_readonly("failures", &B::failures, "{index of the run: the exception that ended it}")
      .def_readonly("wall_s", &B::wall_s, "how long all of it took on this machine [s]")
      .def("__len__", [](const B& b) { return b.seed.shape(0); })
      .def("__repr__", [](const B& b) {
        return "<Batch: " + std::to_string(b.seed.shape(0)) + " runs, " + std::to_string(b.failures.size()) +
               " failed>";
      });
  m.def(
      "run_batch",
      [](const py::object& scenario, const py::object& seeds, int jobs, const py::object& algorithms,
         const py::object& progress) {
        const auto begin = std::chrono::steady_clock::now();
        const unsigned threads = jobs_of(jobs);
        const std::vector<ScenarioText> scenarios = scenarios_of(scenario);
        std::vector<BatchRun> runs = plan_of(scenarios, seeds);
        make_all(scenarios, algorithms, threads, progress, runs);
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
        return batch_of(scenarios, std::move(runs), wall.count());
      },
      py::arg("scenario"), py::arg("seeds") = py::none(), py::arg("jobs") = 0,
      py::arg("algorithms") = py::none(), py::arg("progress") = py::none(), run_batch_doc);
}

}  // namespace fairway::python
