// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/findings.hpp"

#include <fmt/format.h>

#include <cmath>

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

/// Numbers that follow from gains and geometry alone.
bool needs_no_plant(std::string_view quantity) {
  return quantity.starts_with("initial_") || quantity == "peak_yaw_moment_nm" ||
         quantity == "switch_distance_m" || quantity == "planned_length_m";
}

/// What is known of a number that comes out differently, or under which assumption it comes out alike.
std::string_view note_on(const StudyRow& row) {
  const std::string_view q = row.quantity;
  if (q == "displacement_m")
    return "|eta| at the end: as the length of a path around the obstacle, 143.8 m or more, it is impossible";
  if (q == "goal_time_s") return "published is where the plots end; measured is the first time within 1 m";
  if (q == "initial_sway_force_n" && row.method == "hard_switching")
    return "gain and error are those of surge, published as 130 N; 129 N is not explained";
  if (q == "rms_yaw_power_w" && row.method == "hard_switching")
    return "88.7 to 89.0 W is what a run gives whose set-point is not latched, and which never reaches the "
           "goal";
  if (q.ends_with("power_w"))
    return "no definition of power tried gives the published tables; see the mean of the absolute power";
  if (q.starts_with("detection_4"))
    return "the run passes obstacle 4 elsewhere; the path depends on the plant";
  if (q.starts_with("detection_") || q.starts_with("peak_"))
    return "depends on the unpublished mass and drag";
  if (q.starts_with("rmse_"))
    return "the error is what the drag makes of a PID without feed-forward; published drag would have to be "
           "smaller";
  if (q == "planned_length_m") return "the polyline of Table 7; the shortest path is 42.59 m";
  return "";
}

std::string_view assumption(const StudyRow& row) {
  if (row.verdict != Verdict::reproduced_assuming) return "";
  return "assuming linear drag alone and no Coriolis terms, chosen after seeing the published times";
}

StudyRow published_row(const Cell& cell, Case which, std::string_view quantity) {
  StudyRow row{.cell = cell.place,
               .method = cell.method,
               .mode = cell.mode,
               .part = cell.part,
               .quantity = std::string(quantity),
               .published = published(which, cell.method, quantity),
               .measured = cell.value(0, quantity),
               .runs = 1};
  row.low = row.high = row.measured;  // nothing is drawn: the run is what it is
  judge(row, false);
  if (row.published && *row.published == 0.0 && std::abs(row.measured) < 0.5)
    row.verdict = Verdict::reproduced;
  if (row.verdict == Verdict::reproduced && cell.mode == name_of(Plant::paper_compat) &&
      !needs_no_plant(quantity))
    row.verdict = Verdict::reproduced_assuming;
  if (row.published) {
    const std::string_view assumed = assumption(row);
    const std::string_view known = note_on(row);
    row.note = fmt::format("{}{}{}", assumed, !assumed.empty() && !known.empty() ? "; " : "", known);
  }
  return row;
}

bool touched_with_a_way_out(const Cell& cell, std::size_t i) {
  return cell.value(i, "avoidable_touch_count") > 0.0;
}
}  // namespace

std::vector<StudyRow> published_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    const Case which = cell.place == name_of(Case::one_obstacle) ? Case::one_obstacle : Case::four_obstacles;
    for (const std::string_view quantity : shown) {
      StudyRow row = published_row(cell, which, quantity);
      const bool telling = std::isfinite(row.measured) && !quantity.starts_with("detection_");
      if (row.published || telling) rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<StudyRow> comparison_rows(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    const std::size_t untouched = cell.results.size() - count_runs(cell, touched);
    rows.push_back(share_row(cell, "success_ratio", count_runs(cell, succeeded),
                             "arrived and touched nothing; Wilson's interval"));
    rows.push_back(share_row(cell, "untouched_ratio", untouched, "touched nothing; Wilson's interval"));
    rows.push_back(share_row(cell, "avoidable_touch_ratio", count_runs(cell, touched_with_a_way_out),
                             "touched something although there was a way out; Wilson's interval"));
    const double clearance = least(cell, "footprint_clearance_m");
    rows.push_back(cell_row(cell, "least_clearance_m", clearance, clearance, clearance,
                            "least distance of the footprint from any surface over all runs"));
    for (const std::string_view quantity :
         {"navigation_time_s", "path_length_m", "body_energy_j", "energy_j"})
      rows.push_back(mean_row(cell, quantity));
  }
  return rows;
}

