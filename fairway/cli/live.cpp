// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/live.hpp"

#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <thread>

#include "fairway/experiment/version.hpp"
#include "fairway/view/live/live_server.hpp"

namespace fairway::cli {
namespace {

void wait_for(const std::atomic<bool>& stop) {
  while (!stop.load(std::memory_order_relaxed)) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace

RunOutcome run_live(const Scenario& scenario, const RecordingChoice& recording, const LiveChoice& choice,
                    std::ostream& out, const Program& program) {
  const Simulation accepted{scenario, program.catalogs};  // or it says here what is wrong with the scenario
  LiveRun run{scenario, {.speed = choice.speed, .paused = choice.paused}, {}, &program.catalogs.avoiders};
  LiveServer server{choice.port};
  const PlaybackInfo info{.version = std::string(fairway_version),
                          .command = program.typed,
                          .period = scenario.step_s,
                          .explanation = {}};
  const auto open = [&] {
    server.serve([answers = LiveAnswers{live_page(scenario, info), server.port(), run}](
                     const LiveRequest& request) { return answers.answer(request); });
    out << fmt::format("live: http://127.0.0.1:{}/", server.port()) << std::endl;
  };

  const Watch watch{run, open};
  RunOutcome outcome = run_scenario(scenario, recording, program, &watch);
  run.finish(divergence_text(scenario, outcome));
  if (outcome.complete && !choice.until_done) {
    const std::string how = outcome.divergence ? divergence_text(scenario, outcome) : "the run is over";
    std::cerr << "live: " << how << "; it stays to be seen; Ctrl-C ends it\n";
    wait_for(*program.stop);
  }
  return outcome;
}

}  // namespace fairway::cli
