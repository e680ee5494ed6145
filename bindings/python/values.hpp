// SPDX-License-Identifier: Apache-2.0
// How C++ values are read from Python, and how Python sees them.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/avoidance/command.hpp"
#include "fairway/core/error.hpp"
#include "fairway/core/ids.hpp"
#include "fairway/core/names.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/speech.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::python {

namespace py = pybind11;

using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Throws InputError: "Track.position: expected three numbers, got 'north'".
[[noreturn]] void refuse(const std::string& path, std::string_view expected, py::handle got);

/// Keyword arguments as parameters, as `--set` takes them: numbers, switches, words; a list of dicts is a
/// list of structs. Throws InputError.
ParamValues param_values(const py::dict& given);

/// A parameter's value for Python: float, bool or str.
py::object shown(const ParamValue& value);

/// `rows` x `columns` numbers, or fewer dimensions where they are 1. Throws InputError.
DoubleArray numbers(py::handle given, std::vector<py::ssize_t> shape, const std::string& path);

/// Numbers that `base` keeps alive and nobody may write.
py::array frozen_view(const double* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                      py::handle base);

/// An array that takes over `values`, read only. O(1).
template <class V>
py::array owned_array(std::vector<V> values, std::vector<py::ssize_t> shape) {
  auto* const kept = new std::vector<V>(std::move(values));
  const py::capsule owner{kept, [](void* p) { delete static_cast<std::vector<V>*>(p); }};
  py::array_t<V> array{std::move(shape), kept->data(), owner};
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// The same text for ever, for notes of commands, which outlive whoever wrote them. Keeps a few thousand
/// different ones; any other is "(one note too many)".
std::string_view lasting_text(const std::string& text);

/// Whether the __init__ of a value of the module has run: __new__ alone leaves its memory as it was.
inline bool is_made(py::handle self) {
  auto* const instance = reinterpret_cast<py::detail::instance*>(self.ptr());
  return !instance->owned || instance->get_value_and_holder().holder_constructed();
}

/// The value in an object of its class. Throws InputError unless it is made.
template <class T>
const T& made(py::handle self) {
  if (py::isinstance<T>(self) && !is_made(self))
    throw InputError(py::type::of<T>().attr("__name__").template cast<std::string>() +
                     ": is empty, since __init__ has not run");
  return self.cast<const T&>();
}

// ---- from Python: each throws InputError that says where and what was expected

template <class V>
struct Read {  // what pybind11 knows, the module's own classes among it
  static V from(py::handle given, const std::string& path) {
    try {
      if constexpr (std::is_class_v<V> && !std::is_same_v<V, std::string>) {
        return made<V>(given);
      } else {
        return py::cast<V>(given);
      }
    } catch (const py::cast_error&) {
      refuse(path, expected(), given);
    }
  }
  static std::string expected() {
    if constexpr (std::is_same_v<V, double>) {
      return "a number";
    } else if constexpr (std::is_same_v<V, bool>) {
      return "True or False";
    } else if constexpr (std::is_integral_v<V>) {
      return "a whole number that fits";
    } else if constexpr (std::is_same_v<V, std::string>) {
      return "text";
    } else {
      return "a value of class " + py::type::of<V>().attr("__name__").template cast<std::string>();
    }
  }
};

template <class E>
  requires(std::is_enum_v<E> && requires { EnumNames<E>::names; })
struct Read<E> {
  static E from(py::handle given, const std::string& path) {
    if constexpr (std::is_same_v<E, Mode>) {
      if (py::isinstance<Mode>(given)) {
        const Mode mode = py::cast<Mode>(given);
        if (static_cast<std::size_t>(mode) >= EnumNames<E>::names.size())
          refuse(path, "one of its names", given);
        return mode;
      }
    }
    if (!py::isinstance<py::str>(given)) refuse(path, "one of its names", given);
    const std::string word = py::cast<std::string>(given);
    const std::vector<std::string_view> known{EnumNames<E>::names.begin(), EnumNames<E>::names.end()};
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (known[i] == word) return static_cast<E>(i);
    }
    throw InputError({}, path, "unknown \"" + word + "\"" + suggestion(word, known));
  }
};

template <>
struct Read<Speech> {
  static Speech from(py::handle given, const std::string& path) {
    const std::string expected = "bytes, " + std::to_string(Speech::most_bytes) + " at most";
    if (!py::isinstance<py::bytes>(given)) refuse(path, expected, given);
    const std::string_view bytes = py::reinterpret_borrow<py::bytes>(given);
    if (bytes.size() > Speech::most_bytes) refuse(path, expected, given);
    Speech speech{.size = static_cast<std::uint8_t>(bytes.size())};
    std::ranges::copy(bytes, speech.bytes.begin());
    return speech;
  }
};

template <class Id>
struct ReadId {
  static Id from(py::handle given, const std::string& path) {
    return Id{Read<std::uint32_t>::from(given, path)};
  }
};
template <>
struct Read<VehicleId> : ReadId<VehicleId> {};
template <>
struct Read<TrackId> : ReadId<TrackId> {};

