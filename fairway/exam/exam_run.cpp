// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_run.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "fairway/core/text.hpp"
#include "fairway/experiment/compare.hpp"

namespace fairway {
namespace {

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<OutcomeMember, 10> members{{{"collision_free_ratio", &ExamOutcome::safe},
                                                 {"arrived_ratio", &ExamOutcome::arrived_ratio},
                                                 {"no_progress_ratio", &ExamOutcome::no_progress},
                                                 {"navigation_time_s", &ExamOutcome::time_s},
                                                 {"distance_m", &ExamOutcome::length_m},
                                                 {"energy_j", &ExamOutcome::energy_j},
                                                 {"heading_change_rad", &ExamOutcome::turning_rad},
                                                 {"clearance_m", &ExamOutcome::clearance_m},
                                                 {"worst_vehicle_count", &ExamOutcome::worst_vehicle},
                                                 {"worst_time_s", &ExamOutcome::worst_time_s}}};

}  // namespace

std::span<const OutcomeMember> outcome_members() { return members; }

ExamOutcome failed_exam() {
  return {.safe = 0.0,
          .arrived_ratio = 0.0,
          .no_progress = not_measured,
          .time_s = not_measured,
          .length_m = not_measured,
          .energy_j = not_measured,
          .turning_rad = not_measured,
          .clearance_m = not_measured,
          .worst_vehicle = -1.0,
          .worst_time_s = not_measured};
}

ExamOutcome exam_outcome(std::span<const Measure> measures, const Scenario& scenario) {
  ExamOutcome outcome = failed_exam();
  outcome.clearance_m = std::numeric_limits<double>::infinity();
  outcome.no_progress = 0.0;
  bool touched = false;
  for (const Measure& measure : measures) {
    double left = std::numeric_limits<double>::infinity();
    if (measure.quantity == "min_separation_m") left = measure.value - scenario.exam.safety_distance_m;
    if (measure.quantity == "footprint_clearance_m") {
      left = measure.value +
             exam_buffer_ratio * scenario.vehicles.at(static_cast<std::size_t>(measure.vehicle)).radius_m;
      touched = touched || left < 0.0;
    }
    if (measure.quantity == "no_progress_time_s" && measure.value > 0.0) outcome.no_progress = 1.0;
    if (!(left < outcome.clearance_m)) continue;
    outcome.clearance_m = left;
    outcome.worst_vehicle = measure.vehicle == Measure::fleet ? measure.occasion.vehicle : measure.vehicle;
    outcome.worst_time_s = measure.occasion.time;
  }
  outcome.safe = !(run_value(measures, "pair_collision_count") > 0.0) && !touched ? 1.0 : 0.0;
  outcome.arrived_ratio = run_value(measures, "arrived_ratio");
  outcome.time_s = run_value(measures, "navigation_time_s");
  outcome.length_m = run_value(measures, "distance_m");
  outcome.energy_j = run_value(measures, "energy_j");
  outcome.turning_rad = run_value(measures, "heading_change_rad");
  for (const OutcomeMember& each : members) outcome.*each.member = to_six_digits(outcome.*each.member);
  return outcome;
}

std::vector<Measure> measures_of(const ExamOutcome& outcome) {
  std::vector<Measure> measures;
  for (const OutcomeMember& each : members)
    measures.push_back({.quantity = std::string(each.name), .value = outcome.*each.member});
  return measures;
}

ExamOutcome outcome_in(std::span<const Measure> measures) {
  ExamOutcome outcome = failed_exam();
  for (const Measure& measure : measures)
    for (const OutcomeMember& each : members)
      if (measure.quantity == each.name) outcome.*each.member = measure.value;
  return outcome;
}

}  // namespace fairway
