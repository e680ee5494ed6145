// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/explain_recording.hpp"

#include "fairway/experiment/recording_info.hpp"
#include "fairway/view/explain/instant.hpp"
#include "fairway/view/playback.hpp"

namespace fairway {
namespace {

/// What the page shows before and after the instant [s].
constexpr double window_s = 30.0;

void write_explanation(const ExplainQuestion& question, const Scenario& scenario,
                       const RecordingInfo& recorded, const Film& film, const Explanation& explanation) {
  const PlaybackInfo info{recorded.version, question.command, recorded.period, page_json(explanation)};
  write_playback(question.page, playback_document(scenario, info, &film));
}

}  // namespace

std::optional<ExplainedRecording> explain_recording(const Recording& recording,
                                                    const ExplainQuestion& question, const Catalogs& catalogs,
                                                    const std::atomic<bool>* stop) {
  const Instant instant{vehicle_called(recording.info(), question.vehicle),
                        frame_at(recording, question.time)};
  Scenario scenario = recorded_scenario(recording, question.recording);
  check_methods(recording, scenario, catalogs, question.recording);
  const double time = recording.frame(instant.frame).time;
  Film film{scenario, {.from_s = time - window_s, .to_s = time + window_s}, &catalogs.avoiders};
  DecisionWindow window;
  if (!question.page.empty()) window = {window_s, window_s, &film};

  std::optional<FoundDecision> found;
  try {
    found = find_decision(recording, scenario, catalogs, instant, window, stop);
  } catch (const InputError& error) {
    throw InputError(question.recording + ": " + error.what());
  }
  if (!found) return {};

  film.finish(recording.divergence());
  Explanation explanation = explain(scenario, *found, catalogs.avoiders);
  if (!question.page.empty()) write_explanation(question, scenario, recording.info(), film, explanation);
  return ExplainedRecording{std::move(scenario), std::move(*found), std::move(explanation)};
}

}  // namespace fairway
