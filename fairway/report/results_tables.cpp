// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/results_tables.hpp"

#include <fmt/format.h>

#include "fairway/studies/page_blocks.hpp"

namespace fairway {
namespace {

using nlohmann::json;
using page::number;

json column(const char* key, std::string label, const char* type = "number") {
  return {{"key", key}, {"label", std::move(label)}, {"type", type}};
}

json column(const char* key, std::string label, int digits) {
  return {{"key", key}, {"label", std::move(label)}, {"type", "number"}, {"digits", digits}};
}

std::string from_text(const Comparison& comparison) {
  return fmt::format("{:.4g} % from", 100.0 * comparison.confidence);
}

/// The table with its first columns: cell, where there are several, candidate, and what is measured.
json table(const Comparison& comparison, const GroupNames& names, std::string title, const char* what,
           const char* what_label, std::vector<json> more, json rows) {
  json columns = json::array(), filter = json::array();
  if (names.several()) {
    columns.push_back(column("cell", names.label().empty() ? "cell" : names.label(), "text"));
    filter.push_back("cell");
  }
  columns.push_back(column("candidate", comparison.by, "text"));
  columns.push_back(column(what, what_label, "text"));
  filter.push_back("candidate");
  filter.push_back(what);
  for (json& one : more) columns.push_back(std::move(one));
  return {{"kind", "table"},
          {"title", std::move(title)},
          {"columns", std::move(columns)},
          {"rows", std::move(rows)},
          {"filter", std::move(filter)}};
}

void add_test(json& line, const ComparedTest& test) {
  line["p"] = test.result.p;
  line["p_adjusted"] = test.p_adjusted;
  line["effect"] = test.result.effect;
}

}  // namespace

json rates_table(const Comparison& comparison, const CellRuns& runs, const GroupNames& names) {
  json rows = json::array();
  for (const ComparedRate& rate : comparison.rates) {
    json line{{"cell", names.of(rate.group)},     {"candidate", rate.candidate}, {"rate", rate.name},
              {"value", number(rate.value.rate)}, {"low", rate.value.low},       {"high", rate.value.high},
              {"yes", rate.value.successes},      {"runs", rate.value.trials}};
    rows.push_back(runs.line(std::move(line), rate.group, rate.candidate, ""));
  }
  return table(comparison, names,
               fmt::format("Rates, with Wilson's {:.4g} % interval", 100.0 * comparison.confidence), "rate",
               "Rate",
               {column("yes", "Of them so"), column("runs", "Runs"), column("value", "Share", 3),
                column("low", "from", 3), column("high", "to", 3)},
               std::move(rows));
}

json means_table(const Comparison& comparison, const CellRuns& runs, const GroupNames& names) {
  json rows = json::array();
  for (const ComparedMean& mean : comparison.means) {
    json line{{"cell", names.of(mean.group)},
              {"candidate", mean.candidate},
              {"quantity", mean.quantity},
              {"runs", mean.value.count},
              {"left_out", mean.left_out},
              {"mean", number(mean.value.mean)},
              {"low", number(mean.value.low)},
              {"high", number(mean.value.high)},
              {"deviation", number(mean.value.deviation)},
              {"median", number(mean.median)}};
    rows.push_back(runs.line(std::move(line), mean.group, mean.candidate, mean.quantity));
  }
  json block = table(comparison, names, "Means over runs, with Student's t interval", "quantity", "Quantity",
                     {column("runs", "Runs"), column("left_out", "Left out"), column("mean", "Mean"),
                      column("low", from_text(comparison)), column("high", "to"),
                      column("deviation", "Deviation"), column("median", "Median")},
                     std::move(rows));
  block["note"] =
      "One run is one value: of a quantity of vehicles, their mean. Runs that failed or did not measure a "
      "quantity are left out. A time that was cut off has no mean here.";
  return block;
}

json censored_table(const Comparison& comparison, const CellRuns& runs, const GroupNames& names) {
  json rows = json::array();
  for (const ComparedMean& mean : comparison.means) {
    if (!mean.censored) continue;
    const CensoredTimes& c = *mean.censored;
    json line{{"cell", names.of(mean.group)},
              {"candidate", mean.candidate},
              {"quantity", mean.quantity},
              {"arrived", fmt::format("{} of {}", c.complete.successes, c.complete.trials)},
              {"median", number(c.median.median)},
              {"median_low", number(c.median.low)},
              {"median_high", number(c.median.high)},
              {"mean", c.restricted.mean},
              {"low", c.restricted.low},
              {"high", c.restricted.high},
              {"limit", c.limit}};
    rows.push_back(runs.line(std::move(line), mean.group, mean.candidate, mean.quantity));
  }
  json block =
      table(comparison, names, "Times that the end of the run cut off in some runs", "quantity", "Quantity",
            {column("arrived", "All arrived", "text"), column("median", "Median"),
             column("median_low", from_text(comparison)), column("median_high", "to"),
             column("mean", "Restricted mean"), column("low", from_text(comparison)), column("high", "to"),
             column("limit", "Counted up to")},
            std::move(rows));
  block["note"] =
      "Medians are Kaplan and Meier's; none is given where half of the runs were cut off before. The "
      "restricted "
      "mean counts each time up to the limit in the last column; its interval is Greenwood's.";
  return block;
}

json differences_table(const Comparison& comparison, const CellRuns& runs, const GroupNames& names) {
  json rows = json::array();
  for (const ComparedMean& mean : comparison.means) {
    if (!mean.test) continue;
    json line{{"cell", names.of(mean.group)},
              {"candidate", mean.candidate},
              {"quantity", mean.quantity},
              {"pairs", mean.difference.count},
              {"mean", number(mean.difference.mean)},
              {"low", number(mean.difference.low)},
              {"high", number(mean.difference.high)},
              {"median", number(mean.difference_median.median)},
              {"median_low", number(mean.difference_median.low)},
              {"median_high", number(mean.difference_median.high)}};
    add_test(line, *mean.test);
    rows.push_back(runs.line(std::move(line), mean.group, mean.candidate, mean.quantity));
  }
  for (const ComparedRate& rate : comparison.rates) {
    if (!rate.test) continue;
    json line{{"cell", names.of(rate.group)},
              {"candidate", rate.candidate},
              {"quantity", rate.name},
              {"pairs", rate.difference.pairs},
              {"mean", number(rate.difference.difference)},
              {"low", number(rate.difference.low)},
              {"high", number(rate.difference.high)},
              {"median", nullptr},
              {"median_low", nullptr},
              {"median_high", nullptr}};
    add_test(line, *rate.test);
    rows.push_back(runs.line(std::move(line), rate.group, rate.candidate, ""));
  }
  json block =
      table(comparison, names, "Differences from " + comparison.baseline + ", paired by seed", "quantity",
            "Quantity",
            {column("pairs", "Pairs"), column("mean", "Mean"), column("low", "from"), column("high", "to"),
             column("median", "Median"), column("median_low", "from"), column("median_high", "to"),
             column("p", "p", "p"), column("p_adjusted", "p, Holm", "p"), column("effect", "Effect", 2)},
            std::move(rows));
  block["note"] = fmt::format(
      "Each less {}, with {:.4g} % intervals. p is adjusted by {}. The effect is the matched-pairs "
      "rank-biserial "
      "correlation of a quantity (-1 to 1) and Cohen's g of a rate (-0.5 to 0.5); positive where the value "
      "is larger "
      "than that of {}.",
      comparison.baseline, 100.0 * comparison.confidence, comparison.family, comparison.baseline);
  return block;
}

}  // namespace fairway
