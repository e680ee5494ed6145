// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/cubes/published.hpp"
#include "fairway/studies/cubes/rows.hpp"

namespace fairway::cubes {
namespace {

using Rows = std::span<const StudyRow>;

constexpr double near_enough = 0.15;
constexpr double significant = 0.05;

std::vector<const StudyRow*> rows_with(Rows rows, std::string_view mode, std::string_view quantity,
                                       const std::function<bool(const StudyRow&)>& fits = {}) {
  std::vector<const StudyRow*> found;
  for (const StudyRow& row : rows) {
    if (row.mode == mode && row.quantity == quantity && std::isfinite(row.measured) && (!fits || fits(row)))
      found.push_back(&row);
  }
  return found;
}

const StudyRow* row_with(Rows rows, std::string_view mode, std::string_view quantity, std::string_view cell,
                         std::string_view method) {
  const auto found = rows_with(rows, mode, quantity, [&](const StudyRow& row) {
    return row.cell == cell && row.method == method && row.params.empty();
  });
  return found.empty() ? nullptr : found.front();
}

std::string list_of(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Adds a sentence unless it was withheld.
void say(std::vector<std::string>& text, std::string sentence) {
  if (!sentence.empty()) text.push_back(std::move(sentence));
}

// ---- the parameter phase --------------------------------------------------------------------------

bool is_tuning(const StudyRow& row) { return row.cell == "tuning" && !row.params.empty(); }

std::string tuning_totals(Rows rows) {
  const StudyRow* collisions = row_with(rows, "as_coded", "collision_count", "tuning", "all");
  const StudyRow* apf = row_with(rows, "as_coded", "stuck_count", "tuning", "apf");
  const StudyRow* orca = row_with(rows, "as_coded", "stuck_count", "tuning", "orca3d");
  if (collisions == nullptr || apf == nullptr || orca == nullptr) return "";
  return fmt::format(
      "Parameter phase: {:.0f} counted collisions in {} runs (published: {:.0f}); {:.0f} of {} APF robots "
      "stuck (published: {:.0f}), {:.0f} of {} ORCA robots (published: {:.0f}).",
      collisions->measured, collisions->runs, collisions->published.value_or(0), apf->measured, 4 * apf->runs,
      apf->published.value_or(0), orca->measured, 4 * orca->runs, orca->published.value_or(0));
}

/// How many have a published value, and how many are within 15 % of it.
std::string alike(const std::vector<const StudyRow*>& rows) {
  int all = 0, near = 0;
  for (const StudyRow* row : rows) {
    const auto deviation = row->deviation_ratio();
    all += deviation ? 1 : 0;
    near += deviation && std::abs(*deviation) <= near_enough ? 1 : 0;
  }
  return all == 0 ? "" : fmt::format("{} of {}", near, all);
}

std::string tuning_times(Rows rows) {
  std::vector<std::string> parts;
  for (const std::string_view method : {"apf", "orca3d"}) {
    const std::string near = alike(rows_with(rows, "as_coded", "navigation_time_s", [&](const StudyRow& row) {
      return is_tuning(row) && row.method == method;
    }));
    if (!near.empty()) parts.push_back(fmt::format("{} of {}", near, method));
  }
  if (parts.empty()) return "";
  return fmt::format("Parameter phase, navigation times of cells within 15 % of the published one: {}.",
                     list_of(parts));
}

/// Whether the mean navigation time rises or falls with a parameter, here and as published.
std::string trend(Rows rows, std::string_view method, std::string_view parameter) {
  struct Sums {
    double here{}, there{};
    int count{};
  };
  std::map<double, Sums> sums;
  for (const StudyRow* row : rows_with(rows, "as_coded", "navigation_time_s", is_tuning)) {
    if (row->method != method || !row->published || row->cell == "all") continue;
    for (const auto& [name, value] : row->params) {
      const double* number = std::get_if<double>(&value);
      if (name != parameter || number == nullptr) continue;
      Sums& sum = sums[*number];
      sum.here += row->measured;
      sum.there += *row->published;
      ++sum.count;
    }
  }
  if (sums.size() < 2) return "";

  std::vector<std::string> parts;
  int same_steps = 0;
  const Sums* before = nullptr;
  for (const auto& [value, sum] : sums) {
    parts.push_back(
        fmt::format("{:g}: {:.0f} s ({:.0f} s)", value, sum.here / sum.count, sum.there / sum.count));
    if (before != nullptr)
      same_steps += (sum.here / sum.count > before->here / before->count) ==
                            (sum.there / sum.count > before->there / before->count)
                        ? 1
                        : 0;
    before = &sum;
  }
  return fmt::format(
      "{}, mean navigation time by {}, in brackets published: {}; {} of {} steps go the same way.", method,
      parameter, list_of(parts), same_steps, sums.size() - 1);
}

// ---- the comparison -------------------------------------------------------------------------------

std::string within_15_percent(Rows rows) {
  std::vector<std::string> parts;
  for (const auto& [quantity, is_total] : published_quantities()) {
    if (is_total) continue;
    const std::string near = alike(
        rows_with(rows, "as_coded", quantity, [](const StudyRow& row) { return row.cell != "tuning"; }));
    if (!near.empty()) parts.push_back(fmt::format("{} {}", quantity, near));
  }
  if (parts.empty()) return "";
  return fmt::format(
      "Comparison as coded, one draw of five runs a cell, as published. Cells within 15 % of the published "
      "value: {}.",
      list_of(parts));
}

std::string covered(Rows rows, std::string_view mode) {
  std::vector<std::string> inside, near;
  int runs = 0;
  const auto summary = [&](const std::string& quantity) {
    return row_with(rows, mode, quantity, "all", "all");
  };
  for (const Quantity& published : published_quantities()) {
    const std::string_view quantity = published.name;
    if (const StudyRow* row = summary(fmt::format("{}_covered_count", quantity))) {
      inside.push_back(fmt::format("{} {:.0f}", quantity, row->measured));
      runs = row->runs;
    }
    if (const StudyRow* row = summary(fmt::format("{}_within_15_percent_count", quantity)))
      near.push_back(fmt::format("{} {:.1f} [{:.0f}, {:.0f}]", quantity, row->measured, row->low, row->high));
  }
  if (inside.empty()) return "";
  return fmt::format(
      "The published experiment, five runs a cell, drawn again and again from {} runs a cell ({}). Of the "
      "published values, those within the middle 95 % of the repetitions: {}. Cells of a repetition within "
      "15 % of the published value, mean and middle 95 %: {}.",
      runs, mode, list_of(inside), list_of(near));
}

std::string scatter(Rows rows, std::string_view mode) {
  int less = 0, more = 0, all = 0;
  for (const StudyRow* row : rows_with(rows, mode, "navigation_time_deviation_s")) {
    if (!row->place_ratio || row->cell == "all") continue;
    ++all;
    less += *row->published < row->low ? 1 : 0;
    more += *row->published > row->high ? 1 : 0;
  }
  if (all == 0) return "";
  return fmt::format(
      "From run to run the published navigation times scatter less than the middle 95 % of the repetitions "
      "({}) do in {} of {} cells, more in {}.",
      mode, less, all, more);
}

/// "2 of 5 published, 11 of 1000 here, p = 0.0012: not reproduced", over all cells of the method: those in
/// which collisions were published were chosen by what came out.
std::string collisions(Rows rows, std::string_view mode, std::string_view method) {
  std::size_t there = 0, published = 0, here = 0, runs = 0;
  std::vector<std::string> cells;
  for (const StudyRow* row : rows_with(rows, mode, "colliding_run_ratio")) {
    if (row->method != method || !row->published || row->cell == "all") continue;
    there += static_cast<std::size_t>(std::lround(published_runs * *row->published));
    published += published_runs;
    here += static_cast<std::size_t>(std::lround(row->measured * row->runs));
    runs += static_cast<std::size_t>(row->runs);
    cells.push_back(row->cell);
  }
  if (runs == 0) return "";
  const double p = fisher_exact(there, published, here, runs);
  return fmt::format(
      "Collisions of {} as coded ({}) in {}: {} of {} published runs, {} of {} here, Fisher's p = {:.2g}: "
      "{}.",
      method, mode, fmt::join(cells, " and "), there, published, here, runs, p,
      p < significant ? "not reproduced" : "no difference shown");
}

// ---- why ------------------------------------------------------------------------------------------

/// Runs with a collision, published and here, over several cells.
struct Collided {
  std::size_t there{}, published{}, here{}, runs{};

  /// `free` is the row of a cell's runs without one.
  void add(const StudyRow& free) {
    const PublishedCell* cell = published_cell(free.cell, free.method);
    there += cell == nullptr ? 0U : static_cast<std::size_t>(cell->colliding_run_count);
    published += published_runs;
    here += static_cast<std::size_t>(std::lround((1.0 - free.measured) * free.runs));
    runs += static_cast<std::size_t>(free.runs);
  }
  std::string text() const {
    return fmt::format("{} of {} (published {} of {}, p = {:.2g})", here, runs, there, published,
                       fisher_exact(there, published, here, runs));
  }
};

std::string printed_equations(Rows rows) {
  Collided all;
  for (const StudyRow* row : rows_with(rows, "corrected", "collision_free_ratio")) {
    if (row->method == "apf") all.add(*row);
  }
  if (all.runs == 0) return "";
  return fmt::format(
      "With the printed equations, where repulsion is summed afresh at every step, APF collides in {} of {} "
      "runs; published, in {} of {}.",
      all.here, all.runs, all.there, all.published);
}

std::string north(Rows rows) {
  std::vector<std::string> parts;
  for (const StudyRow* row : rows_with(rows, "as_coded_north", "navigation_time_s")) {
    const StudyRow* drawn = row_with(rows, "as_coded", "navigation_time_s", row->cell, row->method);
    if (drawn == nullptr || !drawn->deviation_ratio() || !row->deviation_ratio()) continue;
    parts.push_back(fmt::format("{} {} {:+.0f} % ({:+.0f} %)", row->cell, row->method,
                                100 * *row->deviation_ratio(), 100 * *drawn->deviation_ratio()));
  }
  if (parts.empty()) return "";
  return fmt::format(
      "Navigation time against published with everyone heading north at the origin, in brackets with "
      "headings drawn: {}.",
      list_of(parts));
}

std::string text_of(const ParamValues& params) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : params) {
    const double* number = std::get_if<double>(&value);
    parts.push_back(number != nullptr ? fmt::format("{}={}", name, number_text(*number)) : name);
  }
  return list_of(parts);
}

/// One for each way of hearing: in how many runs potential fields collide, in the cells in which they did as
/// published and in the others.
void say_timing(std::vector<std::string>& text, Rows rows, std::string_view mode) {
  std::vector<std::string> heard;
  for (const StudyRow* row : rows_with(rows, mode, "collision_count")) {
    if (std::ranges::find(heard, text_of(row->params)) == heard.end()) heard.push_back(text_of(row->params));
  }
  for (const std::string& params : heard) {
    Collided colliding, others;
    for (const StudyRow* row : rows_with(rows, mode, "collision_count")) {
      const auto free = rows_with(rows, mode, "collision_free_ratio", [&](const StudyRow& share) {
        return share.cell == row->cell && share.params == row->params;
      });
      if (text_of(row->params) != params || free.empty() || !row->published) continue;
      (*row->published > 0.0 ? colliding : others).add(*free.front());
    }
    if (colliding.runs == 0 || others.runs == 0) continue;
    text.push_back(fmt::format(
        "{}, {}: runs of APF with a collision in the cases where they were published {}, in the others {}.",
        mode, params, colliding.text(), others.text()));
  }
}

// ---- clearance ------------------------------------------------------------------------------------

/// A method over all its cells of a mode and, if told, of what it was told.
std::string clearance(Rows rows, std::string_view mode, std::string_view method, std::optional<double> told) {
  const auto fits = [&](const StudyRow& row) {
    return row.method == method && row.cell != "tuning" &&
           (!told || (row.params.size() == 1 && row.params.front().second == ParamValue{*told}));
  };
  const auto share = [&](std::string_view quantity) {
    double kept = 0.0, runs = 0.0;
    for (const StudyRow* row : rows_with(rows, mode, quantity, fits)) {
      kept += row->measured * row->runs;
      runs += row->runs;
    }
    return std::pair{kept, runs};
  };
  const auto [clear_of_3, runs] = share("collision_free_ratio");
  const auto [clear_of_6, same_runs] = share("clear_of_6m_ratio");
  const auto least = rows_with(rows, mode, "min_separation_m", fits);
  if (least.empty() || runs == 0.0 || runs != same_runs) return "";
  double nearest = least.front()->measured;
  for (const StudyRow* row : least) nearest = math::fmin(nearest, row->measured);
  return fmt::format(
      "{} {}{}: of {:.0f} runs {:.0f} kept 3 m between centres and {:.0f} kept 6 m; least {:.2f} m.", mode,
      method, told ? fmt::format(", told {:g} m", *told) : "", runs, clear_of_3, clear_of_6, nearest);
}

constexpr std::array method_names{"apf", "orca3d", "apf+saw", "orca3d+saw"};

}  // namespace

