// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/cell.hpp"
#include "fairway/studies/run_index.hpp"

/// Blocks of a report document; viewer/README.md describes what the page makes of them.
namespace fairway::page {

/// A number, or null where it is not finite.
nlohmann::json number(double value);

/// A box of a box plot, or null of no values.
nlohmann::json box(std::vector<double> values);

/// To so many parts of one, as far as a picture shows it.
double rounded(double value, double parts);

/// A curve of the block `lines`.
nlohmann::json series(std::string_view label, const std::vector<double>& x, const std::vector<double>& y);

nlohmann::json lines(std::string_view title, std::string_view x_label, std::string_view y_label,
                     nlohmann::json curves);

/// Where something was, over time, to so many parts of a metre and a second.
class Way {
 public:
  explicit Way(double parts) : parts_{parts} {}

  void add(double time, const Vec3& position);

  const std::vector<double>& t() const { return t_; }
  const std::vector<double>& n() const { return n_; }
  const std::vector<double>& e() const { return e_; }

  /// One track of the block `trajectories`.
  nlohmann::json track(std::string_view label) const;

 private:
  double parts_;
  std::vector<double> t_, n_, e_, d_;
};

nlohmann::json note(std::string_view tone, std::string text);

nlohmann::json grid(int columns, std::vector<nlohmann::json> blocks);

/// Published against measured, one line a row, which leads to the runs of its cell. Settings and parameters
/// have columns where they tell rows apart; `words` are added to what is said below it.
nlohmann::json comparison_table(std::string title, std::span<const StudyRow> rows, const RunIndex& runs,
                                std::string_view words = "");

/// One quantity of every method by place, with its interval and what is published, where it is among the
/// rows.
nlohmann::json method_intervals(std::span<const StudyRow> rows, std::span<const Method> methods,
                                std::string_view quantity, std::string_view label,
                                const std::vector<std::string>& places, const RunIndex& runs);

/// A chart of intervals: each series has a point for each category.
nlohmann::json intervals(std::string_view title, std::string_view y_label, nlohmann::json categories,
                         nlohmann::json series);

/// A number at the head of the report.
nlohmann::json fact(std::string_view label, std::string value);
/// How many rows have that verdict.
nlohmann::json fact(std::string_view label, std::span<const StudyRow> rows, Verdict verdict);

/// A whole report; the number of its runs goes before the facts.
nlohmann::json document(std::string_view title, std::string_view subtitle, std::string_view command,
                        nlohmann::json facts, const RunList& runs, nlohmann::json sections);

nlohmann::json section(const char* id, const char* title, std::vector<std::string> paragraphs,
                       std::vector<nlohmann::json> blocks);

/// The obstacles and goal seen from above, and the ways through them (`vehicles` of the block
/// `trajectories`).
nlohmann::json scene(const std::string& title, nlohmann::json tracks, std::span<const ObstacleSpec> obstacles,
                     const Vec3& goal);

}  // namespace fairway::page
