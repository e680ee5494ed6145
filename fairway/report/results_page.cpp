// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/results_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/run_list.hpp"

namespace fairway {
namespace {

using nlohmann::json;

std::string name_of(const Labels& group) { return group.empty() ? "all" : labels_text(group); }

template <class T>
std::vector<std::string> distinct(const std::vector<T>& items, auto name) {
  std::vector<std::string> names;
  for (const T& item : items) {
    const std::string found = name(item);
    if (std::ranges::find(names, found) == names.end()) names.push_back(found);
  }
  return names;
}

/// The runs of the cells, and where they stand in the document.
class CellRuns {
 public:
  CellRuns(std::span<const RunRecord> records, const std::string& by) : records_{records} {
    for (const RunRecord& record : records) {
      const Labels& labels = record.spec.labels;
      const std::size_t place = list_.add(labels_text(labels), record.spec, "");
      const std::string* candidate = find_label(labels, by);
      if (candidate != nullptr) places_[{without_label(labels, by), *candidate}].push_back(place);
    }
  }

  /// Places of the runs of a cell that was compared.
  const std::vector<std::size_t>& of(const Labels& group, const std::string& candidate) const {
    return places_.at({group, candidate});
  }

  const RunRecord& operator[](std::size_t place) const { return records_[place]; }
  json document() const { return list_.document(); }

