// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/page_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fairway/core/text.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway::page {

using nlohmann::json;

namespace {

/// "told_m 3, wait".
std::string params_text(const ParamValues& params) {
  std::string text;
  for (const auto& [name, value] : params) {
    const double* number = std::get_if<double>(&value);
    text += text.empty() ? name : ", " + name;
    if (number != nullptr) text += " " + number_text(*number);
  }
  return text;
}

/// A value of one run stands for both ends where nothing is drawn.
bool has_interval(const StudyRow& row) { return row.runs > 1; }

template <class T>
bool differ(std::span<const StudyRow> rows, T StudyRow::*member) {
  return std::ranges::any_of(rows, [&](const StudyRow& row) { return row.*member != rows.front().*member; });
}

}  // namespace

json number(double value) { return std::isfinite(value) ? json(value) : json(); }

json box(std::vector<double> values) {
  if (values.empty()) return nullptr;
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  const BoxSummary summary = summarize(std::move(values));
  return {{"min", summary.low_whisker},   {"q1", summary.lower_quartile}, {"median", summary.median},
          {"q3", summary.upper_quartile}, {"max", summary.high_whisker},  {"mean", mean},
          {"outliers", summary.outliers}, {"count", summary.count}};
}

double rounded(double value, double parts) { return std::round(value * parts) / parts; }

json series(std::string_view label, const std::vector<double>& x, const std::vector<double>& y) {
  return {{"label", label}, {"x", x}, {"y", y}};
}

json lines(std::string_view title, std::string_view x_label, std::string_view y_label, json curves) {
  return {{"kind", "lines"},
          {"title", title},
          {"x_label", x_label},
          {"y_label", y_label},
          {"series", std::move(curves)}};
}

void Way::add(double time, const Vec3& position) {
  t_.push_back(rounded(time, parts_));
  n_.push_back(rounded(position.x(), parts_));
  e_.push_back(rounded(position.y(), parts_));
  d_.push_back(rounded(position.z(), parts_));
}

json Way::track(std::string_view label) const {
  return {{"label", label}, {"n", n_}, {"e", e_}, {"d", d_}, {"t", t_}};
}

json note(std::string_view tone, std::string text) {
  return {{"kind", "note"}, {"tone", tone}, {"text", std::move(text)}};
}

json grid(int columns, std::vector<json> blocks) {
  return {{"kind", "grid"}, {"columns", columns}, {"blocks", std::move(blocks)}};
}

json comparison_table(std::string title, std::span<const StudyRow> rows, const RunIndex& runs,
                      std::string_view words) {
  json lines = json::array();
  for (const StudyRow& row : rows) {
    json line = row_json(row);
    line["params"] = params_text(row.params);
    if (!has_interval(row)) line["low"] = line["high"] = nullptr;
    lines.push_back(runs.line(std::move(line), cell_of(row), row.quantity));
  }
  const auto column = [](const char* key, const char* label, const char* type) {
    return json{{"key", key}, {"label", label}, {"type", type}};
  };
  const auto number_column = [&](const char* key, const char* label) {
    json column{{"key", key}, {"label", label}, {"type", "number"}};
    column["digits"] = 1;
    return column;
  };
  json columns{column("case", "Case", "text"), column("method", "Method", "text")};
  if (differ(rows, &StudyRow::mode)) columns.push_back(column("mode", "Setting", "text"));
  if (differ(rows, &StudyRow::params)) columns.push_back(column("params", "Parameters", "text"));
  columns.push_back(column("quantity", "Quantity", "text"));
  json filter = json::array();
  for (const json& shown : columns) filter.push_back(shown["key"]);
  for (const json& shown :
       {number_column("published", "Published"), number_column("measured", "Measured"),
        column("deviation_ratio", "Deviation", "deviation"), column("verdict", "Verdict", "verdict")})
    columns.push_back(shown);
  if (std::ranges::any_of(rows, has_interval)) {
    columns.push_back(number_column("low", "95 % from"));
    columns.push_back(number_column("high", "to"));
  }
  columns.push_back(column("runs", "Runs", "number"));
  columns.push_back(column("note", "Note", "remark"));
  return {{"kind", "table"},
          {"title", std::move(title)},
          {"columns", std::move(columns)},
          {"rows", std::move(lines)},
          {"filter", std::move(filter)},
          {"note", fmt::format("A row leads to its runs; beside each is its own value, a mean over the "
                               "vehicles where each has one.{}{}",
                               words.empty() ? "" : " ", words)}};
}

json method_intervals(std::span<const StudyRow> rows, std::span<const Method> methods,
                      std::string_view quantity, std::string_view label,
                      const std::vector<std::string>& places, const RunIndex& runs) {
  json series = json::array();
  for (const Method& method : methods) {
    json points = json::array();
    for (const std::string& place : places) {
      const auto row = std::ranges::find_if(rows, [&](const StudyRow& r) {
        return r.cell == place && r.method == method.name && r.quantity == quantity;
      });
      json& point = points.emplace_back();
      if (row == rows.end() || !std::isfinite(row->measured) || !std::isfinite(row->low)) continue;
      point = {{"value", row->measured}, {"low", row->low}, {"high", row->high}};
      if (row->published) point["published"] = *row->published;
      point = runs.mark(std::move(point), cell_of(*row), quantity);
    }
    series.push_back({{"label", method.name}, {"points", points}});
  }
  return intervals(label, label, places, std::move(series));
}

json intervals(std::string_view title, std::string_view y_label, json categories, json series) {
  return {{"kind", "intervals"},
          {"title", title},
          {"y_label", y_label},
          {"categories", std::move(categories)},
          {"series", std::move(series)}};
}

json fact(std::string_view label, std::string value) {
  return {{"label", label}, {"value", std::move(value)}};
}

json fact(std::string_view label, std::span<const StudyRow> rows, Verdict verdict) {
  return fact(label, std::to_string(std::ranges::count(rows, verdict, &StudyRow::verdict)));
}

json document(std::string_view title, std::string_view subtitle, std::string_view command, json facts,
              const RunList& runs, json sections) {
  facts.insert(facts.begin(), fact("Runs", std::to_string(runs.size())));
  return {{"title", title},
          {"subtitle", subtitle},
          {"version", "fairway " + std::string(fairway_version)},
          {"command", command},
          {"facts", std::move(facts)},
          {"runs", runs.document()},
          {"sections", std::move(sections)}};
}

json section(const char* id, const char* title, std::vector<std::string> paragraphs,
             std::vector<json> blocks) {
  return {{"id", id}, {"title", title}, {"paragraphs", std::move(paragraphs)}, {"blocks", std::move(blocks)}};
}

json scene(const std::string& title, json tracks, std::span<const ObstacleSpec> obstacles, const Vec3& goal) {
  json spheres = json::array();
  for (const ObstacleSpec& spec : obstacles) {
    const std::array centre{spec.position.x(), spec.position.y(), spec.position.z()};
    const char* label = spec.moves() ? "drifts" : spec.charted ? "charted" : "not charted";
    spheres.push_back({{"centre", centre}, {"radius", spec.radius}, {"label", label}});
  }
  return {{"kind", "trajectories"},
          {"title", title},
          {"vehicles", std::move(tracks)},
          {"goals", json::array({{goal.x(), goal.y(), goal.z()}})},
          {"spheres", std::move(spheres)}};
}

}  // namespace fairway::page
