// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "fairway/exam/exam_page_tables.hpp"
#include "fairway/exam/exam_text.hpp"
#include "fairway/exam/worst_runs.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/run_list.hpp"

namespace fairway {
namespace {

using nlohmann::json;

constexpr auto clearance_label = "clearance left [m]";
constexpr auto time_label = "time over the time alone";

/// What the figure is called that shows how a quantity of a family is distributed.
std::string distribution_title(const std::string& family, std::string_view quantity) {
  return fmt::format("{}: {}", family, quantity);
}

/// The runs of every cell, one ground after the other, and where they stand in the document.
class PageRuns {
 public:
  PageRuns(const ExamTable& table, const PlaybackOf& playback) {
    for (const ExamCell& cell : table.cells) {
      std::vector<const ExamRun*> runs = cell.runs;
      std::ranges::stable_sort(runs, {}, [](const ExamRun* run) { return run->ground; });
      auto& places = places_[&cell];
      for (const ExamRun* run : runs) {
        const std::string label = fmt::format("{}, {}, {}", cell.name(), run->ground, cell.condition);
        const std::string page = playback ? playback(*run) : std::string{};
        places.push_back(list_.add(label, {.seed = run->seed, .command = run->command}, page));
        place_of_.emplace(run, places.back());
      }
      runs_[&cell] = std::move(runs);
    }
  }

  /// A mark that leads to the runs of a cell, each with the clearance that it left.
  json mark(json mark, const ExamCell& cell) const {
    std::vector<double> values;
    for (const ExamRun* run : runs_.at(&cell)) values.push_back(run->outcome.clearance_m);
    mark = page::linked(std::move(mark), page::references(places_.at(&cell)), page::shown_values(values));
    if (!mark.is_null()) mark["values_label"] = clearance_label;
    return mark;
  }

  /// What a row has as its runs that is of this one alone.
  json alone(const ExamRun& run) const { return json::array({place_of_.at(&run)}); }

  const page::RunList& list() const { return list_; }

