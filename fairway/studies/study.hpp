// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/core/params.hpp"
#include "fairway/experiment/progress.hpp"
#include "fairway/experiment/shard.hpp"
#include "fairway/experiment/store.hpp"
#include "fairway/record/frame.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {

/// How a measured value stands to the published one.
enum class Verdict {
  reproduced,           ///< within 15 % (counts: equal)
  reproduced_assuming,  ///< likewise, under an assumption that the note states and the publication does not
  within_spread,  ///< farther off, but the published value lies in the 95 % interval of the measured mean
  partly,         ///< within 35 %
  not_reproduced,
  no_reference,         ///< nothing published to compare with
  follows_from_inputs,  ///< what was put in fixes the number, whatever the experiment: no evidence for it
  another_course,       ///< agrees, but in a run that went another way than the published one: no evidence
};
std::string_view name_of(Verdict verdict);

/// One published number beside the measured one.
struct StudyRow {
  std::string cell;  ///< the published case: "cube20_8"
  std::string method;
  std::string mode;  ///< "as_coded", "corrected"
  std::string part;  ///< of the study, as of the cell
  std::string quantity;
  ParamValues params;  ///< where the case is one of a grid
  std::optional<double> published;
  double measured{};
  double low{-std::numeric_limits<double>::infinity()};  ///< of the 95 % interval
  double high{std::numeric_limits<double>::infinity()};
  int runs{};
  /// Where the published value lies among repetitions of the published experiment: the share of them below
  /// it, ties counted half.
  std::optional<double> place_ratio;
  std::optional<double> p_value;  ///< of no difference between published and measured, where that was tested
  Verdict verdict{Verdict::no_reference};
  std::string note;

  /// measured / published - 1, where that means something.
  std::optional<double> deviation_ratio() const;
};

/// Sets the verdict from the numbers; `is_count` compares totals.
void judge(StudyRow& row, bool is_count);

/// A run of a study that is made to be looked at.
struct ShownRun {
  std::string name;  ///< as `study --only` takes it
  RunSpec spec;      ///< with its key under the options
  Scenario scenario;
  /// Makes it, and gives its measures, the same as stored ones; these sinks see every frame. Throws
  /// RunAbandoned if stopped.
  std::function<std::vector<Measure>(std::span<FrameSink* const>)> make;
};

struct StudyOptions {
  unsigned jobs{0};  ///< threads; 0 = as many as the machine has
  int seeds{20};     ///< variations per cell beyond what was published; 0 = the published part alone
  Store* store{nullptr};
  Progress* progress{nullptr};
  const std::atomic<bool>* stop{nullptr};
  std::string command;  ///< as typed, for the report
  Overrides overrides;  ///< put into every scenario, figures included, as by `run --set`
  std::string
      only;     ///< a run's name, its key, or how one of these begins: this run alone is shown, none is made
  Shard shard;  ///< the runs that are made; unless it is all of them, nothing is made of them
  std::function<void(const ShownRun&)> show;  ///< is given the runs that figures show, or `only` that one
  std::function<std::string(const RunSpec&)> playback;  ///< where the report finds a run's playback, or ""
};

/// What a study found.
struct StudyResult {
  std::vector<StudyRow> rows;
  nlohmann::json page;  ///< report document, as viewer/README.md describes it
  bool complete{true};  ///< false if stopped before all runs were made, or if one or a shard was wanted alone
};

/// A published experiment and what goes beyond it.
struct Study {
  std::string_view name;
  std::string_view title;
  std::string_view source;
  std::function<StudyResult(const StudyOptions&)> run;
};

/// Every study that comes with fairway.
std::span<const Study> builtin_studies();

/// Throws InputError with the nearest known name.
const Study& find_study(std::string_view name);

/// The names, numbers and verdict of a row, as `study --json` and the tables of reports have them.
nlohmann::json row_json(const StudyRow& row);

/// `study --json`.
nlohmann::json rows_json(std::string_view study, std::span<const StudyRow> rows);

/// The rows as an aligned table.
std::string rows_text(std::span<const StudyRow> rows);

}  // namespace fairway
