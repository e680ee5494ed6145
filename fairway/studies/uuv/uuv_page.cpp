// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/uuv_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/uuv/figures.hpp"

namespace fairway::uuv {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 5> drawn_methods{"rvo", "vo", "hrvo", "orca2d", "apf"};

json published_section(const Results& results, const RunIndex& runs) {
  const std::span<const StudyRow> rows = results.published_rows;
  const auto judged = rows_where(rows, [](const StudyRow& row) { return row.published.has_value(); });
  const auto others = rows_where(rows, [](const StudyRow& row) { return !row.published; });
  return page::section(
      "published", "Published against measured",
      {"Moments are means over both UUVs; the note has each. A setting is named and then what sails: the "
       "point that goes any way at once, or a unicycle that turns at up to 1 rad/s."},
      {page::note("info",
                  "The paper gives no radius, time step, acceleration or horizon, and its head-on times fit "
                  "no constant speed: settings that come near its times stand in. Its second encounter names "
                  "no goals: crossing ones are adopted, since with parallel ones nobody needs to brake."),
       page::comparison_table("RVO, as the paper has it", judged, runs),
       page::comparison_table("All that was measured of single encounters", others, runs)});
}

json figures_section(const StudyOptions& options, const RunIndex& runs) {
  std::vector<json> blocks;
  const auto draw = [&](Encounter encounter, std::string_view setting, const std::string& title) {
    for (json& block : redrawn(encounter, find_setting(setting), title, options.overrides, runs))
      blocks.push_back(std::move(block));
  };
  draw(Encounter::head_on, "fit_head_on", "Figure 4: head-on, the setting that fits its times");
  draw(Encounter::multi_obstacle, "fit_ships", "Figure 5: three ships cross, goals as adopted");
  draw(Encounter::parallel_goals, "fit_ships", "Figure 5 with parallel goals");
  blocks.push_back(ways_of(Encounter::head_on, drawn_methods, "Head-on: UUV1 under other methods",
                           options.overrides, runs));
  blocks.push_back(ways_of(Encounter::multi_obstacle, drawn_methods, "Three ships: UUV1 under other methods",
                           options.overrides, runs));
  return page::section("figures", "Figures 4 and 5 redrawn",
                       {"Spheres are where everyone is at the times that the paper's text names."},
                       std::move(blocks));
}

json variations_section(const Results& results, const RunIndex& runs) {
  const std::vector<std::string> places{std::string(name_of(Encounter::head_on)),
                                        std::string(name_of(Encounter::multi_obstacle))};
  const auto bars = [&](const char* quantity, const char* label) {
    return page::method_intervals(results.varied_rows, planar_methods(), quantity, label, places, runs);
  };
  return page::section(
      "variations", "Every method on variations of both encounters",
      {fmt::format(
          "{} variations of each, the same for every method: starts and ships by up to 2 m, each UUV up to 1 "
          "s late, the ships' speed by 10 % and course by 0.1 rad. Bars are 95 % intervals.",
          results.seeds)},
      {page::grid(2, {bars("contact_ratio", "runs with a contact"),
                      bars("arrived_ratio", "runs in which both arrived"),
                      bars("arrive_time_s", "arrival of UUV1 [s]"),
                      bars("keeps_right_ratio", "runs in which both kept right")}),
       page::comparison_table("Both encounters, all methods", results.varied_rows, runs)});
}

json gatherings_section(const Results& results, const RunIndex& runs) {
  std::vector<std::string> places;
  for (const Gathering& gathering : gatherings()) places.push_back(gathering.name());
  std::vector<json> blocks;
  for (const Awareness& awareness : awarenesses()) {
    const auto rows = rows_in_mode(results.gathering_rows, awareness.name);
    const auto bars = [&](const char* quantity, const char* label) {
      return page::method_intervals(rows, gathering_methods(), quantity,
                                    fmt::format("{}, {}", awareness.name, label), places, runs);
    };
    blocks.push_back(page::grid(2, {bars("collision_ratio", "runs with a collision"),
                                    bars("deadlock_ratio", "runs in which somebody did not arrive"),
                                    bars("time_ratio", "time to the straight way's"),
                                    bars("mean_course_change_rad", "changes of course in all [rad]")}));
  }
  blocks.push_back(page::comparison_table("All gatherings", results.gathering_rows, runs));
  return page::section(
      "gatherings", "Up to fifty",
      {"Swaps across a circle, two columns that cross, and crowds in a square: everyone at 1 m/s, keeping "
       "spheres of 1 m clear, bodies of 0.75 m that collide. Awareness is perception and exchange: "
       "\"sonar+none\" sees and is told nothing, \"perfect+acoustic\" knows others by their messages alone."},
      std::move(blocks));
}

/// Runs with a collision over update rates, a series for each method.
json silence_chart(const Results& results, std::string_view cube, double loss, const RunIndex& runs) {
  json series = json::array();
  std::vector<std::string> categories;
  for (const double rate : update_rates_hz) categories.push_back(fmt::format("{} Hz", rate));
  for (const Method& method : silence_methods()) {
    json points = json::array();
    for (const double rate : update_rates_hz) {
      const Cell& cell =
          find_cell(results.silence, cube, method.name, Channel{Channel::Kind::acoustic, rate, loss}.name());
      const RateEstimate share = wilson_interval(collision_runs(cell), cell.results.size());
      points.push_back(runs.mark({{"value", share.rate}, {"low", share.low}, {"high", share.high}},
                                 cell.labels(), "pair_collision_count"));
    }
    series.push_back({{"label", method.name}, {"points", points}});
  }
  json chart = page::intervals(fmt::format("{}, {:.0f} % of messages lost", cube, 100.0 * loss),
                               "runs with a collision", categories, std::move(series));
  chart["category_label"] = "update rate";
  return chart;
}

json silence_section(const Results& results, const RunIndex& runs) {
  std::vector<json> blocks;
  for (const std::string_view cube : silent_cubes()) {
    std::vector<json> charts;
    for (const double loss : loss_ratios) charts.push_back(silence_chart(results, cube, loss, runs));
    blocks.push_back(page::grid(2, std::move(charts)));
  }
  const auto shown = rows_where(results.silence_rows, [](const StudyRow& row) { return row.params.empty(); });
  blocks.push_back(page::comparison_table("Perfect exchange, the modem, and the limits", shown, runs));
  return page::section("silence", "The cubes with less and less to hear", silence_sentences(results.silence),
                       std::move(blocks));
}

json facts(const Results& results) {
  const std::span<const StudyRow> rows = results.published_rows;
  return {page::fact("Reproduced, assuming", rows, Verdict::reproduced_assuming),
          page::fact("Partly", rows, Verdict::partly),
          page::fact("Not reproduced", rows, Verdict::not_reproduced)};
}

}  // namespace

json page_of(const Results& results, const StudyOptions& options) {
  const RunIndex runs{options,
                      {&results.published, &results.variations, &results.gatherings, &results.silence}};
  json sections = json::array({published_section(results, runs), figures_section(options, runs)});
  if (results.seeds > 0) {
    sections.push_back(variations_section(results, runs));
    sections.push_back(gatherings_section(results, runs));
    sections.push_back(silence_section(results, runs));
  }
  return page::document("UUVs that meet, and what they know of each other",
                        "cao2022: velocity obstacles head-on and among ships; then every method, up to fifty "
                        "vehicles, sonar and acoustic messages",
                        options.command, facts(results), runs.list(), std::move(sections));
}

}  // namespace fairway::uuv
