// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/labels.hpp"

namespace fairway {
namespace {

using Row = std::vector<std::string>;

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-"; }

std::string interval(double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high)) return "-";
  return fmt::format("[{:.4g}, {:.4g}]", low, high);
}

/// Columns on which a display spends its width, not bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Rows under a header, the first `words` columns to the left and the rest to the right.
std::string aligned(const std::vector<Row>& rows, std::size_t words) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - width_of(row[i]), ' ');
      if (i > 0) line += "  ";
      line += i < words ? row[i] + space : space + row[i];
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

/// The label columns: every name that any group has.
Row group_names(const Comparison& comparison) {
  Row names;
  for (const ComparedCell& cell : comparison.cells) {
    for (const auto& [name, value] : cell.group) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

Row beginning(const Row& names, const Labels& group, const std::string& candidate) {
  Row row;
  for (const std::string& name : names) {
    const std::string* value = find_label(group, name);
    row.push_back(value == nullptr ? "" : *value);
  }
  row.push_back(candidate);
  return row;
}

Row joined(Row row, const Row& more) {
  row.insert(row.end(), more.begin(), more.end());
  return row;
}

nlohmann::json number_json(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json labels_json(const Labels& labels) {
  nlohmann::json object = nlohmann::json::object();
  for (const auto& [name, value] : labels) object[name] = value;
  return object;
}

nlohmann::json mean_json(const MeanEstimate& e) {
  return {{"runs", e.count},
          {"mean", number_json(e.mean)},
          {"deviation", number_json(e.deviation)},
          {"low", number_json(e.low)},
          {"high", number_json(e.high)}};
}

}  // namespace

std::string table_text(const Comparison& comparison) {
  const Row names = group_names(comparison);
  const std::string percent = fmt::format("{:.4g} %", 100.0 * comparison.confidence);
  const Row labels = joined(names, {comparison.by});

  std::vector<Row> means{joined(labels, {"quantity", "runs", "mean", percent,
                                         fmt::format("less {}", comparison.baseline), percent, "pairs"})};
  for (const ComparedMean& m : comparison.means) {
    const MeanEstimate& d = m.difference;
    means.push_back(joined(
        beginning(names, m.group, m.candidate),
        {m.quantity, std::to_string(m.value.count), number(m.value.mean), interval(m.value.low, m.value.high),
         number(d.mean), interval(d.low, d.high), d.count == 0 ? "-" : std::to_string(d.count)}));
  }
  std::string text = aligned(means, labels.size() + 1);

  if (!comparison.rates.empty()) {
    std::vector<Row> rates{joined(labels, {"rate", "runs", "share", percent})};
    for (const ComparedRate& r : comparison.rates) {
      rates.push_back(joined(beginning(names, r.group, r.candidate),
                             {r.name, fmt::format("{}/{}", r.value.successes, r.value.trials),
                              number(r.value.rate), interval(r.value.low, r.value.high)}));
    }
    text.append("\n").append(aligned(rates, labels.size() + 1));
  }

  std::vector<Row> failures{joined(labels, {"failed", "runs"})};
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.failed == 0) continue;
    failures.push_back(joined(beginning(names, cell.group, cell.candidate),
                              {std::to_string(cell.failed), std::to_string(cell.runs)}));
  }
  if (failures.size() > 1) text.append("\n").append(aligned(failures, labels.size()));
  return text;
}

nlohmann::json to_json(const Comparison& comparison) {
  nlohmann::json json{{"by", comparison.by},
                      {"baseline", comparison.baseline},
                      {"confidence", comparison.confidence},
                      {"cells", nlohmann::json::array()},
                      {"means", nlohmann::json::array()},
                      {"rates", nlohmann::json::array()}};
  for (const ComparedCell& c : comparison.cells) {
    json["cells"].push_back({{"group", labels_json(c.group)},
                             {comparison.by, c.candidate},
                             {"runs", c.runs},
                             {"failed", c.failed}});
  }
  for (const ComparedMean& m : comparison.means) {
    json["means"].push_back(
        {{"group", labels_json(m.group)},
         {comparison.by, m.candidate},
         {"quantity", m.quantity},
         {"value", mean_json(m.value)},
         {"difference", m.difference.count == 0 ? nlohmann::json() : mean_json(m.difference)}});
  }
  for (const ComparedRate& r : comparison.rates) {
    json["rates"].push_back({{"group", labels_json(r.group)},
                             {comparison.by, r.candidate},
                             {"rate", r.name},
                             {"successes", r.value.successes},
                             {"runs", r.value.trials},
                             {"share", number_json(r.value.rate)},
                             {"low", number_json(r.value.low)},
                             {"high", number_json(r.value.high)}});
  }
  return json;
}

}  // namespace fairway
