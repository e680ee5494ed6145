// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/surface_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/surface/figures.hpp"
#include "fairway/studies/surface/scales.hpp"
#include "fairway/studies/surface/zones.hpp"

namespace fairway::surface {
namespace {

using nlohmann::json;

constexpr std::array figure_methods{"avoa", "avoa_improved", "teb_0.4", "teb_1.5"};

json published_section(const Results& results, const RunIndex& runs) {
  const std::span rows = std::span{results.rows}.first(results.published_rows);
  const auto sailed_by = [&](Vessel vessel) { return rows_in_mode(rows, name_of(vessel)); };
  return page::section(
      "published", "Published against measured", claims(results.published),
      {page::note(
           "info",
           "The paper shows its five courses in figures without a scale, which are not at hand. The courses "
           "here are proposals that fit its text, its times and its speeds; two more U-shaped walls "
           "(u_narrow, u_deep) are not published. So what agrees is reproduced under that assumption."),
       page::comparison_table("Zarco in the waves of Table I, eight seeds each", sailed_by(Vessel::zarco),
                              runs),
       page::comparison_table("A vessel that does at once what it is told, in calm water",
                              sailed_by(Vessel::at_once), runs)});
}

/// The chosen methods on every course, each made once.
std::vector<std::vector<Passage>> passages(const Overrides& overrides, const RunIndex& runs) {
  std::vector<std::vector<Passage>> all;
  for (const Course course : courses) {
    std::vector<Passage>& of_course = all.emplace_back();
    for (const std::string_view name : figure_methods) {
      const auto method = std::ranges::find(compared_methods(), name, &Method::name);
      of_course.push_back(passage_of(course, *method, overrides, runs));
    }
  }
  return all;
}

json figures_section(const std::vector<std::vector<Passage>>& passages) {
  const auto of = [&](Course course) -> const std::vector<Passage>& {
    return passages[static_cast<std::size_t>(course)];
  };
  const auto speeds = [&](Course course) {
    return page::grid(2, {of(course)[0].speeds, of(course)[2].speeds});
  };
  return page::section(
      "figures", "Figures 8, 9 and 11 to 13 redrawn",
      {"Seen from above; the first seed. TEB with its package's limit of 0.4 m/s and with the paper's 1.5 "
       "m/s, both with dynamic obstacles left out, as its default is."},
      {ways("Figures 8a, 8b: the U-shaped wall", Course::u_wall, of(Course::u_wall)),
       ways("Figures 8c, 8d: the cluttered course", Course::cluttered, of(Course::cluttered)),
       speeds(Course::cluttered), ways("Figures 11a, 11b: scenario A", Course::head_on, of(Course::head_on)),
       ways("Figures 11c, 11d: scenario B", Course::orthogonal, of(Course::orthogonal)),
       speeds(Course::orthogonal),
       ways("Figures 11e, 11f: scenario C", Course::diagonal, of(Course::diagonal)), speeds(Course::diagonal),
       ways("A narrow U", Course::u_narrow, of(Course::u_narrow)),
       ways("A deep U", Course::u_deep, of(Course::u_deep))});
}

json zones_section() {
  return page::section("zones", "Figures 3 to 6 redrawn: protective zones",
                       {"Velocities in the vessel's frame, ahead to the right. Hue is the heading and "
                        "saturation the speed; black is forbidden. The cost of danger runs from white, far "
                        "from every zone, to dark grey at its edge; the metric is the lighter the better."},
                       zone_figures());
}

json decision_times_section(const std::vector<std::vector<Passage>>& passages) {
  json lines = json::array();
  for (std::size_t c = 0; c < courses.size(); ++c) {
    for (const Passage& passage : passages[c]) {
      json line{{"case", name_of(courses[c])},
                {"method", passage.label},
                {"mean", passage.mean_decision_us},
                {"worst", passage.worst_decision_us}};
      if (passage.track.contains("runs")) line["$runs"] = passage.track["runs"];
      lines.push_back(std::move(line));
    }
  }
  const auto column = [](const char* key, const char* label, const char* type) {
    return json{{"key", key}, {"label", label}, {"type", type}, {"digits", 0}};
  };
  return page::section("decision_times", "Decision times",
                       {"Of the passages in the figures, on the machine that wrote this report; not a result "
                        "that another machine gives."},
                       {{{"kind", "table"},
                         {"title", "Time of a decision [us]"},
                         {"columns",
                          {column("case", "Course", "text"), column("method", "Method", "text"),
                           column("mean", "Mean", "number"), column("worst", "Worst", "number")}},
                         {"rows", std::move(lines)},
                         {"filter", {"case", "method"}}}});
}

json variations_section(const Results& results, const RunIndex& runs) {
  const std::span rows = std::span{results.rows}.subspan(results.published_rows, results.varied_rows);
  std::vector<std::string> places;
  for (const Course course : courses) places.emplace_back(name_of(course));
  std::vector<std::string> paragraphs{
      fmt::format("{} variations of each course, the same for every method: start by up to 1 m and 0.3 rad, "
                  "buoys by 0.3 m, the other vessel by 1 m, 20 % of its speed and 0.2 rad, in a JONSWAP sea "
                  "of up to 0.3 m and a current of up to 0.2 m/s from anywhere. Bars are 95 % intervals, of "
                  "AVOA and TEB; the table has every method. Times are of the runs that arrived within 90 s.",
                  results.seeds)};
  std::ranges::move(ablation(results.variations), std::back_inserter(paragraphs));
  const auto bars = [&](const char* quantity, const char* label) {
    return page::method_intervals(rows, compared_methods(), quantity, label, places, runs);
  };
  return page::section("variations", "Variations of the courses", std::move(paragraphs),
                       {page::grid(2, {bars("success_ratio", "arrived, nothing touched"),
                                       bars("touched_ratio", "touched something"),
                                       bars("navigation_time_s", "time of arrival [s]"),
                                       bars("heading_change_rad", "turned in all [rad]")}),
                        page::comparison_table("All courses, all methods", rows, runs)});
}

/// Of the published part alone, a row for each number, method, setting and vessel that it is set beside.
json facts(const Results& results) {
  const auto rows = rows_where(std::span{results.rows}.first(results.published_rows),
                               [](const StudyRow& row) { return row.published.has_value(); });
  return {page::fact("Rows with a printed number", std::to_string(rows.size())),
          page::fact("Reproduced, assuming", rows, Verdict::reproduced_assuming),
          page::fact("Partly", rows, Verdict::partly),
          page::fact("Not reproduced", rows, Verdict::not_reproduced)};
}

}  // namespace

json page_of(const Results& results, const StudyOptions& options) {
  const RunIndex runs{options, {&results.published, &results.variations, &results.scales}};
  const std::vector<std::vector<Passage>> shown = passages(options.overrides, runs);
  json sections = json::array({published_section(results, runs), figures_section(shown), zones_section()});
  if (results.seeds > 0) {
    sections.push_back(page::section("scales", "Where the printed times can come from",
                                     scale_findings(results.scales), {scale_table(results.scales, runs)}));
    sections.push_back(variations_section(results, runs));
  }
  sections.push_back(decision_times_section(shown));
  return page::document(
      "A surface vessel among buoys and vessels",
      "campos2019: AVOA and TEB on five courses; then improved, varied, and beside every other method",
      options.command, facts(results), runs.list(), std::move(sections));
}

}  // namespace fairway::surface
