// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/run_index.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/experiment/compare.hpp"
#include "fairway/studies/study_runs.hpp"

namespace fairway {
namespace {

using nlohmann::json;

/// "cube20_8 apf corrected".
std::string list_label(const Labels& labels) {
  std::string label = cell_name(labels);
  std::ranges::replace(label, '/', ' ');
  label.pop_back();
  return label;
}

}  // namespace

RunIndex::RunIndex(const StudyOptions& options, std::initializer_list<const std::vector<Cell>*> groups)
    : options_{options} {
  for (const std::vector<Cell>* cells : groups) std::ranges::for_each(*cells, [&](const Cell& c) { add(c); });
}

void RunIndex::add(const Cell& cell) {
  Group& group = groups_[cell_name(cell.labels())];
  group = {.first = list_.size(), .seeds = {}, .results = cell.results};
  const std::string label = list_label(cell.labels());
  for (const StudyRun& run : cell.runs) {
    const RunSpec kept = spec_under(options_, run.spec);
    list_.add(label, kept, options_.playback ? options_.playback(kept) : std::string());
    group.seeds.push_back(kept.seed);
  }
}

const RunIndex::Group* RunIndex::find(const Labels& cell) const {
  const auto found = groups_.find(cell_name(cell));
  return found == groups_.end() ? nullptr : &found->second;
}

json RunIndex::runs_of(const Labels& cell) const {
  const Group* group = find(cell);
  if (group == nullptr) return nullptr;
  std::vector<std::size_t> places(group->seeds.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = group->first + i;
  return page::references(places);
}

json RunIndex::run_of(const Labels& cell, std::uint64_t seed) const {
  const Group* group = find(cell);
  if (group == nullptr) return nullptr;
  const auto found = std::ranges::find(group->seeds, seed);
  if (found == group->seeds.end()) return nullptr;
  const std::array place{group->first + static_cast<std::size_t>(found - group->seeds.begin())};
  return page::references(place);
}

json RunIndex::values_of(const Labels& cell, std::string_view quantity) const {
  const Group* group = find(cell);
  if (group == nullptr) return nullptr;
  std::vector<double> values;
  for (const std::vector<Measure>& run : group->results) values.push_back(run_value(run, quantity));
  if (std::ranges::all_of(values, [](double value) { return std::isnan(value); })) return nullptr;
  return page::shown_values(values);
}

json RunIndex::mark(json point, const Labels& cell, std::string_view quantity) const {
  json values = values_of(cell, quantity);
  if (!values.is_null()) point["values_label"] = quantity;
  return page::linked(std::move(point), runs_of(cell), std::move(values));
}

json RunIndex::line(json row, const Labels& cell, std::string_view quantity) const {
  json runs = runs_of(cell);
  if (runs.is_null()) return row;
  row["$runs"] = std::move(runs);
  if (json values = values_of(cell, quantity); !values.is_null()) {
    row["$values"] = std::move(values);
    row["$values_label"] = quantity;
  }
  return row;
}

Labels cell_of(const StudyRow& row) {
  return cell_labels(row.cell, row.method, row.mode, row.part, row.params);
}

}  // namespace fairway