template <int Rows, int Columns>
struct Read<Eigen::Matrix<double, Rows, Columns>> {
  static Eigen::Matrix<double, Rows, Columns> from(py::handle given, const std::string& path) {
    const DoubleArray array =
        Columns == 1 ? numbers(given, {Rows}, path) : numbers(given, {Rows, Columns}, path);
    return Eigen::Map<
        const Eigen::Matrix<double, Rows, Columns, Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>>(
        array.data());
  }
};

template <>
struct Read<std::string_view> {
  static std::string_view from(py::handle given, const std::string& path) {
    return lasting_text(Read<std::string>::from(given, path));
  }
};

template <class V>
struct Read<std::optional<V>> {
  static std::optional<V> from(py::handle given, const std::string& path) {
    if (given.is_none()) return std::nullopt;
    return Read<V>::from(given, path);
  }
};

template <class V>
struct Read<std::vector<V>> {
  static std::vector<V> from(py::handle given, const std::string& path) {
    if (!py::isinstance<py::iterable>(given)) refuse(path, "a sequence", given);
    std::vector<V> all;
    for (const py::handle item : given)
      all.push_back(Read<V>::from(item, path + "[" + std::to_string(all.size()) + "]"));
    return all;
  }
};

template <class V, std::size_t N>
struct Read<std::array<V, N>> {
  static std::array<V, N> from(py::handle given, const std::string& path) {
    const std::vector<V> read = Read<std::vector<V>>::from(given, path);
    if (read.size() != N) refuse(path, std::to_string(N) + " of them", given);
    std::array<V, N> all;
    std::ranges::copy(read, all.begin());
    return all;
  }
};

// ---- for type checkers

/// The types of a field in a stub file: what a constructor takes, and what the attribute is.
struct Hint {
  std::string given, shown;
};

template <class V>
Hint hint_of() {
  if constexpr (std::is_same_v<V, bool>) {
    return {"bool", "bool"};
  } else if constexpr (std::is_integral_v<V> || std::is_same_v<V, VehicleId> || std::is_same_v<V, TrackId>) {
    return {"int", "int"};
  } else if constexpr (std::is_same_v<V, double>) {
    return {"float", "float"};
  } else if constexpr (std::is_same_v<V, Speech>) {
    return {"bytes", "bytes"};
  } else if constexpr (std::is_same_v<V, Mode>) {
    return {"Mode | str", "Mode"};
  } else if constexpr (std::is_enum_v<V> || std::is_convertible_v<V, std::string_view>) {
    return {"str", "str"};
  } else if constexpr (std::is_base_of_v<Eigen::MatrixBase<V>, V> || std::is_same_v<V, std::vector<Vec3>>) {
    return {"npt.ArrayLike", "_Doubles"};
  } else if constexpr (requires { typename V::iterator; }) {
    const Hint item = hint_of<typename V::value_type>();
    return {"Iterable[" + item.given + "]", "tuple[" + item.shown + ", ...]"};
  } else if constexpr (requires { typename V::value_type; }) {
    const Hint present = hint_of<typename V::value_type>();
    return {present.given + " | None", present.shown + " | None"};
  } else {
    const std::string name = py::type::of<V>().attr("__name__").template cast<std::string>();
    return {name, name};
  }
}

// ---- for Python: `self` owns the value, which nobody changes

template <class V>
py::object show(const V& value, py::handle self) {
  if constexpr (std::is_same_v<V, VehicleId> || std::is_same_v<V, TrackId>) {
    return py::int_(number(value));
  } else if constexpr (std::is_same_v<V, Speech>) {
    return py::bytes(reinterpret_cast<const char*>(value.bytes.data()), value.size);
  } else if constexpr (std::is_same_v<V, Mode> || std::is_arithmetic_v<V> || std::is_same_v<V, std::string> ||
                       std::is_same_v<V, std::string_view>) {
    return py::cast(value);
  } else if constexpr (std::is_enum_v<V>) {
    return py::str(enum_name(value));
  } else {
    return py::cast(&value, py::return_value_policy::reference_internal, self);
  }
}

template <int Rows, int Columns>
py::object show(const Eigen::Matrix<double, Rows, Columns>& value, py::handle self) {
  constexpr py::ssize_t step = sizeof(double);
  if constexpr (Columns == 1) {
    return frozen_view(value.data(), {Rows}, {step}, self);
  } else {
    return frozen_view(value.data(), {Rows, Columns}, {step, Rows * step}, self);
  }
}

template <class V>
py::object show(const std::optional<V>& value, py::handle self) {
  return value ? show(*value, self) : py::none();
}

/// As rows.
inline py::object show(const std::vector<Vec3>& values, py::handle self) {
  static const Vec3 none = Vec3::Zero();
  return frozen_view(values.empty() ? none.data() : values.front().data(),
                     {static_cast<py::ssize_t>(values.size()), 3}, {sizeof(Vec3), sizeof(double)}, self);
}

template <class V>
py::object show(const std::vector<V>& values, py::handle self) {
  py::tuple all{values.size()};
  for (std::size_t i = 0; i < values.size(); ++i) all[i] = show(values[i], self);
  return all;
}

template <class V, std::size_t N>
py::object show(const std::array<V, N>& values, py::handle self) {
  return show(std::vector<V>{values.begin(), values.end()}, self);
}

}  // namespace fairway::python