std::vector<std::string> findings(Rows rows) {
  std::vector<std::string> text;
  say(text, within_15_percent(rows));
  for (const std::string_view mode : {"as_coded_replicas", "as_coded_starts"}) {
    say(text, covered(rows, mode));
    say(text, scatter(rows, mode));
    for (const std::string_view method : {"apf", "orca3d"}) say(text, collisions(rows, mode, method));
  }
  say(text, tuning_totals(rows));
  say(text, tuning_times(rows));
  for (const std::string_view parameter : {"crit_dist_m", "ori_error_rad", "w2_ratio"})
    say(text, trend(rows, "apf", parameter));
  for (const std::string_view parameter : {"crit_dist_m", "ori_error_rad", "time_step_s", "time_horizon_s"})
    say(text, trend(rows, "orca3d", parameter));
  return text;
}

std::vector<std::string> causes(Rows rows) {
  std::vector<std::string> text;
  say(text, printed_equations(rows));
  say(text, north(rows));
  for (const std::string_view mode : {"as_coded_timing", "as_coded_starts_timing"})
    say_timing(text, rows, mode);
  return text;
}

std::vector<std::string> clearances(Rows rows) {
  std::vector<std::string> text;
  for (const std::string_view method : method_names) {
    say(text, clearance(rows, "corrected", method, std::nullopt));
    for (const double told : {3.0, 6.0}) say(text, clearance(rows, "corrected_told", method, told));
  }
  return text;
}

}  // namespace fairway::cubes
