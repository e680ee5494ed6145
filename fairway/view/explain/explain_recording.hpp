// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>

#include "fairway/record/recording.hpp"
#include "fairway/sim/catalogs.hpp"
#include "fairway/view/explain/explanation.hpp"

namespace fairway {

/// What is asked about a recorded run.
struct ExplainQuestion {
  std::string recording;     ///< file, for messages
  std::string_view vehicle;  ///< name, id or index
  double time{};             ///< [s]
  std::string page;          ///< file for a page of what surrounds the instant, or empty
  std::string command;       ///< as typed, for the page
};

struct ExplainedRecording {
  Scenario scenario;
  FoundDecision found;
  Explanation explanation;
};

/// Simulates a recorded run again until the instant asked about, explains the decision in force then, and
/// writes the page if one is asked for. `stop`, if not null, ends it early: then there is no answer. Throws
/// InputError as find_decision(), with the recording's name, and where `catalogs` lack a method of the run.
std::optional<ExplainedRecording> explain_recording(const Recording& recording,
                                                    const ExplainQuestion& question, const Catalogs& catalogs,
                                                    const std::atomic<bool>* stop);

}  // namespace fairway