 private:
  std::map<const ExamCell*, std::vector<std::size_t>> places_;
  std::map<const ExamCell*, std::vector<const ExamRun*>> runs_;
  std::map<const ExamRun*, std::size_t> place_of_;
  page::RunList list_;
};

const Contest* contest_of(const ExamTable& table, const std::string& family, const std::string& condition) {
  const auto found = std::ranges::find_if(table.contests, [&](const Contest& contest) {
    return contest.family == family && contest.condition == condition;
  });
  return found == table.contests.end() ? nullptr : &*found;
}

const Placing* placing_of(const Contest* contest, const std::string& name) {
  if (contest == nullptr) return nullptr;
  const auto found =
      std::ranges::find_if(contest->placings, [&](const Placing& p) { return p.cell->name() == name; });
  return found == contest->placings.end() ? nullptr : &*found;
}

/// Everyone who entered anything, in the order of the exam.
std::vector<std::string> names_of(const ExamTable& table) {
  std::vector<std::string> names;
  for (const ExamCell& cell : table.cells)
    if (!cell.is_baseline && std::ranges::find(names, cell.name()) == names.end())
      names.push_back(cell.name());
  return names;
}

std::string ratio_text(double value) { return std::isfinite(value) ? fmt::format("{:.2f}", value) : ""; }

std::string place_text(const Placing& placing) {
  switch (placing.place) {
    case Place::first:
      return "first: every other one is shown to be behind";
    case Place::shared:
      return "not told apart from whoever leads";
    case Place::alone:
      return "alone: nobody else may enter";
    case Place::behind:
      break;
  }
  return fmt::format("behind in {}, p {:.2g} over the table", placing.behind_in, placing.p_adjusted);
}

json heat_cell(const Placing& placing, const PageRuns& runs) {
  const ExamCell& cell = *placing.cell;
  const RateEstimate rate = wilson_interval(cell.safe_count(), cell.runs.size());
  const char* mark = placing.place == Place::first ? "①" : placing.place == Place::shared ? "=" : "";
  return runs.mark({{"value", rate.rate},
                    {"low", rate.low},
                    {"high", rate.high},
                    {"text", ratio_text(cell.time_ratio())},
                    {"mark", mark},
                    {"note", place_text(placing)}},
                   cell);
}

json heat_of(const ExamTable& table, const ExamCondition& condition, const PageRuns& runs) {
  json series = json::array(), families = json::array(), distributions = json::array();
  std::vector<const Contest*> contests;
  for (const std::string& family : table.families) {
    if (const Contest* contest = contest_of(table, family, condition.name)) {
      contests.push_back(contest);
      families.push_back(family);
      distributions.push_back(distribution_title(family, clearance_label));
    }
  }
  for (const std::string& name : names_of(table)) {
    json cells = json::array();
    for (const Contest* contest : contests) {
      const Placing* placing = placing_of(contest, name);
      cells.push_back(placing == nullptr ? json() : heat_cell(*placing, runs));
    }
    series.push_back({{"label", name}, {"cells", std::move(cells)}});
  }
  return {{"kind", "heat"},
          {"title", condition.name + ": " + condition.meaning},
          {"categories", std::move(families)},
          {"category_label", "family"},
          {"value_label", "runs without a collision"},
          {"text_label", time_label},
          {"unit", "%"},
          {"range", {0.0, 1.0}},
          {"see", std::move(distributions)},
          {"series", std::move(series)}};
}

json awareness_heat(const ExamTable& table) {
  json series = json::array(), conditions = json::array();
  for (std::size_t i = 1; i < table.conditions.size(); ++i) conditions.push_back(table.conditions[i]);
  std::map<std::string, std::map<std::string, const Awareness*>> found;
  std::vector<std::string> names;
  for (const Awareness& each : table.awareness) {
    const std::string name = each.tuned ? each.method + ", tuned" : each.method;
    if (!found.contains(name)) names.push_back(name);
    found[name][each.condition] = &each;
  }
  for (const std::string& name : names) {
    json cells = json::array();
    for (const json& condition : conditions) {
      const auto cell = found[name].find(condition.get<std::string>());
      if (cell == found[name].end()) {
        cells.push_back(nullptr);
        continue;
      }
      const Awareness& each = *cell->second;
      const bool shown = each.p_adjusted < exam_significance;
      cells.push_back(
          {{"value", each.safety.difference},
           {"low", each.safety.low},
           {"high", each.safety.high},
           {"text", fmt::format("{:+.0f} %", 100.0 * each.safety.difference)},
           {"mark", shown ? "!" : ""},
           {"note", fmt::format("p {:.2g} over all of these; {} pairs; time {:+.0f} %", each.p_adjusted,
                                each.safety.pairs, 100.0 * each.time_ratio.mean)}});
    }
    series.push_back({{"label", name}, {"cells", std::move(cells)}});
  }
  return {{"kind", "heat"},
          {"title", "Runs without a collision, less those under " + table.conditions.front()},
          {"categories", std::move(conditions)},
          {"category_label", "condition"},
          {"value_label", "difference"},
          {"text_label", "change"},
          {"unit", "%"},
          {"range", {-0.5, 0.5}},
          {"series", std::move(series)}};
}

/// Where each stands between safety and time.
json front_of(const Contest& contest) {
  json points = json::array(), front = json::array();
  for (const Placing& placing : contest.placings) {
    const double time = placing.cell->time_ratio();
    if (!std::isfinite(time)) continue;
    const double unsafe = 1.0 - static_cast<double>(placing.cell->safe_count()) /
                                    static_cast<double>(placing.cell->runs.size());
    points.push_back(page::series(placing.cell->name(), {100.0 * unsafe}, {time}));
    if (placing.on_front) front.push_back(placing.cell->name());
  }
  json chart = page::lines(contest.family, "runs with a collision [%]", time_label, std::move(points));
  chart["front"] = std::move(front);
  return chart;
}

json boxes_of(const ExamTable& table, const std::string& family, const PageRuns& runs, const char* title,
              const std::function<std::vector<double>(const ExamCell&)>& values) {
  json series = json::array();
  for (const std::string& name : names_of(table)) {
    json boxes = json::array();
    bool any = false;
    for (const std::string& condition : table.conditions) {
      const Placing* placing = placing_of(contest_of(table, family, condition), name);
      json& box = boxes.emplace_back();
      if (placing == nullptr) continue;
      std::vector<double> known = values(*placing->cell);
      std::erase_if(known, [](double value) { return !std::isfinite(value); });
      box = runs.mark(page::box(std::move(known)), *placing->cell);
      any = any || !box.is_null();
    }
    if (any) series.push_back({{"label", name}, {"boxes", std::move(boxes)}});
  }
  return {{"kind", "boxes"},
          {"title", distribution_title(family, title)},
          {"y_label", title},
          {"category_label", "condition"},
          {"categories", table.conditions},
          {"series", std::move(series)}};
}

json placings_table(const ExamTable& table, const ExamMargins& margins, const PageRuns& runs) {
  json rows = json::array();
  for (const Contest& contest : table.contests) {
    for (const Placing& placing : contest.placings) {
      const ExamCell& cell = *placing.cell;
      const RateEstimate safe = wilson_interval(cell.safe_count(), cell.runs.size());
      json row{{"family", contest.family},
               {"condition", contest.condition},
               {"method", cell.name()},
               {"safe", safe.rate},
               {"low", safe.low},
               {"high", safe.high},
               {"arrived", cell.arrived()},
               {"time", page::number(cell.time_ratio())},
               {"rank", placing.mean_rank},
               {"cd", contest.critical_difference},
               {"place", name_of(placing.place)},
               {"behind", placing.behind_in},
               {"p", placing.p_adjusted},
               {"runs", cell.runs.size()}};
      if (const auto adds = margins.find({contest.family, cell.name()}); adds != margins.end())
        row["adds"] = adds->second.empty() ? "" : "adds " + adds->second;
      const json link = runs.mark(json::object(), cell);
      row["$runs"] = link["runs"];
      row["$values"] = link["values"];
      row["$values_label"] = link["values_label"];
      rows.push_back(std::move(row));
    }
  }
  return {{"kind", "table"},
          {"title", "Every method on every ground"},
          {"columns",
           {column("family", "Family", "text"), column("condition", "Condition", "text"),
            column("method", "Method", "text"), column("safe", "Collision-free", "number", 3),
            column("low", "95 % from", "number", 3), column("high", "to", "number", 3),
            column("arrived", "Arrived", "number", 3), column("time", "Time over alone", "number", 2),
            column("rank", "Mean rank", "number", 2), column("cd", "Critical difference", "number", 2),
            column("place", "Place", "text"), column("behind", "Behind in", "text"), column("p", "p", "p"),
            column("runs", "Runs", "number", 0), column("adds", "Adds", "remark")}},
          {"rows", std::move(rows)},
          {"filter", {"family", "condition", "method", "place"}},
          {"note",
           "A row leads to its runs; beside each is the clearance that it left in metres, negative "
           "where something was touched. Adds: what a method keeps clear by itself beyond the radii that "
           "all are given."}};
}

}  // namespace

json exam_page(const ExamTable& table, const ExamPageParts& parts) {
  const PageRuns runs{table, parts.playback};
  json sections = json::array();
  std::vector<std::string> said = findings(table);
  if (said.empty()) said.emplace_back("These runs show no difference that holds over the whole table.");
  sections.push_back(page::section("findings", "Findings", std::move(said), {}));

  std::vector<json> heats;
  for (const ExamCondition& condition : parts.conditions) heats.push_back(heat_of(table, condition, runs));
  sections.push_back(page::section(
      "grounds", "Methods and grounds",
      {"The colour is the share of runs without a collision, the number the time over the time alone. ① is "
       "first on the evidence of these runs, = is not told apart from whoever leads. Grey: may not enter, or "
       "has not been run. No number: in no run did all arrive, in it and in the one alone. A click lists the "
       "runs, the least clearance first if asked, and leads to their distribution and, where there is one, "
       "to the playback of the worst."},
      std::move(heats)));
  if (!table.awareness.empty())
    sections.push_back(page::section("awareness", "What knowing less costs",
                                     {"Pairs of runs of one family and seed; ! marks what holds over all of "
                                      "these by Holm."},
                                     {awareness_heat(table)}));

  std::vector<json> fronts;
  for (const std::string& family : table.families)
    if (const Contest* contest = contest_of(table, family, table.conditions.front()))
      fronts.push_back(front_of(*contest));
  sections.push_back(page::section(
      "fronts", "Safety and time",
      {"Under " + table.conditions.front() +
       ". Of whoever stands ringed on the line, the front, nobody else is at least as safe and as fast, and "
       "better in one of them."},
      {page::grid(3, std::move(fronts))}));
  sections.push_back(
      page::section("worst", "Worst runs", {},
                    {worst_table(worst_runs(table), [&](const ExamRun& run) { return runs.alone(run); })}));

  std::vector<json> boxes;
  for (const std::string& family : table.families) {
    boxes.push_back(boxes_of(table, family, runs, time_label,
                             [](const ExamCell& cell) { return cell.ratios(&ExamOutcome::time_s); }));
    boxes.push_back(boxes_of(table, family, runs, clearance_label, [](const ExamCell& cell) {
      std::vector<double> values;
      for (const ExamRun* run : cell.runs) values.push_back(run->outcome.clearance_m);
      return values;
    }));
  }
  sections.push_back(page::section("distributions", "Distributions", {}, std::move(boxes)));
  sections.push_back(
      page::section("placings", "All placings", {}, {placings_table(table, parts.margins, runs)}));
  if (!parts.decision_times.empty())
    sections.push_back(page::section(
        "decisions", "Time to decide",
        {"By the clock of the machine that made this page: unlike all else here, it does not repeat."},
        {decisions_table(parts.decision_times)}));
  sections.push_back(page::section("families", "Families, and who may not enter", {},
                                   {families_table(parts.families), absences_table(parts.absences)}));
  std::vector<std::string> paragraphs = how();
  paragraphs.push_back(parts.origin);
  sections.push_back(page::section("how", "How this came about", std::move(paragraphs), {}));

  return page::document("The exam", "Every method on every ground, under the same seeds", parts.command,
                        {page::fact("Methods", std::to_string(names_of(table).size())),
                         page::fact("Families", std::to_string(table.families.size())),
                         page::fact("Conditions", std::to_string(table.conditions.size())),
                         page::fact("First on the evidence", std::to_string(std::ranges::count_if(
                                                                 table.contests,
                                                                 [](const Contest& contest) {
                                                                   return contest.placings.front().place ==
                                                                          Place::first;
                                                                 })))},
                        runs.list(), std::move(sections));
}

}  // namespace fairway
