// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/results.hpp"

#include <array>

#include "bindings/python/scenarios.hpp"

namespace fairway::python {
namespace {

template <class Of>
std::vector<std::string> listed(const Results& results, Of&& of) {
  std::vector<std::string> all;
  for (const RunRecord& record : results.stored.records) all.push_back(of(record));
  return all;
}

}  // namespace

Results results_of(StoredResults stored, std::size_t made) {
  Results results{.stored = std::move(stored), .made = made};
  std::vector<std::uint64_t> seeds;
  std::vector<double> wall;
  std::vector<std::vector<Measure>> measures;
  const std::size_t size = results.stored.records.size();
  for (std::size_t i = 0; i < size; ++i) {
    const RunRecord& record = results.stored.records[i];
    seeds.push_back(record.spec.seed);
    wall.push_back(record.wall_s);
    measures.push_back(record.measures);
    if (!record.failure.empty()) results.failures[py::int_(i)] = record.failure;
    for (const auto& [label, value] : record.spec.labels) {
      const py::str name{label};
      if (!results.labels.contains(name))
        results.labels[name] = py::list(py::make_tuple("")) * py::int_(size);
      results.labels[name][py::int_(i)] = value;
    }
  }
  const auto count = static_cast<py::ssize_t>(size);
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
      .def_property_readonly(
          "keys",
          [](const R& r) { return listed(r, [](const RunRecord& record) { return record.spec.key; }); },
          "of each run: a digest of all that decides its outcome")
      .def_property_readonly(
          "commands",
          [](const R& r) {
            return listed(r, [](const RunRecord& record) { return command_of(record.spec); });
          },
          "that make each run alone; '' if not known, as of algorithms in Python")
      .def_readonly("made", &R::made, "how many of them sweep() made; the others were stored before")
      .def_readonly("wall_s", &R::wall_s, "how long each took where it was made [s]")
      .def("__len__", [](const R& r) { return r.stored.records.size(); })
      .def("__repr__",
           [](const R& r) { return "<Results of " + std::to_string(r.stored.records.size()) + " runs>"; });
  m.def(
      "load_results",
      [](const py::object& file) { return results_of(read_stores(std::array{path_of(file)})); },
      py::arg("file"),
      "Reads a results store, as `fairway sweep --out` and `fairway study --out` write it. Raises "
      "InputError.");
}

}  // namespace fairway::python
