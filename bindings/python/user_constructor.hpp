// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::python {

/// A class or factory of Python as fairway sees it: its parameters are those of its signature.
class UserConstructor {
 public:
  /// Throws InputError for what cannot be called, and for a class without decide().
  UserConstructor(std::string name, pybind11::object callable);

  const std::string& name() const { return name_; }

  /// Those that can be given by name and have a default or need a value; `seed` is not among them.
  const std::vector<ParamInfo>& params() const { return params_; }

  /// A new object: called with those of `values` that are its own, and with `seed` drawn from `rng` if it
  /// takes one; then its reset() is called if it has one. Throws InputError for a parameter without a value,
  /// raises what the constructor raises, and TypeError for an object without decide(). With the lock held.
  pybind11::object operator()(const ParamValues& values, Rng rng) const;

 private:
  void read_signature();

  std::string name_;
  pybind11::object callable_;
  std::vector<ParamInfo> params_;
  std::vector<std::string> required_;
  bool takes_seed_{false};
};

/// Names and constructors of a dict, in its order. Throws InputError for what is not one, and for a name that
/// cannot stand in a scenario.
std::vector<std::pair<std::string, pybind11::object>> named_algorithms(const pybind11::object& algorithms);

/// "ZeroDivisionError: division by zero".
std::string first_line(const pybind11::error_already_set& error);

}  // namespace fairway::python
