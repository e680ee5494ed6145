// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/results_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "fairway/experiment/labels.hpp"

namespace fairway {

using nlohmann::json;

namespace {

/// "case, range_m" of "case" and "perception.range_m"; whole names where their last parts are alike.
std::string last_parts(const std::vector<std::string>& names) {
  std::set<std::string> parts;
  std::string whole, short_text;
  for (const std::string& name : names) {
    const std::string part = name.substr(name.rfind('.') + 1);
    parts.insert(part);
    whole += (whole.empty() ? "" : ", ") + name;
    short_text += (short_text.empty() ? "" : ", ") + part;
  }
  return parts.size() == names.size() ? short_text : whole;
}

}  // namespace

GroupNames::GroupNames(const Comparison& comparison) {
  LabelValues values;
  for (const ComparedCell& cell : comparison.cells) {
    add_values(values, cell.group);
    several_ = several_ || cell.group != comparison.cells.front().group;
  }
  for (const auto& [name, known] : values) {
    const bool everywhere = std::ranges::all_of(
        comparison.cells, [&](const ComparedCell& cell) { return find_label(cell.group, name) != nullptr; });
    if (known.size() > 1 || !everywhere) varying_.push_back(name);
  }
  if (varying_.empty() && !values.empty()) varying_.push_back(values.front().first);
  label_ = varying_.size() == 1 ? varying_.front() : last_parts(varying_);
}

std::string GroupNames::of(const Labels& group) const {
  std::string text;
  for (const std::string& name : varying_) {
    const std::string* value = find_label(group, name);
    if (value == nullptr) continue;
    text += text.empty() ? "" : ", ";
    // the case goes by its own name
    text += varying_.size() == 1 || name == "case" ? *value : name + " " + *value;
  }
  return text.empty() ? "all" : text;
}

CellRuns::CellRuns(std::span<const RunRecord> records, const std::string& by) : records_{records} {
  std::map<std::pair<Labels, std::string>, std::vector<const RunRecord*>> cells;
  for (const RunRecord& record : records) {
    const Labels& labels = record.spec.labels;
    list_.add(labels_text(labels), record.spec, "");
    const std::string* candidate = find_label(labels, by);
    if (candidate != nullptr) cells[{without_label(labels, by), *candidate}].push_back(&record);
  }
  // as compare() counts them: where one cell shows that nothing is drawn, the others of its group know it
  std::set<Labels> same;
  for (const auto& [cell, runs] : cells) {
    if (counted_runs(runs).size() < runs.size()) same.insert(cell.first);
  }
  for (const auto& [cell, runs] : cells) {
    for (const RunRecord* run : counted_runs(runs, same.contains(cell.first)))
      places_[cell].push_back(static_cast<std::size_t>(run - records.data()));
  }
}

std::vector<double> CellRuns::values(const Labels& group, const std::string& candidate,
                                     const std::string& quantity) const {
  std::vector<double> values;
  for (const std::size_t place : of(group, candidate)) {
    const RunRecord& run = records_[place];
    values.push_back(run.failure.empty() ? run_value(run.measures, quantity)
                                         : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

json CellRuns::line(json line, const Labels& group, const std::string& candidate,
                    const std::string& quantity) const {
  const std::vector<double> shown = values(group, candidate, quantity);
  line["$runs"] = page::references(of(group, candidate));
  if (std::ranges::any_of(shown, [](double value) { return std::isfinite(value); })) {
    line["$values"] = page::shown_values(shown);
    line["$values_label"] = quantity;
  }
  return line;
}

}  // namespace fairway
