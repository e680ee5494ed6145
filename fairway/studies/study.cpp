// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "fairway/core/names.hpp"
#include "fairway/studies/cubes/cubes.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/pledge/pledge.hpp"
#include "fairway/studies/surface/surface.hpp"
#include "fairway/studies/transport/transport.hpp"
#include "fairway/studies/uuv/uuv.hpp"

namespace fairway {
namespace {

constexpr double reproduced_within = 0.15;
constexpr double partly_within = 0.35;

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array names{
      "reproduced",     "reproduced_assuming", "within_spread",       "partly",
      "not_reproduced", "no_reference",        "follows_from_inputs", "another_course"};
  return names[static_cast<std::size_t>(verdict)];
}

std::optional<double> StudyRow::deviation_ratio() const {
  if (!published || *published == 0.0 || !std::isfinite(measured)) return std::nullopt;
  return measured / *published - 1.0;
}

void judge(StudyRow& row, bool is_count) {
  const auto verdict = [&] {
    if (!row.published) return Verdict::no_reference;
    if (is_count && row.measured == *row.published) return Verdict::reproduced;
    const std::optional<double> deviation = row.deviation_ratio();
    if (!is_count && deviation && std::abs(*deviation) <= reproduced_within) return Verdict::reproduced;
    const bool spread_known = std::isfinite(row.low) && std::isfinite(row.high);
    if (spread_known && row.low <= *row.published && *row.published <= row.high)
      return Verdict::within_spread;
    if (deviation && std::abs(*deviation) <= partly_within) return Verdict::partly;
    return Verdict::not_reproduced;
  };
  row.verdict = verdict();
}

std::span<const Study> builtin_studies() {
  static const std::array all{cubes::study(), transport::study(), surface::study(), uuv::study(),
                              pledges::study()};
  return all;
}

const Study& find_study(std::string_view name) {
  std::vector<std::string_view> known;
  for (const Study& study : builtin_studies()) {
    if (study.name == name) return study;
    known.push_back(study.name);
  }
  throw InputError("unknown study \"" + std::string(name) + "\"" + suggestion(name, known));
}

nlohmann::json row_json(const StudyRow& row) {
  const auto known = [](const std::optional<double>& value) {
    return value ? page::number(*value) : nlohmann::json();
  };
  return {{"case", row.cell},
          {"method", row.method},
          {"mode", row.mode},
          {"quantity", row.quantity},
          {"published", known(row.published)},
          {"measured", page::number(row.measured)},
          {"low", page::number(row.low)},
          {"high", page::number(row.high)},
          {"runs", row.runs},
          {"deviation_ratio", known(row.deviation_ratio())},
          {"verdict", name_of(row.verdict)},
          {"note", row.note}};
}

nlohmann::json rows_json(std::string_view study, std::span<const StudyRow> rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const StudyRow& row : rows) {
    nlohmann::json entry = row_json(row);
    if (row.place_ratio) entry["place_ratio"] = *row.place_ratio;
    if (row.p_value) entry["p_value"] = *row.p_value;
    if (!row.params.empty()) {
      for (const auto& [name, value] : row.params)
        std::visit([&](const auto& v) { entry["params"][name] = v; }, value);
    }
    list.push_back(std::move(entry));
  }
  return {{"study", study}, {"rows", std::move(list)}};
}

std::string rows_text(std::span<const StudyRow> rows) {
  std::string text =
      fmt::format("{:<17} {:<22} {:<12} {:<25} {:>10} {:>10} {:>21} {:>6} {:>9}  {}\n", "case", "method",
                  "mode", "quantity", "published", "measured", "95 % interval", "runs", "dev.", "verdict");
  for (const StudyRow& row : rows) {
    if (!row.params.empty()) continue;  // the grid is for --json and the report
    const auto deviation = row.deviation_ratio();
    const std::string interval = std::isfinite(row.low) && row.low < row.high
                                     ? fmt::format("[{:.1f}, {:.1f}]", row.low, row.high)
                                     : "";
    const std::string measured = std::isfinite(row.measured) ? fmt::format("{:.1f}", row.measured) : "-";
    text += fmt::format(
        "{:<17} {:<22} {:<12} {:<25} {:>10} {:>10} {:>21} {:>6} {:>9}  {}\n", row.cell, row.method, row.mode,
        row.quantity, row.published ? fmt::format("{:.1f}", *row.published) : "-", measured, interval,
        row.runs, deviation ? fmt::format("{:+.1f} %", 100 * *deviation) : "", name_of(row.verdict));
  }
  return text;
}

}  // namespace fairway
