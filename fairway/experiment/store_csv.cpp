// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "fairway/core/csv_field.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/store.hpp"

namespace fairway {
namespace {

/// Every label's name, in order of first appearance.
std::vector<std::string> columns_of(std::span<const RunRecord> records) {
  std::vector<std::string> columns;
  for (const RunRecord& record : records) {
    for (const auto& [name, value] : record.spec.labels) {
      if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
    }
  }
  return columns;
}

}  // namespace

void write_csv(std::ostream& out, std::span<const RunRecord> records) {
  const std::vector<std::string> columns = columns_of(records);
  for (const std::string& column : columns) out << csv_field(column) << ',';
  out << "seed,vehicle,quantity,value\n";

  for (const RunRecord& record : records) {
    std::string run;
    for (const std::string& column : columns) {
      const std::string* value = find_label(record.spec.labels, column);
      run += (value == nullptr ? "" : csv_field(*value)) + ",";
    }
    run += std::to_string(record.spec.seed) + ",";
    if (!record.failure.empty()) out << run << ",failure_count,1\n";
    for (const Measure& m : record.measures) {
      const std::string vehicle = m.vehicle == Measure::fleet ? "" : std::to_string(m.vehicle);
      out << run << vehicle << ',' << csv_field(m.quantity) << ',' << number_text(m.value) << '\n';
    }
  }
}

}  // namespace fairway
