// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bindings/python/bindings.hpp"
#include "bindings/python/in_parallel.hpp"
#include "bindings/python/json.hpp"
#include "bindings/python/parameters.hpp"
#include "bindings/python/results.hpp"
#include "bindings/python/scenarios.hpp"
#include "bindings/python/user_algorithms.hpp"
#include "bindings/python/user_constructor.hpp"
#include "fairway/experiment/campaign.hpp"
#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::python {
namespace {

/// The algorithms in Python of a campaign. What is asked of it may be asked by several threads, without the
/// interpreter's lock.
class OwnAlgorithms {
 public:
  /// With the lock. Their versions are found where runs are kept. Throws InputError for one without.
  OwnAlgorithms(py::object algorithms, bool kept) : algorithms_{std::move(algorithms)} {
    if (algorithms_.is_none()) return;
    const py::object version_of = py::module_::import("fairway._version").attr("version_of");
    for (const auto& [name, algorithm] : named_algorithms(algorithms_))
      versions_[name] = kept ? py::cast<std::string>(version_of(name, algorithm)) : "not kept";
  }

  /// The version of those in a scenario, as OwnMethods has it.
  std::string version(const Scenario& scenario) const {
    std::map<std::string_view, std::string_view> used;
    for (const VehicleSpec& vehicle : scenario.vehicles) {
      for (const std::string_view layer : layer_names(vehicle.avoider->name)) {
        if (const auto own = versions_.find(layer); own != versions_.end()) used[own->first] = own->second;
      }
    }
    std::string all;
    for (const auto& [name, version] : used) {
      all += name;
      all += " in Python, " + std::string(version) + "\n";
    }
    return all;
  }

  /// Calls `work` with all algorithms that the scenario may name. Those without one in Python go on beside
  /// each other: they do not wait for the interpreter.
  template <class Work>
  void with_catalogs(const Scenario& scenario, Work&& work) const {
    if (algorithms_.is_none() || (version(scenario).empty() && is_known(scenario))) {
      work(builtin(), std::span<FrameSink* const>{});
      return;
    }
    with_algorithms(algorithms_, [&](const Catalogs& catalogs, FrameSink& guard) {
      const std::array<FrameSink*, 1> guards{&guard};
      work(catalogs, std::span<FrameSink* const>{guards});
    });
  }

 private:
  static const Catalogs& builtin() {
    static const Catalogs catalogs = builtin_catalogs();
    return catalogs;
  }

  /// Otherwise the catalogs with all algorithms are asked, so that a slip finds its nearest name among them.
  static bool is_known(const Scenario& scenario) {
    return std::ranges::all_of(scenario.vehicles, [](const VehicleSpec& vehicle) {
      return std::ranges::all_of(layer_names(vehicle.avoider->name),
                                 [](std::string_view layer) { return builtin().avoiders.has(layer); });
    });
  }

