// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "bindings/python/bindings.hpp"
#include "bindings/python/in_parallel.hpp"
#include "bindings/python/json.hpp"
#include "bindings/python/parameters.hpp"
#include "bindings/python/scenarios.hpp"
#include "bindings/python/values.hpp"
#include "fairway/experiment/store.hpp"
#include "fairway/studies/study.hpp"

namespace fairway::python {
namespace {

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

}  // namespace

void bind_studies(py::module_& m) {
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
      "cell beyond what was published. The rows of `fairway study --json`: a list of dicts with case, "
      "method, mode, quantity, published, measured, low, high, runs, deviation_ratio, verdict and note. "
      "store: a results store to continue. Ctrl-C ends it.");
}

}  // namespace fairway::python
