// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fairway/core/csv_field.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

using nlohmann::json;

json number(double value) { return std::isfinite(value) ? json(value) : json(); }

std::string cell_text(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

std::string safe_text(const ExamCell& cell) {
  return fmt::format("{} of {} runs without a collision", cell.safe_count(), cell.runs.size());
}

std::string time_text(const ExamCell& cell) {
  const double ratio = cell.time_ratio();
  return std::isfinite(ratio) ? fmt::format("{:.2f} of the time alone", ratio) : "nobody arrived in full";
}

/// Who is ahead, where somebody is shown to be behind.
void add_leaders(std::vector<std::string>& texts, const Contest& contest) {
  constexpr std::size_t most_names = 4;
  std::vector<std::string> ahead;
  for (const Placing& placing : contest.placings)
    if (placing.place == Place::shared) ahead.push_back(placing.cell->name());
  const std::size_t entrants = contest.placings.size();
  if (ahead.empty() || ahead.size() == entrants || ahead.size() > most_names) return;
  std::string names = ahead.front();
  for (std::size_t i = 1; i < ahead.size(); ++i) names += (i + 1 == ahead.size() ? " and " : ", ") + ahead[i];
  texts.push_back(fmt::format("{}, {}: {} {}; the other {} of {} are shown to be behind.", contest.family,
                              contest.condition, names, ahead.size() == 1 ? "leads" : "are not told apart",
                              entrants - ahead.size(), entrants));
}

/// Who is first, where that is shown.
void add_leader(std::vector<std::string>& texts, const Contest& contest) {
  const Placing& first = contest.placings.front();
  if (first.place != Place::first) return;
  const ExamCell& next = *contest.placings[1].cell;
  texts.push_back(fmt::format("{}, {}: {} is first of {}: {}, {}; next is {}: {}, {}.", contest.family,
                              contest.condition, first.cell->name(), contest.placings.size(),
                              safe_text(*first.cell), time_text(*first.cell), next.name(), safe_text(next),
                              time_text(next)));
}

/// Whoever stayed free of collisions alone, where everyone else is shown to be less safe.
void add_only_safe(std::vector<std::string>& texts, const Contest& contest) {
  const Placing& first = contest.placings.front();
  const bool all_less_safe =
      contest.placings.size() > 1 &&
      std::all_of(contest.placings.begin() + 1, contest.placings.end(), [](const Placing& other) {
        return other.place == Place::behind && other.behind_in == "safety";
      });
  if (!all_less_safe || first.cell->safe_count() != first.cell->runs.size()) return;
  texts.push_back(fmt::format("{}, {}: {} is the only one of {} that touched nobody in any of {} runs.",
                              contest.family, contest.condition, first.cell->name(), contest.placings.size(),
                              first.cell->runs.size()));
}

/// What a condition costs, where that is shown.
void add_cost(std::vector<std::string>& texts, const Awareness& awareness, const std::string& usual) {
  if (!(awareness.p_adjusted < exam_significance) || awareness.safety.pairs == 0) return;
  const double change = 100.0 * awareness.safety.difference;
  texts.push_back(fmt::format(
      "{}{} under {}: {:.0f} in 100 runs {} without a collision than under {} ({:.0f} to {:.0f}; {} pairs).",
      awareness.method, awareness.tuned ? ", tuned" : "", awareness.condition, std::fabs(change),
      change < 0.0 ? "fewer" : "more", usual,
      100.0 * (change < 0.0 ? -awareness.safety.high : awareness.safety.low),
      100.0 * (change < 0.0 ? -awareness.safety.low : awareness.safety.high), awareness.safety.pairs));
}

json placing_json(const Contest& contest, const Placing& placing) {
  return {{"family", contest.family},
          {"condition", contest.condition},
          {"method", placing.cell->method},
          {"tuned", placing.cell->tuned},
          {"place", name_of(placing.place)},
          {"behind_in", placing.behind_in.empty() ? json() : json(placing.behind_in)},
          {"p_adjusted", contest.placings.size() > 1 ? number(placing.p_adjusted) : json()},
          {"mean_rank", contest.placings.size() > 1 ? number(placing.mean_rank) : json()},
          {"on_front", placing.on_front}};
}

/// As text of LaTeX, whatever is in a name.
std::string escaped(std::string_view text) {
  std::string latex;
  for (const char c : text) {
    if (c == '\\')
      latex += "\\textbackslash{}";
    else if (c == '~')
      latex += "\\textasciitilde{}";
    else if (c == '^')
      latex += "\\textasciicircum{}";
    else
      latex +=
          (std::string_view{"&%$#_{}"}.find(c) != std::string_view::npos ? "\\" : "") + std::string(1, c);
  }
  return latex;
}

}  // namespace

std::vector<std::string> findings(const ExamTable& table) {
  std::vector<std::string> texts;
  for (const Contest& contest : table.contests) {
    add_leader(texts, contest);
    add_leaders(texts, contest);
    add_only_safe(texts, contest);
  }
  for (const Awareness& awareness : table.awareness) add_cost(texts, awareness, table.conditions.front());
  return texts;
}