  py::object algorithms_;
  std::map<std::string, std::string, std::less<>> versions_;
};

/// A run's measures; what an algorithm raised comes as a std::runtime_error of one line, for the store.
std::vector<Measure> measured(const OwnAlgorithms& own, const Scenario& scenario,
                              const std::atomic<bool>& stop) {
  std::vector<Measure> measures;
  try {
    own.with_catalogs(scenario, [&](const Catalogs& catalogs, std::span<FrameSink* const> guards) {
      measures = measure_run(scenario, catalogs, &stop, guards);
    });
  } catch (const py::error_already_set& error) {
    const py::gil_scoped_acquire locked;
    throw std::runtime_error(first_line(error));
  }
  return measures;
}

struct SweepChoice {
  std::string campaign;
  std::string out;  ///< kept nowhere if empty
  unsigned jobs{};
  bool retry_failures{};
};

/// None keeps nothing; a text that is empty is a slip.
std::string out_of(const py::object& out) {
  if (out.is_none()) return "";
  std::string path = path_of(out);
  if (path.empty()) throw InputError("out: expected the path of a results store, or None; got ''");
  return path;
}

Results sweep(const SweepChoice& choice, const py::object& algorithms) {
  const OwnAlgorithms own{algorithms, !choice.out.empty()};
  std::atomic<bool> stop{false};
  const CheckScenario check = [&](const Scenario& scenario) {
    own.with_catalogs(scenario, [&](const Catalogs& catalogs, std::span<FrameSink* const>) {
      Simulation{scenario, catalogs};
    });
  };
  StoredResults results;
  std::size_t made = 0;
  // one thread that makes its own, so that this one can look for Ctrl-C
  in_parallel(1, 1, stop, [&](std::size_t) {
    const OwnMethods methods{[&own](const Scenario& scenario) { return own.version(scenario); }, ""};
    const Campaign campaign = load_campaign(choice.campaign, check, choice.jobs, methods);
    Store store = choice.out.empty() ? Store::in_memory() : Store::open(choice.out);
    Progress progress{campaign.name};
    const ExecutorReport report = run_campaign(
        campaign, [&](const Scenario& scenario) { return measured(own, scenario, stop); }, store,
        {.jobs = choice.jobs, .progress = &progress, .stop = &stop, .retry_failures = choice.retry_failures});
    made = report.made;
    results = {origin_of(campaign), records_of(campaign, store)};
    results.origin.epoch = std::to_string(results_epoch);
  });
  return results_of(std::move(results), made);
}

/// `place` of a list, for errors about what has no name of its own.
void add_results(const py::handle& given, std::size_t place, GatheredResults& results) {
  if (py::isinstance<Results>(given)) {
    const StoredResults& more = given.cast<const Results&>().stored;
    results.add("results[" + std::to_string(place) + "]", more.origin, more.records);
  } else {
    results.add_store(path_of(py::reinterpret_borrow<py::object>(given)));
  }
}

StoredResults results_of_all(const py::object& given, bool mixed) {
  GatheredResults results{mixed ? Together::compared_mixed : Together::compared};
  if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
    std::size_t place = 0;
    for (const py::handle item : given) add_results(item, place++, results);
  } else {
    add_results(given, 0, results);
  }
  return results.take();
}

constexpr const char* sweep_doc =
    R"(Makes the runs of a campaign file that the results store `out` does not have, on `jobs` threads (0: all cores), and
gives all runs of the campaign, as `fairway sweep` does and to the bit; without `out` nothing is kept. algorithms:
{name: class} written in Python, which the campaign names like any other. The results do not depend on jobs.

A run that fails does not end the others: Results.failures has why. A run is made again once an algorithm in Python
has changed: the key of a stored run has the algorithm's attribute `version`, or else a digest of all that the class is
made of. An algorithm that cannot be read so is refused, with `out`, until it has a `version`.

Ctrl-C ends it: what is done is stored, and the same call goes on from there. Progress is shown on a terminal. Raises
InputError.)";

constexpr const char* compare_doc =
    R"(Compares stored runs, paired by seed, with confidence intervals: the document of `fairway compare --json`. results:
Results, the path of a results store, or a list of these. by: the label whose values are compared. baseline: the
value that the others are compared with; the campaign's first without it. quantities: without it those of the campaign; ["all"] for all. A run that
several hold is taken once. mixed: results of several results epochs, or versions of a campaign, are taken together;
without it they are refused. Raises InputError.)";

}  // namespace

void bind_sweeps(py::module_& m) {
  m.def(
      "sweep",
      [](const py::object& campaign, const py::object& out, int jobs, const py::object& algorithms,
         bool retry_failures) {
        return sweep({.campaign = path_of(campaign),
                      .out = out_of(out),
                      .jobs = jobs_of(jobs),
                      .retry_failures = retry_failures},
                     algorithms);
      },
      py::arg("campaign"), py::arg("out") = py::none(), py::arg("jobs") = 0,
      py::arg("algorithms") = py::none(), py::arg("retry_failures") = false, sweep_doc);
  m.def(
      "compare",
      [](const py::object& results, const std::string& by, const py::object& baseline,
         const py::object& quantities, double confidence, bool mixed) {
        if (!(confidence >= 0.5 && confidence <= 0.9999))
          throw InputError("confidence: expected a number in [0.5, 0.9999], got " +
                           std::to_string(confidence));
        CompareOptions options;
        options.by = by;
        options.confidence = confidence;
        options.mixed = mixed;
        if (!baseline.is_none()) options.baseline = Read<std::string>::from(baseline, "baseline");
        if (!quantities.is_none())
          options.quantities = Read<std::vector<std::string>>::from(quantities, "quantities");
        const StoredResults all = results_of_all(results, mixed);
        return shown(to_json(compare(all.records, options_for(all.origin, options))));
      },
      py::arg("results"), py::arg("by") = "method", py::arg("baseline") = py::none(),
      py::arg("quantities") = py::none(), py::arg("confidence") = 0.95, py::arg("mixed") = false,
      compare_doc);
}

}  // namespace fairway::python
