// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <string>

#include "fairway/scenario/load.hpp"

namespace fairway::python {

/// `fairway.Scenario`: what a scenario was read from and what is put over it, so that it can be drawn anew
/// for another seed, and the case that was drawn.
class ScenarioText {
 public:
  /// Throws InputError as parse_scenario().
  ScenarioText(const std::string& yaml, std::string file, Overrides overrides,
               std::optional<std::uint64_t> seed);

  /// Throws InputError if the file cannot be read, and likewise.
  static ScenarioText load(const std::string& file, Overrides overrides, std::optional<std::uint64_t> seed);

  const Scenario& scenario() const { return scenario_; }

  /// As it was given; a made-up name for text.
  const std::string& file() const { return file_; }

  /// The case of this seed. Throws InputError where a value drawn does not fit. Needs nothing of Python; safe
  /// to call from several threads.
  Scenario drawn(std::uint64_t seed) const;

  ScenarioText with_seed(std::uint64_t seed) const;
  ScenarioText with_overrides(const Overrides& overrides) const;

  /// Every vehicle under this algorithm: parameters of the file stay where it is the same one, others are its
  /// own.
  ScenarioText with_algorithm(const std::string& name, const ParamValues& params) const;

 private:
  Scenario read(std::optional<std::uint64_t> seed) const;

  std::string file_;
  ScenarioDocument document_;
  Overrides overrides_;
  std::optional<std::uint64_t> seed_;
  std::string algorithm_;  ///< for every vehicle; empty: as written
  ParamValues params_;     ///< of that
  Scenario scenario_;
};

/// A Scenario, or the path of a file. Throws InputError.
ScenarioText scenario_of(const pybind11::object& given);

/// {"vehicles[0].radius_m": 2} as `--set` takes it: numbers, switches, text as it is, lists. None: nothing.
/// Throws InputError.
Overrides overrides_of(const pybind11::object& given);

/// "scenarios/cube.yaml" of a str or os.PathLike. Throws InputError.
std::string path_of(const pybind11::object& given);

}  // namespace fairway::python