std::vector<std::string> claims(const std::vector<Cell>& published) {
  const std::string_view compat = name_of(Plant::paper_compat), physical = name_of(Plant::physical);
  const Cell& hard = find_cell(published, "one_obstacle", "hard_switching", compat);
  const Cell& hard_physical = find_cell(published, "one_obstacle", "hard_switching", physical);
  const Cell& wall = find_cell(published, "one_obstacle", "wall_following", compat);
  const Cell& wall_four = find_cell(published, "four_obstacles", "wall_following", compat);
  const Cell& path = find_cell(published, "four_obstacles", "rrt_star", compat);
  const auto energy = [](const Cell& cell) { return cell.value(0, "body_energy_j") / 1000.0; };

  return {
      fmt::format("\"Wall following is faster than hard switching\": holds on the compatible plant ({:.0f} s "
                  "against {:.0f} s to come within 1 m of the goal).",
                  wall.value(0, "goal_time_s"), hard.value(0, "goal_time_s")),
      fmt::format(
          "\"Wall following is more power-efficient than hard switching\": reversed. It puts {:.1f} kJ into "
          "the body, hard switching {:.1f} kJ; the published order rests on a yaw power of 88.98 W, here "
          "{:.1f} W.",
          energy(wall), energy(hard), hard.value(0, "rms_yaw_power_w")),
      fmt::format(
          "\"The obstacle is avoided\": the footprint comes as near as {:.2f} m in hard switching and {:.2f} "
          "m "
          "in wall following (negative: inside the 20 m that the obstacle takes), and {:.2f} m in wall "
          "following among the four.",
          hard.value(0, "footprint_clearance_m"), wall.value(0, "footprint_clearance_m"),
          wall_four.value(0, "footprint_clearance_m")),
      fmt::format(
          "\"The planned path takes less power than wall following\": holds ({:.2f} kJ against {:.2f} kJ).",
          energy(path), energy(wall_four)),
      fmt::format(
          "Hard switching on the physical plant deadlocks: it ends {:.1f} m from the start. The forces along "
          "surge and sway are zero while it turns, and a pure yaw moment cannot change the momentum of the "
          "body in the frame of the Earth, so it coasts towards the obstacle; with drag it comes to rest "
          "within the sensors' range, where it only turns. Without Coriolis terms the velocity is kept in "
          "body axes and turns with the body, which is what carries the published run around.",
          hard_physical.value(0, "displacement_m")),
  };
}

std::vector<std::string> field_findings(const std::vector<Cell>& fields, int seeds) {
  std::vector<std::string> lines{
      "Whether there is a way out of a touch is decided at the moment when something last came into sight "
      "before "
      "it: on a grid of 0.5 m and 2 s, can a disc of the footprint and a tenth of a metre, at no more than "
      "0.25 m/s, stay "
      "clear of everything for two minutes? Where it cannot, the vehicle is caught between what stays and "
      "what "
      "drifts, and no method is blamed."};
  for (const FieldKind kind : field_kinds) {
    int escapes = 0;
    for (int seed = 1; seed <= seeds; ++seed)
      escapes += has_escape(random_field(kind, static_cast<std::uint64_t>(seed))) ? 1 : 0;
    lines.push_back(
        fmt::format("{}: {} of {} fields can be crossed untouched by someone who knows all of it beforehand.",
                    name_of(kind), escapes, seeds));
    for (const Cell& cell : fields) {
      if (cell.place != name_of(kind)) continue;
      const std::size_t all = count_runs(cell, touched);
      const std::size_t avoidable = count_runs(cell, touched_with_a_way_out);
      if (all > 0) {
        lines.push_back(fmt::format("{}, {}: touched something in {}, of which {} with a way out.",
                                    name_of(kind), cell.method, all, avoidable));
      }
    }
  }
  return lines;
}

}  // namespace fairway::transport
