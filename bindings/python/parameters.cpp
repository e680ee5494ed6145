// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/parameters.hpp"

#include "bindings/python/values.hpp"

namespace fairway::python {

void bind_parameter(py::module_& m) {
  using P = ParamInfo;
  py::class_<P>(m, "Parameter", "A parameter of an algorithm or a vehicle: its name ends in its unit.")
      .def_readonly("name", &P::name, "as written in a scenario, and as a keyword")
      .def_readonly("unit", &P::unit, "'s', 'mps' ...; '' for switches and choices")
      .def_readonly("type", &P::type, "'number', 'integer', 'boolean', 'choice' or 'list'")
      .def_property_readonly(
          "low", [](const P& p) { return p.range.lo; }, "the least that is accepted")
      .def_property_readonly(
          "high", [](const P& p) { return p.range.hi; }, "the most that is accepted")
      .def_readonly("meaning", &P::meaning, "what it does")
      .def_property_readonly(
          "default", [](const P& p) { return shown(p.value); }, "of a list its length")
      .def_property_readonly(
          "choices", [](const P& p) { return py::tuple(py::cast(p.choices)); }, "of a choice")
      .def_property_readonly(
          "items", [](const P& p) { return parameters(p.items); }, "of a list: what each has")
      .def("__repr__", [](const P& p) {
        return "<Parameter " + p.name + " = " + py::str(shown(p.value)).cast<std::string>() + ": " +
               p.meaning + ">";
      });
}

py::tuple parameters(const std::vector<ParamInfo>& params) {
  py::tuple all{params.size()};
  for (std::size_t i = 0; i < params.size(); ++i) all[i] = py::cast(params[i]);
  return all;
}

unsigned jobs_of(int given) {
  if (given < 0) throw InputError("jobs: expected 0 (all cores) or more, got " + std::to_string(given));
  return static_cast<unsigned>(given);
}

}  // namespace fairway::python
