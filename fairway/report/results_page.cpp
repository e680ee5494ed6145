// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/results_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fairway/core/error.hpp"
#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/studies/page_blocks.hpp"

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

/// The values of one quantity in one cell, one per vehicle and run.
std::vector<double> values_of(std::span<const RunRecord> records, const ComparedCell& cell,
                              const std::string& by, const std::string& quantity) {
  std::vector<double> values;
  for (const RunRecord& record : records) {
    const std::string* candidate = find_label(record.spec.labels, by);
    if (candidate == nullptr || *candidate != cell.candidate ||
        without_label(record.spec.labels, by) != cell.group)
      continue;
    for (const Measure& measure : record.measures) {
      if (measure.quantity == quantity && std::isfinite(measure.value)) values.push_back(measure.value);
    }
  }
  return values;
}

json boxes(std::span<const RunRecord> records, const Comparison& comparison, const std::string& quantity) {
  const auto groups = distinct(comparison.cells, [](const ComparedCell& c) { return name_of(c.group); });
  const auto candidates = distinct(comparison.cells, [](const ComparedCell& c) { return c.candidate; });
  json series = json::array();
  for (const std::string& candidate : candidates) {
    json row = json::array();
    for (const std::string& group : groups) {
      const auto cell = std::ranges::find_if(comparison.cells, [&](const ComparedCell& c) {
        return c.candidate == candidate && name_of(c.group) == group;
      });
      row.push_back(cell == comparison.cells.end()
                        ? json()
                        : page::box(values_of(records, *cell, comparison.by, quantity)));
    }
    series.push_back({{"label", candidate}, {"boxes", row}});
  }
  return {{"kind", "boxes"},
          {"title", quantity},
          {"y_label", quantity},
          {"categories", groups},
          {"series", series}};
}

json means_table(const Comparison& comparison) {
  json rows = json::array();
  for (const ComparedMean& mean : comparison.means) {
    const bool paired = mean.difference.count > 0;
    rows.push_back({{"cell", name_of(mean.group)},
                    {"candidate", mean.candidate},
                    {"quantity", mean.quantity},
                    {"mean", page::number(mean.value.mean)},
                    {"low", page::number(mean.value.low)},
                    {"high", page::number(mean.value.high)},
                    {"runs", mean.value.count},
                    {"difference", paired ? page::number(mean.difference.mean) : json()},
                    {"difference_low", paired ? page::number(mean.difference.low) : json()},
                    {"difference_high", paired ? page::number(mean.difference.high) : json()}});
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

json rates_table(const Comparison& comparison) {
  json rows = json::array();
  for (const ComparedRate& rate : comparison.rates) {
    rows.push_back({{"cell", name_of(rate.group)},
                    {"candidate", rate.candidate},
                    {"rate", rate.name},
                    {"value", page::number(rate.value.rate)},
                    {"low", rate.value.low},
                    {"high", rate.value.high},
                    {"runs", rate.value.trials}});
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
  std::vector<json> charts;
  for (const std::string& quantity :
       distinct(comparison.means, [](const ComparedMean& m) { return m.quantity; })) {
    charts.push_back(boxes(records, comparison, quantity));
  }
  const auto section = [](const char* id, const char* title, json blocks) {
    return json{{"id", id}, {"title", title}, {"paragraphs", json::array()}, {"blocks", std::move(blocks)}};
  };
  json sections = json::array();
  sections.push_back(section("rates", "Rates", json::array({rates_table(comparison)})));
  sections.push_back(section("quantities", "Quantities", json::array({page::grid(2, std::move(charts))})));
  sections.push_back(section("means", "Means", json::array({means_table(comparison)})));
  return {{"title", name},
          {"subtitle", "Stored results"},
          {"version", fmt::format("fairway {}", fairway_version)},
          {"command", command},
          {"facts",
           {{{"label", "Runs"}, {"value", std::to_string(records.size())}},
            {{"label", "Cells"}, {"value", std::to_string(comparison.cells.size())}}}},
          {"sections", sections}};
}

}  // namespace fairway
