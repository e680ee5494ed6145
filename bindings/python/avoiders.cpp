// SPDX-License-Identifier: Apache-2.0

#include "bindings/python/bindings.hpp"
#include "bindings/python/decide_batch.hpp"
#include "bindings/python/parameters.hpp"
#include "bindings/python/situations.hpp"
#include "bindings/python/values.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway::python {
namespace {

/// `fairway.Avoider`. Nothing here releases the interpreter's lock while it decides, so that two threads of
/// Python may share one.
struct NamedAvoider {
  std::string name;
  Avoider avoider;
  SituationRoom room;  ///< of decide()
};

/// `fairway.AlgorithmInfo`.
struct Algorithm {
  std::string name, title, source;
  bool planar{};
  bool wraps{};
  std::vector<ParamInfo> params;
};

const Catalog& offered_avoiders() {
  static const Catalog catalog = builtin_catalogs().avoiders;
  return catalog;
}

Algorithm algorithm_named(const std::string& name) {
  const Catalog& catalog = offered_avoiders();
  const AlgorithmInfo info = catalog.find(name.substr(0, name.find('+'))).info;
  const bool alone = name.find('+') == std::string::npos;
  Algorithm algorithm{.name = name,
                      .title = std::string(info.title),
                      .source = std::string(info.source),
                      .planar = info.planar,
                      .wraps = alone && catalog.find(name).wraps,
                      .params = catalog.params(name)};
  return algorithm;
}

void bind_algorithms(py::module_& m) {
  using A = Algorithm;
  py::class_<A>(m, "AlgorithmInfo", "What there is to say of an algorithm.")
      .def_readonly("name", &A::name, "as written in a scenario, and for Avoider")
      .def_readonly("title", &A::title, "in full")
      .def_readonly("source", &A::source, "the paper and the equations implemented")
      .def_readonly("planar", &A::planar, "thinks in the horizontal plane")
      .def_readonly("wraps", &A::wraps, "stands around another: 'orca3d+stop_and_wait'")
      .def_property_readonly(
          "parameters", [](const A& a) { return parameters(a.params); }, "of Parameter")
      .def("__repr__", [](const A& a) { return "<AlgorithmInfo " + a.name + ": " + a.title + ">"; });
  m.def(
      "algorithms",
      [] {
        py::list all;
        for (const Catalog::Entry& entry : offered_avoiders().entries())
          all.append(algorithm_named(std::string(entry.info.name)));
        return all;
      },
      "Every algorithm that comes with fairway, as a list of AlgorithmInfo.");
  m.def("algorithm", &algorithm_named, py::arg("name"),
        "One of them, or a wrapper around one, 'orca3d+stop_and_wait', with the parameters of both. Raises "
        "InputError with the nearest name.");
}

}  // namespace

void bind_avoiders(py::module_& m) {
  bind_parameter(m);
  bind_algorithms(m);
  using N = NamedAvoider;
  py::class_<N> avoider{m, "Avoider",
                        "Any algorithm with its memory and its randomness. copy.copy is a snapshot: two "
                        "equal avoiders shown the same situations give the same commands for ever."};
  avoider
      .def(py::init([](const std::string& name, const py::object& seed, const py::kwargs& params) {
             return N{name,
                      offered_avoiders().make(name, param_values(params),
                                              Rng{Read<std::uint64_t>::from(seed, "seed")}),
                      {}};
           }),
           py::arg("name"), py::arg("seed") = 0,
           "name as algorithms() has it; seed of all that is random; parameters of the algorithm by keyword. "
           "Raises InputError with the nearest name.")
      .def_readonly("name", &N::name, "as it was made")
      .def(
          "decide",
          [](N& self, const OwnedSituation& situation) {
            return self.avoider.decide(situation.view(self.room));
          },
          py::arg("situation"),
          "The Command, held to the situation's limits. A situation with NaN or without a period is answered "
          "with zero velocity and Mode.infeasible. Remembers.")
      .def("__copy__", [](const N& self) { return N{self}; })
      .def("__deepcopy__", [](const N& self, const py::object&) { return N{self}; })
      .def("__repr__", [](const N& self) { return "<Avoider " + self.name + ">"; });
  add_decide_batch(m, avoider, [](const py::handle& self) { return self.cast<const N&>().avoider; });
}

}  // namespace fairway::python
