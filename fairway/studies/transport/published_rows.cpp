// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/studies/transport/findings.hpp"

namespace fairway::transport {
namespace {

/// What is looked at in each published run, published or not.
constexpr std::array shown{"initial_surge_force_n",
                           "initial_sway_force_n",
                           "peak_surge_force_n",
                           "peak_sway_force_n",
                           "peak_yaw_moment_nm",
                           "switch_distance_m",
                           "detection_1_surge_force_n",
                           "detection_1_sway_force_n",
                           "detection_3_surge_force_n",
                           "detection_3_sway_force_n",
                           "detection_4_surge_force_n",
                           "detection_4_sway_force_n",
                           "displacement_m",
                           "path_length_m",
                           "planned_length_m",
                           "goal_time_s",
                           "footprint_clearance_m",
                           "rmse_north_m",
                           "rmse_east_m",
                           "rms_surge_power_w",
                           "rms_sway_power_w",
                           "rms_yaw_power_w",
                           "net_power_w",
                           "mean_surge_power_w",
                           "mean_sway_power_w",
                           "body_energy_j",
                           "energy_j"};

constexpr double octant = 0.25 * pi;

/// The obstacles at which the text gives both forces, in the order in which they are met.
constexpr std::array told_obstacles{1, 3, 4};

std::string detection(int obstacle, std::string_view axis) {
  return fmt::format("detection_{}_{}_force_n", obstacle, axis);
}

/// The first obstacle that the run meets on another side than the published one, or not at all. The force
/// commanded as an obstacle is detected is across the line to it, so its direction tells the side: more than
/// 45 degrees away it is another.
std::optional<int> departs_at(const Cell& cell, Case which) {
  for (const int obstacle : told_obstacles) {
    const std::string surge = detection(obstacle, "surge"), sway = detection(obstacle, "sway");
    const auto surge_told = published(which, cell.method, surge),
               sway_told = published(which, cell.method, sway);
    if (!surge_told || !sway_told) continue;
    const Vec2 told{*surge_told, *sway_told}, measured{cell.value(0, surge), cell.value(0, sway)};
    if (!(told.dot(measured) >= math::cos(octant) * told.norm() * measured.norm())) return obstacle;
  }
  return {};
}

/// Why the number of a run is no evidence, in words: it had gone another way than the published one, or is
/// about a whole run of which the published one was another. Empty where it is evidence.
std::string astray(const Cell& cell, Case which, std::string_view quantity) {
  if (quantity.starts_with("initial_") || quantity == "switch_distance_m") return "";
  const std::optional<int> departure = departs_at(cell, which);
  for (const int obstacle : told_obstacles) {
    const bool before = !departure || obstacle < *departure;
    if (before && quantity.starts_with(fmt::format("detection_{}_", obstacle))) return "";
  }
  if (departure) {
    return fmt::format("the run meets obstacle {} on another side than the published one, or not at all",
                       *departure);
  }
  const bool of_whole_run = quantity.starts_with("rms_") || quantity == "net_power_w";
  const bool came = std::isfinite(cell.value(0, "goal_time_s"));
  return of_whole_run && !came ? "the run does not come to its goal" : "";
}

/// Why a number cannot come out otherwise; nothing where it can.
std::string_view given_by(const Cell& cell, std::string_view quantity) {
  const bool heading_held = cell.method == "wall_following";
  if (quantity.starts_with("initial_")) return "gain times the distance to the goal";
  if (quantity == "switch_distance_m") return "the radius of the obstacle and the range of the sensors";
  if (quantity == "planned_length_m")
    return "the polyline of Table 7, whose length is printed nowhere; the shortest path is 42.59 m";
  if (quantity == "displacement_m" && std::isfinite(cell.value(0, "goal_time_s")))
    return "that of any run that arrives, 141.4 m; as the length of a path around the obstacle, 143.8 m or "
           "more, it is impossible";
  if (quantity == "peak_yaw_moment_nm" && !heading_held)
    return "200 N m/rad times a quarter turn, on any plant";
  if ((quantity == "peak_yaw_moment_nm" || quantity == "rms_yaw_power_w") && heading_held)
    return "the heading is held from the start and nothing turns a symmetric body";
  return "";
}

/// What is known of a number that can come out otherwise.
std::string_view note_on(const StudyRow& row) {
  const std::string_view q = row.quantity;
  if (q == "displacement_m") return "|eta| at the end; the run did not arrive";
  if (q == "goal_time_s") return "published is where the plots end; measured is the first time within 1 m";
  if (q == "rms_yaw_power_w" && row.method == "hard_switching")
    return "a run whose set-point is not latched gives about as much, and never reaches the goal";
  if (q.ends_with("power_w"))
    return "no definition of power tried gives the published tables; see the mean of the absolute power";
  if (q.starts_with("rmse_")) return "the error is what drag and inertia make of a PID without feed-forward";
  if (q.starts_with("detection_") || q.starts_with("peak_"))
    return "depends on the unpublished mass and drag";
  return "";
}

bool is_agreement(Verdict verdict) {
  return verdict == Verdict::reproduced || verdict == Verdict::within_spread || verdict == Verdict::partly;
}

/// The verdict, and why it is what it is.
void judge_published(StudyRow& row, const Cell& cell, Case which) {
  judge(row, false);
  if (row.published && *row.published == 0.0 && std::abs(row.measured) < 0.5)
    row.verdict = Verdict::reproduced;

  const std::string_view given = given_by(cell, row.quantity);
  const bool agrees = row.verdict == Verdict::reproduced || row.quantity == "planned_length_m";
  if (!given.empty() && agrees && std::isfinite(row.measured)) {
    row.verdict = Verdict::follows_from_inputs;
    row.note = given;
    if (row.quantity == "initial_sway_force_n" && row.method == "hard_switching")
      row.note += "; the same as in surge, published as 130 N: 129 N is not explained";
    return;
  }
  if (!row.published) return;
  if (row.quantity == "displacement_m") row.verdict = Verdict::not_reproduced;  // it did not arrive
  row.note = note_on(row);
  std::string reason = astray(cell, which, row.quantity);
  if (!reason.empty()) {
    if (is_agreement(row.verdict)) row.verdict = Verdict::another_course;
  } else if (row.verdict == Verdict::reproduced && cell.mode == name_of(Plant::paper_compat)) {
    row.verdict = Verdict::reproduced_assuming;
    reason = "assuming linear drag alone and no Coriolis terms, chosen after seeing the published times";
  }
  if (!row.note.empty() && !reason.empty()) row.note += "; ";
  row.note += reason;
}

}  // namespace

std::vector<StudyRow> published_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    const Case which = cell.place == name_of(Case::one_obstacle) ? Case::one_obstacle : Case::four_obstacles;
    for (const std::string_view quantity : shown) {
      const double measured = cell.value(0, quantity);
      StudyRow row = cell_row(cell, quantity, measured, measured, measured, "");  // nothing is drawn
      row.published = published(which, cell.method, quantity);
      judge_published(row, cell, which);
      const bool telling = std::isfinite(row.measured) && !quantity.starts_with("detection_");
      if (row.published || telling) rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace fairway::transport
