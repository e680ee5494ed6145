// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/values.hpp"

#include <algorithm>
#include <mutex>
#include <set>

#include "bindings/python/bindings.hpp"
#include "fairway/sim/divergence.hpp"

namespace fairway::python {
namespace {

std::string shape_text(const std::vector<py::ssize_t>& shape) {
  if (shape.empty()) return "a number";
  std::string text;
  for (const py::ssize_t size : shape) text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text + (shape == std::vector<py::ssize_t>{1} ? " number" : " numbers");
}

void add_params(const py::dict& given, const std::string& prefix, ParamValues& values);

void add_list_param(const std::string& name, const py::sequence& items, ParamValues& values) {
  values.emplace_back(name, static_cast<double>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string path = name + "[" + std::to_string(i) + "]";
    const py::object item = items[i];
    if (!py::isinstance<py::dict>(item)) refuse(path, "a dict of parameters", item);
    add_params(item, path + ".", values);
  }
}

void add_params(const py::dict& given, const std::string& prefix, ParamValues& values) {
  const py::object numpy_bool = py::module_::import("numpy").attr("bool_");
  for (const auto& [key, item] : given) {
    const std::string name = prefix + Read<std::string>::from(key, prefix + "parameter");
    if (py::isinstance<py::bool_>(item) || py::isinstance(item, numpy_bool)) {
      values.emplace_back(name, py::cast<bool>(item.attr("__bool__")()));
    } else if (py::isinstance<py::str>(item)) {
      values.emplace_back(name, py::cast<std::string>(item));
    } else if (prefix.empty() && (py::isinstance<py::list>(item) || py::isinstance<py::tuple>(item))) {
      add_list_param(name, py::reinterpret_borrow<py::sequence>(item), values);
    } else if (PyNumber_Check(item.ptr()) != 0) {
      values.emplace_back(name, Read<double>::from(item, name));
    } else {
      refuse(name,
             prefix.empty() ? "a number, True or False, text or a list of dicts"
                            : "a number, True or False, or text",
             item);
    }
  }
}

}  // namespace

void refuse(const std::string& path, std::string_view expected, py::handle got) {
  constexpr std::size_t most = 60;
  std::string text = py::repr(got).cast<std::string>();
  std::ranges::replace(text, '\n', ' ');
  if (text.size() > most) text = text.substr(0, most) + "...";
  throw InputError({}, path, std::string("expected ").append(expected).append(", got ").append(text));
}

ParamValues param_values(const py::dict& given) {
  ParamValues values;
  add_params(given, "", values);
  return values;
}

py::object shown(const ParamValue& value) {
  return std::visit([](const auto& v) -> py::object { return py::cast(v); }, value);
}

DoubleArray numbers(py::handle given, std::vector<py::ssize_t> shape, const std::string& path) {
  DoubleArray array = py::isinstance<py::str>(given) ? DoubleArray() : DoubleArray::ensure(given);
  if (!array) PyErr_Clear();
  if (!array || !std::equal(shape.begin(), shape.end(), array.shape(), array.shape() + array.ndim()))
    refuse(path, shape_text(shape), given);
  return array;
}

py::array frozen_view(const double* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                      py::handle base) {
  py::array array{py::dtype::of<double>(), std::move(shape), std::move(strides), data, base};
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

std::string_view lasting_text(const std::string& text) {
  constexpr std::size_t most = 4096;
  static std::mutex guard;
  static std::set<std::string>& texts = *new std::set<std::string>;  // outlives whatever else ends
  if (text.empty()) return {};
  const std::lock_guard lock{guard};
  const auto found = texts.find(text);
  if (found != texts.end()) return *found;
  return texts.size() < most ? std::string_view{*texts.insert(text).first} : "(one note too many)";
}

void bind_errors(py::module_& m) {
  py::register_exception<InputError>(m, "InputError", PyExc_ValueError).doc() =
      "Input that cannot be used: a file, a name, a value. One line that says where, what was expected and, "
      "for a name, the nearest that there is.";
  py::register_exception<RunDiverged>(m, "RunDiverged", PyExc_RuntimeError).doc() =
      "A run that broke: which vehicle, when, and what left what is finite and possible. It has no results.";
}

}  // namespace fairway::python
