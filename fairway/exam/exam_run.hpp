// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/metrics/measure.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// Part of a vehicle's radius that is a buffer round its hull: what is solid is touched once it is used up.
/// As between vehicles, whose centres collide at 3 m where spheres of 2 m each overlap by a quarter.
inline constexpr double exam_buffer_ratio = 0.25;

/// What one run came to. Every number has six significant digits and no more, so that a table made of stored
/// runs is the table of the runs themselves.
struct ExamOutcome {
  double safe{};           ///< 1 where no two vehicles came within the safety distance and no hull touched an
                           ///< obstacle, else 0
  double arrived_ratio{};  ///< share of the vehicles
  double no_progress{};    ///< 1 where a vehicle got nowhere for longer than the exam's window, else 0
  double time_s{};         ///< under way, mean of the vehicles
  double length_m{};       ///< gone while navigating, likewise
  double energy_j{};       ///< drawn by the actuators, likewise
  double turning_rad{};    ///< sum of all changes of heading, likewise
  double clearance_m{};    ///< least distance left: between centres beyond the safety distance, or between a
                           ///< hull and an obstacle; negative where something was touched
  double worst_vehicle{};  ///< index of whoever had so little left; -1 where nobody is known
  double worst_time_s{};   ///< when

  bool is_safe() const { return safe > 0.5; }
  bool all_arrived() const { return arrived_ratio >= 1.0; }
};

/// Of a run that failed: unsafe, nobody arrived, and all else is not known (NaN).
ExamOutcome failed_exam();

/// What the metrics of a run come to.
ExamOutcome exam_outcome(std::span<const Measure> measures, const Scenario& scenario);

/// An outcome as a store keeps it, and back.
std::vector<Measure> measures_of(const ExamOutcome& outcome);
ExamOutcome outcome_in(std::span<const Measure> measures);

/// One run of the exam, and what tells it from the others.
struct ExamRun {
  std::string family;
  std::string condition;
  std::string method;
  bool tuned{};
  std::string ground;
  std::uint64_t seed{};
  ExamOutcome outcome;
  std::string command;  ///< that makes it alone, up to the seed, which ends it; empty where it is not known
};

/// A name and the member of ExamOutcome that it stands for, in the order of the columns.
struct OutcomeMember {
  std::string_view name;
  double ExamOutcome::*member;
};
std::span<const OutcomeMember> outcome_members();

}  // namespace fairway