 private:
  std::span<const RunRecord> records_;
  std::map<std::pair<Labels, std::string>, std::vector<std::size_t>> places_;
  page::RunList list_;
};

/// The values of one quantity in a run, one for each vehicle that has it.
std::vector<double> values_in(const RunRecord& record, const std::string& quantity) {
  std::vector<double> values;
  for (const Measure& measure : record.measures) {
    if (measure.quantity == quantity) values.push_back(measure.value);
  }
  return values;
}

/// A box of all values of a quantity in a cell, which leads to its runs.
json box_of(const CellRuns& runs, const ComparedCell& cell, const std::string& quantity) {
  const std::vector<std::size_t>& places = runs.of(cell.group, cell.candidate);
  std::vector<double> finite, shown;
  for (const std::size_t place : places) {
    for (const double value : values_in(runs[place], quantity)) {
      shown.push_back(value);
      if (std::isfinite(value)) finite.push_back(value);
    }
  }
  const bool even = std::ranges::all_of(places, [&](std::size_t place) {
    return values_in(runs[place], quantity).size() * places.size() == shown.size();
  });
  return page::linked(page::box(std::move(finite)), page::references(places),
                      even ? page::shown_values(shown) : json());
}

/// A line of a table, which leads to the runs of its cell; beside each its value.
json line_of(json line, const CellRuns& runs, const Labels& group, const std::string& candidate,
             const std::string& quantity) {
  const std::vector<std::size_t>& places = runs.of(group, candidate);
  std::vector<double> values;
  for (const std::size_t place : places) values.push_back(run_value(runs[place].measures, quantity));
  line["$runs"] = page::references(places);
  if (std::ranges::any_of(values, [](double value) { return std::isfinite(value); }))
    line["$values"] = page::shown_values(values);
  return line;
}

json boxes(const CellRuns& runs, const Comparison& comparison, const std::string& quantity) {
  const auto groups = distinct(comparison.cells, [](const ComparedCell& c) { return name_of(c.group); });
  const auto candidates = distinct(comparison.cells, [](const ComparedCell& c) { return c.candidate; });
  json series = json::array();
  for (const std::string& candidate : candidates) {
    json row = json::array();
    for (const std::string& group : groups) {
      const auto cell = std::ranges::find_if(comparison.cells, [&](const ComparedCell& c) {
        return c.candidate == candidate && name_of(c.group) == group;
      });
      row.push_back(cell == comparison.cells.end() ? json() : box_of(runs, *cell, quantity));
    }
    series.push_back({{"label", candidate}, {"boxes", row}});
  }
  return {{"kind", "boxes"},
          {"title", quantity},
          {"y_label", quantity},
          {"categories", groups},
          {"series", series}};
}

json means_table(const Comparison& comparison, const CellRuns& runs) {
  json rows = json::array();
  for (const ComparedMean& mean : comparison.means) {
    const bool paired = mean.difference.count > 0;
    json line{{"cell", name_of(mean.group)},
              {"candidate", mean.candidate},
              {"quantity", mean.quantity},
              {"mean", page::number(mean.value.mean)},
              {"low", page::number(mean.value.low)},
              {"high", page::number(mean.value.high)},
              {"runs", mean.value.count},
              {"difference", paired ? page::number(mean.difference.mean) : json()},
              {"difference_low", paired ? page::number(mean.difference.low) : json()},
              {"difference_high", paired ? page::number(mean.difference.high) : json()}};
    rows.push_back(line_of(std::move(line), runs, mean.group, mean.candidate, mean.quantity));
  }
  const auto column = [](const char* key, std::string label, const char* type) {
    return json{{"key", key}, {"label", std::move(label)}, {"type", type}};
  };
  return {{"kind", "table"},
          {"title", "Means, and differences paired by seed"},
          {"columns",
           {column("cell", "Cell", "text"), column("candidate", comparison.by, "text"),
            column("quantity", "Quantity", "text"), column("mean", "Mean", "number"),
            column("low", "95 % from", "number"), column("high", "to", "number"),
            column("runs", "Runs", "number"), column("difference", "Less " + comparison.baseline, "number"),
            column("difference_low", "95 % from", "number"), column("difference_high", "to", "number")}},
          {"rows", rows},
          {"filter", {"cell", "candidate", "quantity"}}};
}

json rates_table(const Comparison& comparison, const CellRuns& runs) {
  json rows = json::array();
  for (const ComparedRate& rate : comparison.rates) {
    json line{{"cell", name_of(rate.group)}, {"candidate", rate.candidate},
              {"rate", rate.name},           {"value", page::number(rate.value.rate)},
              {"low", rate.value.low},       {"high", rate.value.high},
              {"runs", rate.value.trials}};
    rows.push_back(line_of(std::move(line), runs, rate.group, rate.candidate, ""));
  }
  return {{"kind", "table"},
          {"title", "Rates, with Wilson's 95 % interval"},
          {"columns",
           {{{"key", "cell"}, {"label", "Cell"}, {"type", "text"}},
            {{"key", "candidate"}, {"label", comparison.by}, {"type", "text"}},
            {{"key", "rate"}, {"label", "Rate"}, {"type", "text"}},
            {{"key", "value"}, {"label", "Value"}, {"type", "number"}, {"digits", 3}},
            {{"key", "low"}, {"label", "from"}, {"type", "number"}, {"digits", 3}},
            {{"key", "high"}, {"label", "to"}, {"type", "number"}, {"digits", 3}},
            {{"key", "runs"}, {"label", "Runs"}, {"type", "number"}}}},
          {"rows", rows},
          {"filter", {"cell", "candidate", "rate"}}};
}

}  // namespace

json results_page(std::span<const RunRecord> records, const std::string& name, const std::string& by,
                  const std::string& command) {
  if (records.empty()) throw InputError(name + ": the store holds no runs");
  const Comparison comparison = compare(records, {.by = by});
  const CellRuns runs{records, comparison.by};
  std::vector<json> charts;
  for (const std::string& quantity :
       distinct(comparison.means, [](const ComparedMean& m) { return m.quantity; })) {
    charts.push_back(boxes(runs, comparison, quantity));
  }
  json sections = json::array();
  sections.push_back(page::section("rates", "Rates", {}, {rates_table(comparison, runs)}));
  sections.push_back(page::section("quantities", "Quantities", {}, {page::grid(2, std::move(charts))}));
  sections.push_back(page::section("means", "Means", {}, {means_table(comparison, runs)}));
  return {{"title", name},
          {"subtitle", "Stored results"},
          {"version", fmt::format("fairway {}", fairway_version)},
          {"command", command},
          {"facts",
           {{{"label", "Runs"}, {"value", std::to_string(records.size())}},
            {{"label", "Cells"}, {"value", std::to_string(comparison.cells.size())}}}},
          {"runs", runs.document()},
          {"sections", sections}};
}

}  // namespace fairway
