// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fairway/experiment/statistics.hpp"

namespace fairway::uuv {
namespace {

constexpr std::array moments_of_each{"aside_time_s",    "slow_down_time_s", "pass_time_s",   "slowest_time_s",
                                     "least_speed_mps", "turn_back_time_s", "resume_time_s", "arrive_time_s"};
constexpr std::array outcomes_of_both{"vehicle_gap_m", "ship_gap_m", "contact_count", "keeps_right_ratio"};

Encounter encounter_of(const Cell& cell) {
  return *std::ranges::find(encounters, cell.place, [](Encounter e) { return name_of(e); });
}

/// The quantity of both vehicles in run `i`, where they have it.
std::vector<double> of_both(const Cell& cell, std::size_t i, std::string_view quantity) {
  std::vector<double> values;
  for (const Measure& measure : cell.results[i]) {
    if (measure.quantity == quantity) values.push_back(measure.value);
  }
  return values;
}

double mean_of(const std::vector<double>& values) { return estimate_mean(values).mean; }

std::string listed(const std::vector<double>& values) {
  if (values.empty()) return "did not happen";
  if (values.size() == 1) return fmt::format("of one vehicle only: {:.2f}", values[0]);
  return fmt::format("{:.2f} and {:.2f}", values[0], values[1]);
}

void set_beside(StudyRow& row, Encounter encounter) {
  if (row.method != "rvo") return;
  row.published = published(encounter, row.quantity);
  if (!row.published) return;
  judge(row, row.quantity == "contact_count" || row.quantity == "keeps_right_ratio");
  if (row.verdict == Verdict::reproduced) row.verdict = Verdict::reproduced_assuming;
  row.note += fmt::format("; radii, speed, acceleration and horizon as in \"{}\"{}", row.mode,
                          encounter == Encounter::multi_obstacle ? ", goals as proposed" : "");
}

bool had_contact(const Cell& cell, std::size_t i) { return cell.value(i, "contact_count") > 0.0; }
bool kept_right(const Cell& cell, std::size_t i) { return cell.value(i, "keeps_right_ratio") == 1.0; }
bool collided(const Cell& cell, std::size_t i) { return cell.value(i, "pair_collision_count") > 0.0; }
bool deadlocked(const Cell& cell, std::size_t i) { return !arrived(cell, i); }

StudyRow interval_row(const Cell& cell, std::string_view quantity, std::string note) {
  std::vector<double> values;
  for (std::size_t i = 0; i < cell.results.size(); ++i) {
    const double value = cell.value(i, quantity);
    if (std::isfinite(value)) values.push_back(value);
  }
  return mean_row(cell, quantity, values, std::move(note));
}

}  // namespace

std::size_t collision_runs(const Cell& cell) { return count_runs(cell, collided); }

std::vector<StudyRow> published_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    const auto add = [&](std::string_view quantity, double value, std::string note) {
      StudyRow row = cell_row(cell, quantity, value, value, value, std::move(note));
      set_beside(row, encounter_of(cell));
      rows.push_back(std::move(row));
    };
    for (const std::string_view quantity : moments_of_each) {
      const std::vector<double> values = of_both(cell, 0, quantity);
      add(quantity, mean_of(values), listed(values));
    }
    for (const std::string_view quantity : outcomes_of_both) {
      const double value = cell.value(0, quantity);
      if (std::isfinite(value)) add(quantity, value, "of the run");
    }
  }
  return rows;
}

std::vector<StudyRow> varied_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    rows.push_back(share_row(cell, "contact_ratio", count_runs(cell, had_contact),
                             "runs in which spheres touched; Wilson's interval"));
    rows.push_back(share_row(cell, "arrived_ratio", count_runs(cell, arrived), "runs in which both arrived"));
    if (cell.place == name_of(Encounter::head_on)) {
      rows.push_back(share_row(cell, "keeps_right_ratio", count_runs(cell, kept_right),
                               "runs in which both kept to their right"));
    }
    rows.push_back(interval_row(cell, "arrive_time_s", "of the first vehicle, where it arrived"));
  }
  return rows;
}

