// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/claim.hpp"

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
  if (row.quantity != "navigation_time_s") return "";
  if (row.method.starts_with("teb")) return "depends on the unpublished length of the course and TEB's limit";
  return course == Course::u_wall ? "the way out of the dead end depends on its unpublished size" : "";
}

void set_beside(StudyRow& row, Course course) {
  row.published = published(course, row.method, row.quantity);
  if (!row.published) return;
  judge(row, row.quantity.ends_with("_ratio"));
  if (row.verdict == Verdict::reproduced) row.verdict = Verdict::reproduced_assuming;
  const std::string_view known = note_on(row, course);
  row.note = known.empty() ? std::string(assumption) : fmt::format("{}; {}", assumption, known);
}

MeanEstimate mean_of(const Cell& cell, std::string_view quantity) {
  return estimate_mean(of_arrived(cell, quantity));
}

const Cell& sailed_with_zarco(const std::vector<Cell>& cells, Course course, std::string_view method) {
  return find_cell(cells, name_of(course), method, name_of(Vessel::zarco));
}

MeanEstimate half(MeanEstimate estimate) {
  for (double* number : {&estimate.mean, &estimate.low, &estimate.high}) *number *= 0.5;
  return estimate;
}

constexpr std::array teb_names{"teb_0.4",         "teb_0.4_dynamic", "teb_1.5",
                               "teb_1.5_dynamic", "teb_0.4_planned", "teb_1.5_planned"};

/// "At least twice as effective": AVOA takes at most half of the time, course by course.
std::string twice_as_fast(const std::vector<Cell>& cells, std::string_view teb) {
  std::vector<std::string> parts;
  for (const Course course : {Course::cluttered, Course::orthogonal, Course::diagonal}) {
    const MeanEstimate ours = mean_of(sailed_with_zarco(cells, course, "avoa"), "navigation_time_s");
    const MeanEstimate theirs = mean_of(sailed_with_zarco(cells, course, teb), "navigation_time_s");
    const Standing standing = is_less(ours, half(theirs));
    std::string part = fmt::format("{} {}", name_of(course), name_of(standing));
    if (standing == Standing::reversed && is_less(ours, theirs) == Standing::holds)
      part = fmt::format("{} faster, but not twice", name_of(course));
    if (standing != Standing::not_measured)
      part += fmt::format(" ({:.1f} s against {:.1f} s)", ours.mean, theirs.mean);
    parts.push_back(std::move(part));
  }
  return fmt::format("\"At least two times more effective\" than TEB, against {}: {}.", teb,
                     fmt::join(parts, "; "));
}

/// "`quantity` is less" of AVOA than of TEB among the buoys.
std::string smoother(const std::vector<Cell>& cells, std::string_view teb, std::string_view quantity,
                     std::string_view what) {
  const MeanEstimate ours = mean_of(sailed_with_zarco(cells, Course::cluttered, "avoa"), quantity);
  const MeanEstimate theirs = mean_of(sailed_with_zarco(cells, Course::cluttered, teb), quantity);
  return stated(fmt::format("\"A smoother movement in comparison to TEB\", {}, against {}", what, teb),
                is_less(ours, theirs), fmt::format("{:.1f} against {:.1f}", ours.mean, theirs.mean));
}

bool did_not_arrive(const Cell& cell, std::size_t i) { return !arrived(cell, i); }

/// "In every run", of a method on a course.
std::string always(const std::vector<Cell>& cells, std::string_view claim, Course course,
                   std::string_view method, bool (*is)(const Cell&, std::size_t)) {
  const Cell& cell = sailed_with_zarco(cells, course, method);
  const std::size_t count = count_runs(cell, is), runs = cell.results.size();
  return stated(fmt::format("{}, {}", claim, method), all_are(count, runs),
                fmt::format("{} of {} runs", count, runs));
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
    const Cell& cell = sailed_with_zarco(published, course, "avoa");
    runs += cell.results.size();
    finished += count_runs(cell, succeeded);
  }
  std::vector<std::string> lines{
      "On the proposed courses of 25 m, Zarco in the waves of Table I:",
      stated("\"AVOA finishes all five courses without a collision\"", all_are(finished, runs),
             fmt::format("{} of {} runs", finished, runs))};
  for (const std::string_view teb : teb_names) {
    lines.push_back(twice_as_fast(published, teb));
    lines.push_back(
        always(published, "\"TEB became locked in the U-shaped wall\"", Course::u_wall, teb, did_not_arrive));
    lines.push_back(always(published, "\"TEB collides\" in A", Course::head_on, teb, touched));
    lines.push_back(smoother(published, teb, "heading_change_rad", "radians turned among the buoys"));
    lines.push_back(smoother(published, teb, "speed_change_mps", "m/s of speed changed among the buoys"));
  }
  return lines;
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
    if (runs == 0) continue;
    const RateEstimate success = wilson_interval(good, runs);
    lines.push_back(fmt::format(
        "{}: {} of {} variations of all courses arrived untouched ({:.1f} %, 95 % from {:.1f} "
        "to {:.1f}), {} touched something.",
        method, good, runs, 100.0 * success.rate, 100.0 * success.low, 100.0 * success.high, hits));
  }
  return lines;
}

}  // namespace fairway::surface
