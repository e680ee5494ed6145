// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <nlohmann/json.hpp>

#include "bindings/python/bindings.hpp"
#include "bindings/python/in_parallel.hpp"
#include "bindings/python/measures.hpp"
#include "bindings/python/parameters.hpp"
#include "bindings/python/scenarios.hpp"
#include "bindings/python/values.hpp"
#include "fairway/experiment/store.hpp"
#include "fairway/studies/study.hpp"

namespace fairway::python {
namespace {

py::object shown(const nlohmann::json& json) {
  switch (json.type()) {
    case nlohmann::json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case nlohmann::json::value_t::number_integer:
    case nlohmann::json::value_t::number_unsigned:
      return py::int_(json.get<std::int64_t>());
    case nlohmann::json::value_t::number_float:
      return py::float_(json.get<double>());
    case nlohmann::json::value_t::string:
      return py::str(json.get<std::string>());
    case nlohmann::json::value_t::array: {
      py::list all;
      for (const nlohmann::json& item : json) all.append(shown(item));
      return all;
    }
    case nlohmann::json::value_t::object: {
      py::dict all;
      for (const auto& [key, item] : json.items()) all[py::str(key)] = shown(item);
      return all;
    }
    default:
      return py::none();
  }
}

py::object study_rows(const std::string& name, int seeds, unsigned jobs, const py::object& overrides,
                      const py::object& store) {
  const Study& study = find_study(name);
  if (seeds < 0) throw InputError("seeds: expected 0 or more, got " + std::to_string(seeds));
  std::optional<Store> kept;
  if (!store.is_none()) kept = Store::open(path_of(store));
  std::atomic<bool> stop{false};
  const StudyOptions options{.jobs = jobs,
                             .seeds = seeds,
                             .store = kept ? &*kept : nullptr,
                             .stop = &stop,
                             .overrides = overrides_of(overrides)};
  // one thread that makes its own, so that this one can look for Ctrl-C
  StudyResult result;
  in_parallel(1, 1, stop, [&](std::size_t) { result = study.run(options); });
  return shown(rows_json(study.name, result.rows).at("rows"));
}

/// `fairway.Results`.
struct Results {
  py::dict labels;
  py::array seeds;
  MeasureColumns columns;
  py::dict failures;
  std::vector<std::string> keys;
  std::vector<std::string> commands;
  py::array wall_s;
};

Results load_results(const std::string& file) {
  const std::vector<RunRecord> records = Store::open_existing(file).all();
  Results results;
  std::vector<std::uint64_t> seeds;
  std::vector<double> wall;
  std::vector<std::vector<Measure>> measures;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const RunRecord& record = records[i];
    seeds.push_back(record.spec.seed);
    wall.push_back(record.wall_s);
    measures.push_back(record.measures);
    results.keys.push_back(record.spec.key);
    results.commands.push_back(command_of(record.spec));
    if (!record.failure.empty()) results.failures[py::int_(i)] = record.failure;
    for (const auto& [label, value] : record.spec.labels) {
      const py::str name{label};
      if (!results.labels.contains(name))
        results.labels[name] = py::list(py::make_tuple("")) * py::int_(records.size());
      results.labels[name][py::int_(i)] = value;
    }
  }
  const auto count = static_cast<py::ssize_t>(records.size());
  results.columns = measure_columns(measures);
  results.seeds = owned_array(std::move(seeds), {count});
  results.wall_s = owned_array(std::move(wall), {count});
  return results;
}

void bind_results(py::module_& m) {
  using R = Results;
  py::class_<R>(m, "Results", "The runs of a results store, as columns: by labels, seed and key.")
      .def_readonly("labels", &R::labels,
                    "{'case': [...], 'method': [...], ...}, of each run; '' where it has none")
      .def_readonly("seeds", &R::seeds, "of each run")
      .def_property_readonly(
          "fleet", [](const R& r) { return r.columns.fleet; },
          "{quantity: array of runs}; units are in the names")
      .def_property_readonly(
          "vehicles", [](const R& r) { return r.columns.vehicles; },
          "{quantity: array of runs x vehicles}; NaN where there is none")
      .def_readonly("failures", &R::failures, "{index of the run: why there are no measures}")
      .def_readonly("keys", &R::keys, "of each run: a digest of all that decides its outcome")
      .def_readonly("commands", &R::commands, "that make each run alone; '' if not known")
      .def_readonly("wall_s", &R::wall_s, "how long each took where it was made [s]")
      .def("__len__", [](const R& r) { return r.keys.size(); })
      .def("__repr__", [](const R& r) { return "<Results of " + std::to_string(r.keys.size()) + " runs>"; });
  m.def(
      "load_results", [](const py::object& file) { return load_results(path_of(file)); }, py::arg("file"),
      "Reads a results store, as `fairway sweep --out` and `fairway study --out` write it. Raises "
      "InputError.");
}

}  // namespace

void bind_studies(py::module_& m) {
  bind_results(m);
  m.def(
      "studies",
      [] {
        py::list all;
        for (const Study& study : builtin_studies()) {
          py::dict entry;
          entry["name"] = study.name;
          entry["title"] = study.title;
          entry["source"] = study.source;
          all.append(entry);
        }
        return all;
      },
      "Every published experiment that comes with fairway: a dict of name, title and source for each.");
  m.def(
      "study",
      [](const std::string& name, int seeds, int jobs, const py::object& overrides, const py::object& store) {
        return study_rows(name, seeds, jobs_of(jobs), overrides, store);
      },
      py::arg("name"), py::arg("seeds") = 0, py::arg("jobs") = 0, py::arg("overrides") = py::none(),
      py::arg("store") = py::none(),
      "Reproduces a published experiment, on `jobs` threads (0: all cores), with this many variations per "
      "cell beyond "
      "what was published. The rows of `fairway study --json`: a list of dicts with case, method, mode, "
      "quantity, "
      "published, measured, low, high, runs, deviation_ratio, verdict and note. store: a results store to "
      "continue. "
      "Ctrl-C ends it.");
}

}  // namespace fairway::python
