// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/user_constructor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fairway::python {
namespace {

namespace py = pybind11;

std::string said(const py::handle& object) { return py::str(object); }

/// What a scenario would have to write for this default; false where it cannot.
bool describe_default(const py::object& value, ParamInfo& info) {
  if (py::isinstance<py::bool_>(value)) {
    info.type = "boolean";
    info.value = py::cast<bool>(value);
  } else if (py::isinstance<py::int_>(value)) {
    info.type = "integer";
    info.value = py::cast<double>(value);
  } else if (py::isinstance<py::float_>(value)) {
    info.type = "number";
    info.value = py::cast<double>(value);
  } else if (py::isinstance<py::str>(value)) {
    info.type = "text";
    info.value = py::cast<std::string>(value);
  } else {
    return false;
  }
  return true;
}

/// As Python writes it: a whole number where the default is one.
py::object python_value(const ParamInfo& info, const ParamValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return py::bool_(*flag);
  if (const std::string* text = std::get_if<std::string>(&value)) return py::str(*text);
  const double number = std::get<double>(value);
  if (info.type == "integer" && number == std::floor(number))
    return py::int_(static_cast<std::int64_t>(number));
  return py::float_(number);
}

/// Refuses what is plainly of another kind than the default.
void check_kind(const ParamInfo& info, const ParamValue& value) {
  const bool is_number = std::holds_alternative<double>(value);
  const bool fits =
      info.type.empty() || (info.type == "boolean" && std::holds_alternative<bool>(value)) ||
      (info.type == "text" && std::holds_alternative<std::string>(value)) ||
      (info.type == "number" && is_number) ||
      (info.type == "integer" && is_number && std::get<double>(value) == std::floor(std::get<double>(value)));
  if (!fits)
    throw InputError(
        {}, info.name,
        "expected " + std::string(info.type == "integer" ? "an " : "a ") + info.type + ", as its default is");
}

}  // namespace

UserConstructor::UserConstructor(std::string name, py::object callable)
    : name_{std::move(name)}, callable_{std::move(callable)} {
  if (PyCallable_Check(callable_.ptr()) == 0) {
    throw InputError("the algorithm \"" + name_ +
                     "\" is to be a class, or a function that makes its objects; it is " +
                     said(py::repr(callable_)));
  }
  if (PyType_Check(callable_.ptr()) != 0 && !py::hasattr(callable_, "decide"))
    throw InputError("the algorithm \"" + name_ + "\" has no decide(self, situation)");
  read_signature();
}

void UserConstructor::read_signature() {
  const py::module_ inspect = py::module_::import("inspect");
  const py::object parameter = inspect.attr("Parameter");
  py::object signature;
  try {
    signature = inspect.attr("signature")(callable_);
  } catch (const py::error_already_set&) {  // of a class written in C: it takes none
    return;
  }
  for (const py::handle value : signature.attr("parameters").attr("values")()) {
    const py::object kind = value.attr("kind");
    if (!kind.is(parameter.attr("POSITIONAL_OR_KEYWORD")) && !kind.is(parameter.attr("KEYWORD_ONLY")))
      continue;
    ParamInfo info;
    info.name = said(value.attr("name"));
    if (info.name == "seed") {
      takes_seed_ = true;
      continue;
    }
    info.meaning = "of " + name_;
    const py::object usual = value.attr("default");
    if (usual.is(parameter.attr("empty"))) {
      required_.push_back(info.name);
    } else if (!describe_default(usual, info)) {
      info.value = said(py::repr(usual));
    }
    params_.push_back(std::move(info));
  }
}

py::object UserConstructor::operator()(const ParamValues& values, Rng rng) const {
  py::dict keywords;
  for (const ParamInfo& info : params_) {
    const auto given = std::ranges::find(values, info.name, [](const auto& value) { return value.first; });
    if (given != values.end()) {
      check_kind(info, given->second);
      keywords[py::str(info.name)] = python_value(info, given->second);
    } else if (std::ranges::find(required_, info.name) != required_.end()) {
      throw InputError("the algorithm \"" + name_ + "\" needs a value of \"" + info.name +
                       "\", which has no default");
    }
  }
  if (takes_seed_) keywords["seed"] = py::int_(rng.stream("python").next());
  py::object made = callable_(**keywords);
  if (!py::hasattr(made, "decide")) {
    PyErr_SetString(PyExc_TypeError,
                    ("the algorithm \"" + name_ + "\" made a " +
                     said(py::type::handle_of(made).attr("__name__")) + " without decide(situation)")
                        .c_str());
    throw py::error_already_set();
  }
  if (py::hasattr(made, "reset")) made.attr("reset")();
  return made;
}

std::vector<std::pair<std::string, py::object>> named_algorithms(const py::object& algorithms) {
  if (!py::isinstance<py::dict>(algorithms)) {
    throw InputError("algorithms: expected a dict of names and classes, such as {\"mine\": Mine}; got " +
                     said(py::repr(algorithms)));
  }
  std::vector<std::pair<std::string, py::object>> named;
  for (const auto& [key, value] : py::cast<py::dict>(algorithms)) {
    if (!py::isinstance<py::str>(key))
      throw InputError("algorithms: expected names, got " + said(py::repr(key)));
    std::string name = py::cast<std::string>(key);
    if (name.empty() || name.find('+') != std::string::npos)
      throw InputError("algorithms: \"" + name + "\" is no name: it has a '+' or is empty");
    named.emplace_back(std::move(name), py::reinterpret_borrow<py::object>(value));
  }
  return named;
}

std::string first_line(const py::error_already_set& error) {
  try {
    const std::string message = said(error.value());
    return said(error.type().attr("__name__")) + ": " + message.substr(0, message.find('\n'));
  } catch (const py::error_already_set&) {  // even its text fails
    return "an exception without words";
  }
}

}  // namespace fairway::python
