// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/findings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fairway/studies/claim.hpp"

namespace fairway::transport {
namespace {

/// A number of the one run of a cell, if that came within a metre of its goal: what a run used that did not
/// get there is no price of getting there.
MeanEstimate of_arrival(const Cell& cell, std::string_view quantity, double unit = 1.0) {
  const bool came = std::isfinite(cell.value(0, "goal_time_s"));
  return exactly(came ? cell.value(0, quantity) / unit : std::nan(""));
}

/// "`a` takes less of the quantity than `b`".
std::string compared(std::string_view claim, const Cell& a, const Cell& b, std::string_view quantity,
                     std::string_view unit, double scale = 1.0) {
  const MeanEstimate of_a = of_arrival(a, quantity, scale), of_b = of_arrival(b, quantity, scale);
  return stated(
      claim, is_less(of_a, of_b),
      fmt::format("{} {:.4g} {} against {} {:.4g} {}", a.method, of_a.mean, unit, b.method, of_b.mean, unit));
}

/// Whether the footprint stayed clear of what is in the way, all the way to the goal.
std::string avoided(const Cell& cell) {
  const double clearance = cell.value(0, "footprint_clearance_m");
  Standing standing = Standing::not_measured;
  if (clearance < 0.0) standing = Standing::does_not_hold;
  if (clearance >= 0.0 && std::isfinite(cell.value(0, "goal_time_s"))) standing = Standing::holds;
  return stated(fmt::format("\"The obstacle is avoided\", {} on {}", cell.method, cell.place), standing,
                fmt::format("the footprint comes as near as {:.2f} m; negative is inside", clearance));
}

/// What became of hard switching where momentum is kept.
std::string of_coriolis(const Cell& cell) {
  const double time = cell.value(0, "goal_time_s"), end = cell.value(0, "displacement_m");
  if (std::isfinite(time))
    return fmt::format("Hard switching on the physical plant comes within 1 m of the goal after {:.0f} s.",
                       time);
  if (!std::isfinite(end)) return "Hard switching on the physical plant: not measured.";
  return fmt::format(
      "Hard switching on the physical plant does not arrive: it ends {:.1f} m from the start, and the goal "
      "is 141.4 m away. The forces along surge and sway are zero while it turns, and a pure yaw moment "
      "cannot change the momentum of the body in the frame of the Earth; without Coriolis terms the velocity "
      "is kept in body axes and turns with the body.",
      end);
}

bool touched_with_a_way_out(const Cell& cell, std::size_t i) {
  return cell.value(i, "avoidable_touch_count") > 0.0;
}
}  // namespace

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

  return {
      "What the claims come to on the compatible plant, each from one run in which nothing is drawn; a run "
      "that does not come within 1 m of its goal is not compared.",
      compared("\"Wall following is faster than hard switching\"", wall, hard, "goal_time_s", "s"),
      compared("\"Wall following travels a slightly shorter distance than hard switching\", as the length of "
               "the path",
               wall, hard, "path_length_m", "m"),
      compared("\"Wall following is more power-efficient than hard switching\", as energy put into the body",
               wall, hard, "body_energy_j", "kJ", 1000.0),
      compared("The same, as the sum of RMS powers of Table 4", wall, hard, "net_power_w", "W"),
      avoided(hard),
      avoided(wall),
      avoided(wall_four),
      compared("\"The planned path takes less power than wall following\", as energy put into the body", path,
               wall_four, "body_energy_j", "kJ", 1000.0),
      compared("\"Wall following takes less time than the planned path\"", wall_four, path, "goal_time_s",
               "s"),
      compared("\"Wall following travels a shorter distance than the planned path\"", wall_four, path,
               "path_length_m", "m"),
      of_coriolis(hard_physical),
  };
}

std::vector<std::string> field_findings(const std::vector<Cell>& fields, int seeds) {
  std::vector<std::string> lines{
      "Whether there is a way out of a touch is decided at the moment when something last came into sight "
      "before it: on a grid of 0.5 m and 2 s, can a disc of the footprint and a tenth of a metre, at no more "
      "than 0.25 m/s, stay clear of everything for two minutes? Where it cannot, the vehicle is caught "
      "between what stays and what drifts, and no method is blamed."};
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