json to_json(const ExamTable& table, const std::vector<Absence>& absences) {
  json document{{"fairway_exam_result", 1},  {"results_epoch", results_epoch}, {"rows", json::array()},
                {"placings", json::array()}, {"contests", json::array()},      {"awareness", json::array()},
                {"absent", json::array()},   {"findings", findings(table)},    {"tests", table.tests}};
  for (const ExamRow& row : table.rows)
    document["rows"].push_back({{"family", row.family},
                                {"condition", row.condition},
                                {"method", row.method},
                                {"tuned", row.tuned},
                                {"quantity", row.quantity},
                                {"mean", number(row.mean)},
                                {"low", number(row.low)},
                                {"high", number(row.high)},
                                {"runs", row.runs}});
  for (const Contest& contest : table.contests) {
    document["contests"].push_back({{"family", contest.family},
                                    {"condition", contest.condition},
                                    {"entrants", contest.placings.size()},
                                    {"seeds", contest.seeds},
                                    {"friedman_p", number(contest.friedman_p)},
                                    {"critical_difference", number(contest.critical_difference)}});
    for (const Placing& placing : contest.placings)
      document["placings"].push_back(placing_json(contest, placing));
  }
  for (const Awareness& each : table.awareness)
    document["awareness"].push_back({{"method", each.method},
                                     {"tuned", each.tuned},
                                     {"condition", each.condition},
                                     {"pairs", each.safety.pairs},
                                     {"collision_free_difference", number(each.safety.difference)},
                                     {"low", number(each.safety.low)},
                                     {"high", number(each.safety.high)},
                                     {"p_adjusted", number(each.p_adjusted)},
                                     {"time_change_ratio", number(each.time_ratio.mean)},
                                     {"time_low", number(each.time_ratio.low)},
                                     {"time_high", number(each.time_ratio.high)}});
  for (const Absence& absence : absences)
    document["absent"].push_back({{"family", absence.family},
                                  {"condition", absence.condition.empty() ? json() : json(absence.condition)},
                                  {"method", absence.method.empty() ? json() : json(absence.method)},
                                  {"tuned", absence.tuned},
                                  {"why", absence.why}});
  return document;
}

std::string rows_csv(const ExamTable& table) {
  std::string text{exam_rows_file.holds};
  for (const ExamRow& row : table.rows)
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_field(row.family), csv_field(row.condition),
                        csv_field(row.method), row.tuned, row.quantity, cell_text(row.mean),
                        cell_text(row.low), cell_text(row.high), row.runs);
  return text;
}

std::string latex_of(const ExamTable& table) {
  std::string text{exam_latex.begins};
  text += fmt::format(" {}, results epoch {}\n", fairway_version, results_epoch) +
          "% needs booktabs and longtable\n\\begin{longtable}{lllrrrl}\n\\toprule\n"
          "family & condition & method & safe & runs & time & place \\\\\n\\midrule\n\\endhead\n";
  for (const Contest& contest : table.contests) {
    for (const Placing& placing : contest.placings) {
      const double time = placing.cell->time_ratio();
      text += fmt::format("{} & {} & {} & {} & {} & {} & {} \\\\\n", escaped(contest.family),
                          escaped(contest.condition), escaped(placing.cell->name()),
                          placing.cell->safe_count(), placing.cell->runs.size(),
                          std::isfinite(time) ? fmt::format("{:.2f}", time) : "--", name_of(placing.place));
    }
    text += "\\addlinespace\n";
  }
  return text + "\\bottomrule\n\\end{longtable}\n";
}

std::string table_text(const ExamTable& table, const std::vector<Absence>& absences) {
  std::string text = fmt::format("{:<12} {:<17} {:<30} {:>9} {:>8} {:>6} {:>6} {:>6}  {}\n", "family",
                                 "condition", "method", "safe", "arrived", "time", "energy", "rank", "place");
  const auto ratio = [](double value) { return std::isfinite(value) ? fmt::format("{:.2f}", value) : "-"; };
  for (const Contest& contest : table.contests) {
    for (const Placing& placing : contest.placings) {
      const ExamCell& cell = *placing.cell;
      std::vector<double> energy = cell.ratios(&ExamOutcome::energy_j);
      std::erase_if(energy, [](double value) { return !std::isfinite(value); });
      text += fmt::format("{:<12} {:<17} {:<30} {:>4} of {:<3}{:>7.2f} {:>6} {:>6} {:>6.2f}  {}{}\n",
                          contest.family, contest.condition, cell.name(), cell.safe_count(), cell.runs.size(),
                          cell.arrived(), ratio(cell.time_ratio()),
                          energy.empty() ? "-" : ratio(estimate_mean(energy).mean), placing.mean_rank,
                          name_of(placing.place),
                          placing.behind_in.empty() ? "" : " in " + std::string(placing.behind_in));
    }
  }
  std::vector<std::string> outsiders;
  for (const Absence& absence : absences)
    if (!absence.method.empty())
      outsiders.push_back(fmt::format("{}{}{}: {} {}", absence.family, absence.condition.empty() ? "" : ", ",
                                      absence.condition, absence.method, absence.why));
  for (const std::string& outsider : outsiders) text += outsider + "\n";
  const std::vector<std::string> found = findings(table);
  for (const std::string& sentence : found) text += sentence + "\n";
  if (found.empty()) text += "These runs show no difference that holds over the whole table.\n";
  text += fmt::format("Holm over {} tests, each p times half the number of entrants.\n", table.tests);
  return text;
}

}  // namespace fairway
