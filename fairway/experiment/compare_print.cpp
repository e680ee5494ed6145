// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/labels.hpp"

namespace fairway {
namespace {

using Row = std::vector<std::string>;

/// Four digits, of small numbers three, with an exponent of no more than it takes: 0.0123, 123456, 1.234e6.
std::string figure(double value) {
  if (!std::isfinite(value)) return "-";
  const double size = std::abs(value);
  if (size >= 1e4 && size < 1e6) return fmt::format("{:.0f}", value);
  std::string text = size < 0.1 ? fmt::format("{:.3g}", value) : fmt::format("{:.4g}", value);
  const std::size_t exponent = text.find("e+0");
  return exponent == std::string::npos ? text : text.replace(exponent, 3, "e");
}

std::string interval(double low, double high) {
  if (!std::isfinite(low) && !std::isfinite(high)) return "-";
  return fmt::format("[{}, {}]", figure(low), figure(high));
}

std::string p_text(double p) { return p < 0.001 ? "<0.001" : fmt::format("{:.3f}", p); }

/// Columns on which a display spends its width, not bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Rows in columns, the first `words` to the left and the rest to the right. A row of one cell is a heading,
/// which stands by itself.
std::string aligned(const std::vector<Row>& rows, std::size_t words) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    if (row.size() == 1) continue;
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const Row& row : rows) {
    if (row.size() == 1) {
      text.append(text.empty() ? "" : "\n").append(row.front()).append("\n");
      continue;
    }
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

std::string heading(const Labels& group) { return group.empty() ? "all" : labels_text(group); }

/// Begins a part of the table wherever the heading changes.
void begin_part(std::vector<Row>& rows, const std::string& part, std::string& before, const Row& columns) {
  if (part == before) return;
  rows.push_back({part});
  rows.push_back(columns);
  before = part;
}

/// The mean as it may be stated, or how far it is restricted.
Row value_cells(const ComparedMean& m) {
  if (!m.censored) return {figure(m.value.mean), interval(m.value.low, m.value.high), figure(m.median), ""};
  const CensoredTimes& c = *m.censored;
  return {fmt::format("{} to {}", figure(c.restricted.mean), figure(c.limit)),
          interval(c.restricted.low, c.restricted.high),
          std::isfinite(c.median.low) ? figure(c.median.median) + " " + interval(c.median.low, c.median.high)
                                      : figure(c.median.median),
          fmt::format("{}/{}", c.complete.successes, c.complete.trials)};
}

std::string means_text(const Comparison& comparison, const std::string& percent) {
  const bool cut =
      std::ranges::any_of(comparison.means, [](const auto& m) { return m.censored.has_value(); });
  const bool left = std::ranges::any_of(comparison.means, [](const auto& m) { return m.left_out > 0; });
  Row columns{comparison.by, "quantity", "runs"};
  if (left) columns.emplace_back("left out");
  columns.insert(columns.end(), {"mean", percent, "median"});
  if (cut) columns.emplace_back("arrived");

  std::vector<Row> rows;
  std::string part;
  for (const ComparedMean& m : comparison.means) {
    begin_part(rows, heading(m.group), part, columns);
    Row row{m.candidate, m.quantity, std::to_string(m.value.count)};
    if (left) row.push_back(std::to_string(m.left_out));
    Row cells = value_cells(m);
    cells.resize(cut ? 4 : 3);
    row.insert(row.end(), cells.begin(), cells.end());
    rows.push_back(std::move(row));
  }
  return aligned(rows, 2);
}

std::string rates_text(const Comparison& comparison, const std::string& percent) {
  const Row columns{comparison.by, "rate", "runs", "share", percent};
  std::vector<Row> rows;
  std::string part;
  for (const ComparedRate& r : comparison.rates) {
    begin_part(rows, heading(r.group), part, columns);
    rows.push_back({r.candidate, r.name, fmt::format("{}/{}", r.value.successes, r.value.trials),
                    figure(r.value.rate), interval(r.value.low, r.value.high)});
  }
  return aligned(rows, 2);
}

/// A candidate against the baseline, line by line.
Row difference_row(const std::string& name, std::size_t pairs, Row numbers, const ComparedTest& test) {
  Row row{name, std::to_string(pairs)};
  row.insert(row.end(), numbers.begin(), numbers.end());
  row.insert(row.end(),
             {p_text(test.result.p), p_text(test.p_adjusted), fmt::format("{:.2f}", test.result.effect)});
  return row;
}

std::string differences_text(const Comparison& comparison, const std::string& percent) {
  const Row columns{"difference", "pairs", "mean", percent, "median", percent, "p", "Holm", "effect"};
  std::vector<Row> rows;
  for (const ComparedCell& cell : comparison.cells) {
    const auto here = [&](const auto& row) {
      return row.test && row.candidate == cell.candidate && row.group == cell.group;
    };
    std::string part;
    const std::string name =
        fmt::format("{}: {} less {}", heading(cell.group), cell.candidate, comparison.baseline);
    for (const ComparedMean& m : comparison.means) {
      if (!here(m)) continue;
      const MeanEstimate& d = m.difference;
      const MedianEstimate& median = m.difference_median;
      begin_part(rows, name, part, columns);
      rows.push_back(difference_row(
          m.quantity, d.count,
          {figure(d.mean), interval(d.low, d.high), figure(median.median), interval(median.low, median.high)},
          *m.test));
    }
    for (const ComparedRate& r : comparison.rates) {
      if (!here(r)) continue;
      const RateDifference& d = r.difference;
      begin_part(rows, name, part, columns);
      rows.push_back(
          difference_row(r.name, d.pairs, {figure(d.difference), interval(d.low, d.high), "", ""}, *r.test));
    }
  }
  return rows.empty() ? "" : aligned(rows, 1);
}

std::string failures_text(const Comparison& comparison) {
  std::vector<Row> rows;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.failed == 0) continue;
    if (rows.empty()) rows.push_back({comparison.by, "failed", "runs", "of"});
    rows.push_back(
        {cell.candidate, std::to_string(cell.failed), std::to_string(cell.runs), heading(cell.group)});
  }
  return rows.empty() ? "" : aligned(rows, 1);
}

/// Words in lines of at most `width`.
std::string wrapped(const std::string& text, std::size_t width) {
  std::string lines, line;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!line.empty() && width_of(line) + 1 + width_of(word) > width) {
      lines += line + "\n";
      line = " ";
    }
    line += (line.empty() ? "" : " ") + word;
    begin = end + 1;
  }
  return lines + line + "\n";
}

}  // namespace

std::string table_text(const Comparison& comparison) {
  const std::string percent = fmt::format("{:.4g} %", 100.0 * comparison.confidence);
  std::string text;
  const std::string parts[]{means_text(comparison, percent), rates_text(comparison, percent),
                            differences_text(comparison, percent), failures_text(comparison)};
  for (const std::string& part : parts) {
    if (!part.empty()) text.append(text.empty() ? "" : "\n").append(part);
  }
  const std::vector<Remark> said = remarks(comparison);
  if (!said.empty()) text += "\n";
  for (const Remark& remark : said) text += wrapped((remark.warning ? "Note: " : "") + remark.text, 116);
  return text;
}

}  // namespace fairway
