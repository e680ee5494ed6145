// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/findings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fairway/experiment/statistics.hpp"

namespace fairway::surface {
namespace {

constexpr std::string_view assumption = "proposed course and settings";

constexpr std::array course_means{"navigation_time_s", "path_length_m", "heading_change_rad",
                                  "speed_change_mps"};

std::vector<StudyRow> outcome_rows(const Cell& cell) {
  std::vector<StudyRow> rows{
      share_row(cell, "success_ratio", count_runs(cell, succeeded),
                "arrived and touched nothing; Wilson's interval"),
      share_row(cell, "touched_ratio", count_runs(cell, touched), "touched something; Wilson's interval")};
  const double clearance = least(cell, "footprint_clearance_m");
  rows.push_back(cell_row(cell, "least_clearance_m", clearance, clearance, clearance,
                          "least distance of the vessel's disc from anything over all runs"));
  for (const std::string_view quantity : course_means) rows.push_back(mean_row(cell, quantity));
  return rows;
}

/// What is known of a number that comes out differently.
std::string_view note_on(const StudyRow& row, Course course) {
  if (row.method.starts_with("teb_1.5") && row.quantity == "navigation_time_s")
    return "the published times of TEB are those of its package's default limit, 0.4 m/s, not of the stated "
           "1.5";
  if (course == Course::u_wall && row.quantity == "navigation_time_s")
    return "the way out of the dead end depends on its unpublished size";
  return "";
}

void set_beside(StudyRow& row, Course course) {
  row.published = published(course, row.method, row.quantity);
  if (!row.published) return;
  judge(row, row.quantity.ends_with("_ratio"));
  if (row.verdict == Verdict::reproduced) row.verdict = Verdict::reproduced_assuming;
  const std::string_view known = note_on(row, course);
  row.note = known.empty() ? std::string(assumption) : fmt::format("{}; {}", assumption, known);
}

double mean_of(const Cell& cell, std::string_view quantity) {
  return estimate_mean(of_arrived(cell, quantity)).mean;
}

std::string times_against(const std::vector<Cell>& cells, std::string_view teb) {
  std::string text;
  for (const Course course : {Course::cluttered, Course::orthogonal, Course::diagonal}) {
    const double ours =
        mean_of(find_cell(cells, name_of(course), "avoa", name_of(Vessel::zarco)), "navigation_time_s");
    const double theirs =
        mean_of(find_cell(cells, name_of(course), teb, name_of(Vessel::zarco)), "navigation_time_s");
    text += fmt::format("{}{} {:.1f} s against {:.1f} s ({:+.0f} %)", text.empty() ? "" : ", ",
                        name_of(course), ours, theirs, 100.0 * (ours / theirs - 1.0));
  }
  return text;
}

std::string smoothness_of(const std::vector<Cell>& cells, std::string_view method) {
  const Cell& cell = find_cell(cells, name_of(Course::cluttered), method, name_of(Vessel::zarco));
  return fmt::format("{} turns by {:.1f} rad and changes its speed by {:.1f} m/s in all", method,
                     mean_of(cell, "heading_change_rad"), mean_of(cell, "speed_change_mps"));
}

}  // namespace

std::vector<StudyRow> published_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    const auto course = *std::ranges::find(courses, cell.place, [](Course c) { return name_of(c); });
    for (StudyRow& row : outcome_rows(cell)) {
      set_beside(row, course);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<StudyRow> varied_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) std::ranges::move(outcome_rows(cell), std::back_inserter(rows));
  return rows;
}

std::vector<std::string> claims(const std::vector<Cell>& published) {
  std::size_t runs = 0, finished = 0;
  for (const Course course :
       {Course::u_wall, Course::cluttered, Course::head_on, Course::orthogonal, Course::diagonal}) {
    const Cell& cell = find_cell(published, name_of(course), "avoa", name_of(Vessel::zarco));
    runs += cell.results.size();
    finished += count_runs(cell, succeeded);
  }
  return {
      fmt::format("\"AVOA finishes all five courses without a collision\": {} of {} runs did.", finished,
                  runs),
      fmt::format(
          "\"At least twice as effective as TEB\" (65, 58 and 69 % less time): with TEB's default limit of "
          "0.4 m/s, {}.",
          times_against(published, "teb_0.4")),
      fmt::format(
          "With both methods given the same 1.5 m/s, as the paper says they were: {}. What is left of the "
          "advantage is the method's.",
          times_against(published, "teb_1.5")),
      fmt::format("\"A smoother movement in comparison to TEB\", on the cluttered course: {}; {}; {}.",
                  smoothness_of(published, "avoa"), smoothness_of(published, "teb_0.4"),
                  smoothness_of(published, "teb_1.5")),
  };
}

std::vector<std::string> ablation(const std::vector<Cell>& variations) {
  std::vector<std::string> lines;
  for (const std::string_view method :
       {"avoa", "improved_neither", "improved_turn_only", "improved_memory_only", "avoa_improved"}) {
    std::size_t runs = 0, good = 0, hits = 0;
    for (const Cell& cell : variations) {
      if (cell.method != method) continue;
      runs += cell.results.size();
      good += count_runs(cell, succeeded);
      hits += count_runs(cell, touched);
    }
    const RateEstimate success = wilson_interval(good, runs);
    lines.push_back(fmt::format(
        "{}: {} of {} variations of all courses arrived untouched ({:.1f} %, 95 % from {:.1f} "
        "to {:.1f}), {} touched something.",
        method, good, runs, 100.0 * success.rate, 100.0 * success.low, 100.0 * success.high, hits));
  }
  return lines;
}

}  // namespace fairway::surface
