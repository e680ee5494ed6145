// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/measures.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "bindings/python/values.hpp"

namespace fairway::python {
namespace {

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// A quantity of all runs, `width` numbers each.
struct Column {
  py::ssize_t width{};
  std::vector<double> values;
};

}  // namespace

py::dict fleet_dict(std::span<const Measure> measures) {
  py::dict all;
  for (const Measure& m : measures) {
    if (m.vehicle == Measure::fleet) all[py::str(m.quantity)] = m.value;
  }
  return all;
}

py::list vehicle_dicts(std::span<const Measure> measures, std::span<const std::string> names) {
  py::list all;
  for (const std::string& name : names) {
    py::dict vehicle;
    vehicle["name"] = name;
    all.append(vehicle);
  }
  for (const Measure& m : measures) {
    if (m.vehicle == Measure::fleet) continue;
    all[static_cast<std::size_t>(m.vehicle)][py::str(m.quantity)] = m.value;
  }
  return all;
}

MeasureColumns measure_columns(std::span<const std::vector<Measure>> runs) {
  int most = 0;
  for (const auto& measures : runs) {
    for (const Measure& m : measures) most = std::max(most, m.vehicle + 1);
  }
  std::vector<std::pair<std::string, bool>> order;  // as first seen
  std::map<std::pair<std::string, bool>, Column> columns;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (const Measure& m : runs[run]) {
      const bool of_fleet = m.vehicle == Measure::fleet;
      const auto [found, is_new] = columns.try_emplace({m.quantity, of_fleet});
      Column& column = found->second;
      if (is_new) {
        order.push_back(found->first);
        column.width = of_fleet ? 1 : most;
        column.values.assign(runs.size() * static_cast<std::size_t>(column.width), not_measured);
      }
      const int vehicle = of_fleet ? 0 : m.vehicle;
      column.values[run * static_cast<std::size_t>(column.width) + static_cast<std::size_t>(vehicle)] =
          m.value;
    }
  }
  MeasureColumns all;
  const auto rows = static_cast<py::ssize_t>(runs.size());
  for (const auto& key : order) {
    Column& column = columns[key];
    const auto& [quantity, of_fleet] = key;
    const std::vector<py::ssize_t> shape =
        of_fleet ? std::vector<py::ssize_t>{rows} : std::vector<py::ssize_t>{rows, column.width};
    (of_fleet ? all.fleet : all.vehicles)[py::str(quantity)] = owned_array(std::move(column.values), shape);
  }
  return all;
}

}  // namespace fairway::python
