// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/results_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fairway/core/error.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/report/methods_text.hpp"
#include "fairway/report/results_tables.hpp"
#include "fairway/studies/page_blocks.hpp"

namespace fairway {
namespace {

using nlohmann::json;

template <class T, class Name>
auto distinct(const std::vector<T>& items, Name name) {
  std::vector<std::decay_t<decltype(name(items.front()))>> names;
  for (const T& item : items) {
    if (std::ranges::find(names, name(item)) == names.end()) names.push_back(name(item));
  }
  return names;
}

std::vector<Labels> groups_of(const Comparison& comparison) {
  return distinct(comparison.cells, [](const ComparedCell& c) { return c.group; });
}

std::vector<std::string> candidates_of(const Comparison& comparison) {
  return distinct(comparison.cells, [](const ComparedCell& c) { return c.candidate; });
}

const ComparedMean* find(const Comparison& comparison, const Labels& group, const std::string& candidate,
                         const std::string& quantity) {
  const auto found = std::ranges::find_if(comparison.means, [&](const ComparedMean& m) {
    return m.candidate == candidate && m.quantity == quantity && m.group == group;
  });
  return found == comparison.means.end() ? nullptr : &*found;
}

/// A box of the runs of a cell, one value each, which leads to them. There is none of times that were cut
/// off.
json box_of(const CellRuns& runs, const ComparedMean* mean) {
  if (mean == nullptr || (mean->censored && mean->censored->cut > 0)) return nullptr;
  const std::vector<double> values = runs.values(mean->group, mean->candidate, mean->quantity);
  std::vector<double> finite;
  std::ranges::copy_if(values, std::back_inserter(finite), [](double value) { return std::isfinite(value); });
  return page::linked(page::box(std::move(finite)), page::references(runs.of(mean->group, mean->candidate)),
                      page::shown_values(values));
}

json boxes(const CellRuns& runs, const Comparison& comparison, const GroupNames& names,
           const std::string& quantity) {
  const std::vector<Labels> groups = groups_of(comparison);
  json categories = json::array(), series = json::array();
  for (const Labels& group : groups) categories.push_back(names.of(group));
  for (const std::string& candidate : candidates_of(comparison)) {
    json row = json::array();
    for (const Labels& group : groups)
      row.push_back(box_of(runs, find(comparison, group, candidate, quantity)));
    series.push_back({{"label", candidate}, {"boxes", row}});
  }
  return {{"kind", "boxes"},          {"title", quantity},
          {"y_label", quantity},      {"category_label", names.label()},
          {"categories", categories}, {"series", series}};
}

/// The share of runs that take longer, as steps over time up to where it is known, and often enough between
/// them to be read anywhere.
json curve_of(const ComparedMean& mean) {
  constexpr int parts = 60;
  const CensoredTimes& times = *mean.censored;
  std::vector<double> x, y;
  double share = 1.0;
  auto step = times.curve.begin();
  for (int part = 0; part <= parts; ++part) {
    const double time = part == parts ? times.limit : times.limit * part / parts;
    for (; step != times.curve.end() && step->time <= time; ++step) {
      x.insert(x.end(), {step->time, step->time});
      y.insert(y.end(), {share, step->share});
      share = step->share;
    }
    x.push_back(time);
    y.push_back(share);
  }
  return page::series(mean.candidate, x, y);
}

/// The curves of every group in which times were cut off.
std::vector<json> survival_curves(const Comparison& comparison, const GroupNames& names) {
  std::vector<json> charts;
  const auto quantities = distinct(comparison.means, [](const ComparedMean& m) { return m.quantity; });
  for (const Labels& group : groups_of(comparison)) {
    for (const std::string& quantity : quantities) {
      json curves = json::array();
      for (const std::string& candidate : candidates_of(comparison)) {
        const ComparedMean* mean = find(comparison, group, candidate, quantity);
        if (mean != nullptr && mean->censored) curves.push_back(curve_of(*mean));
      }
      if (curves.empty()) continue;
      charts.push_back(page::lines(names.several() ? quantity + ", " + names.of(group) : quantity, quantity,
                                   "share of runs that take longer", std::move(curves)));
    }
  }
  return charts;
}

std::vector<json> charts_of(const Comparison& comparison, const CellRuns& runs, const GroupNames& names) {
  std::vector<json> charts;
  for (const std::string& quantity :
       distinct(comparison.means, [](const ComparedMean& m) { return m.quantity; })) {
    json chart = boxes(runs, comparison, names, quantity);
    const bool any = std::ranges::any_of(chart["series"], [](const json& series) {
      return std::ranges::any_of(series["boxes"], [](const json& box) { return !box.is_null(); });
    });
    if (any) charts.push_back(std::move(chart));
  }
  return charts;
}

/// What the reader has to beware of; the methods say the rest.
std::vector<json> warnings(const Comparison& comparison) {
  std::vector<json> notes;
  for (const Remark& remark : remarks(comparison)) {
    if (remark.warning) notes.push_back(page::note("warning", remark.text));
  }
  return notes;
}

json sections_of(const Comparison& comparison, const StoredResults& results, const CellRuns& runs) {
  const GroupNames names{comparison};
  std::vector<json> rates = warnings(comparison);
  rates.insert(rates.begin(), rates_table(comparison, runs, names));
  json sections = json::array();
  sections.push_back(page::section("rates", "Rates", {}, std::move(rates)));
  sections.push_back(
      page::section("quantities", "Quantities", {}, {page::grid(2, charts_of(comparison, runs, names))}));
  sections.push_back(page::section("means", "Means", {}, {means_table(comparison, runs, names)}));
  if (std::vector<json> curves = survival_curves(comparison, names); !curves.empty()) {
    sections.push_back(
        page::section("cut-off", "Times that were cut off", {},
                      {page::grid(2, std::move(curves)), censored_table(comparison, runs, names)}));
  }
  if (comparison.tests > 0) {
    sections.push_back(
        page::section("differences", "Differences", {}, {differences_table(comparison, runs, names)}));
  }
  sections.push_back(
      page::section("methods", "Methods", methods_text(comparison, results.records, results.origin), {}));
  return sections;
}

}  // namespace

json results_page(const StoredResults& results, CompareOptions options, const std::string& command) {
  if (results.records.empty()) throw InputError(results.origin.campaign + ": the store holds no runs");
  options = options_for(results.origin, std::move(options));
  const Comparison comparison = compare(results.records, options);
  const CellRuns runs{results.records, comparison.by};
  return page::document(results.origin.campaign,
                        results.origin.summary.empty() ? "Stored results" : results.origin.summary, command,
                        {page::fact("Cells", std::to_string(comparison.cells.size())),
                         page::fact("Compared with", comparison.baseline)},
                        runs.list(), sections_of(comparison, results, runs));
}

}  // namespace fairway