std::vector<StudyRow> gathering_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    rows.push_back(share_row(cell, "collision_ratio", collision_runs(cell),
                             "runs in which bodies met; Wilson's interval"));
    rows.push_back(share_row(cell, "deadlock_ratio", count_runs(cell, deadlocked),
                             "runs in which somebody did not arrive; Wilson's interval"));
    rows.push_back(interval_row(cell, "time_ratio", "to the straight way, of the vehicles that arrived"));
    rows.push_back(interval_row(cell, "mean_time_s", "of the vehicles that arrived"));
    rows.push_back(interval_row(cell, "mean_course_change_rad", "changes of course in all, of all vehicles"));
  }
  return rows;
}

std::vector<StudyRow> silence_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    const auto add = [&](StudyRow row) {
      if (cell.mode != "perfect" && cell.mode != "modem") row.params = {{"channel", cell.mode}};
      rows.push_back(std::move(row));
    };
    add(share_row(cell, "collision_ratio", collision_runs(cell), "runs with a collision; Wilson's interval"));
    add(share_row(cell, "deadlock_ratio", count_runs(cell, deadlocked),
                  "runs in which somebody did not arrive; Wilson's interval"));
    add(interval_row(cell, "mean_time_s", "of the vehicles that arrived"));
  }
  for (const std::string_view cube : silent_cubes()) {
    for (const Method& method : silence_methods()) {
      for (const double loss : loss_ratios) {
        const auto rate = safe_down_to(cells, cube, method.name, loss);
        const Cell& cell = find_cell(cells, cube, method.name, "perfect");
        StudyRow row = cell_row(cell, "safe_down_to_hz", rate.value_or(std::nan("")), rate.value_or(0.0),
                                rate.value_or(0.0),
                                rate ? "no collision at this update rate and at any higher one"
                                     : "collides even at the highest update rate");
        row.mode = fmt::format("loss {}", loss);
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

bool is_complete(const std::vector<Cell>& cells, std::string_view cube, std::string_view method) {
  const auto missing = [&](const Cell& cell) {
    return cell.place == cube && cell.method == method && cell.results.empty();
  };
  return std::ranges::any_of(cells, [&](const Cell& c) { return c.place == cube && c.method == method; }) &&
         std::ranges::none_of(cells, missing);
}

std::optional<double> safe_down_to(const std::vector<Cell>& cells, std::string_view cube,
                                   std::string_view method, double loss_ratio) {
  std::optional<double> safe;
  for (const double rate : update_rates_hz) {
    const Channel channel{Channel::Kind::acoustic, rate, loss_ratio};
    const Cell& cell = find_cell(cells, cube, method, channel.name());
    if (cell.results.empty() || collision_runs(cell) > 0) return safe;
    safe = rate;
  }
  return safe;
}

std::vector<std::string> silence_sentences(const std::vector<Cell>& cells) {
  std::vector<std::string> sentences;
  for (const Method& method : silence_methods()) {
    std::string text;
    for (const std::string_view cube : silent_cubes()) {
      if (!is_complete(cells, cube, method.name)) continue;
      const auto clear = safe_down_to(cells, cube, method.name, 0.0);
      const auto lossy = safe_down_to(cells, cube, method.name, 0.5);
      const auto phrase = [](std::optional<double> rate) {
        return rate ? fmt::format("{} Hz", *rate) : std::string("not even at 20 Hz");
      };
      text += fmt::format("{}{}: {} without loss, {} with half of all messages lost",
                          text.empty() ? "" : "; ", cube, phrase(clear), phrase(lossy));
    }
    if (text.empty()) continue;
    sentences.push_back(
        fmt::format("{}, lowest update rate down to which no run had a collision: {}.", method.name, text));
  }
  return sentences;
}

}  // namespace fairway::uuv
