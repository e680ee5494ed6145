// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>

#include "fairway/cli/runner.hpp"

namespace fairway::cli {

/// How a run is shown while it is made.
struct LiveChoice {
  bool asked{false};
  bool paused{false};
  bool until_done{false};  ///< ends with the run, instead of serving on
  std::uint16_t port{0};   ///< 0: any that is free
  double speed{1.0};       ///< seconds of the run per second; 0: as fast as it can
};

/// As run_scenario(), serving the page that shows it, whose address goes to `out` first, until it is
/// told to stop.
/// Stopped after the run was over, it is complete.
RunOutcome run_live(const Scenario& scenario, const RecordingChoice& recording, const LiveChoice& choice,
                    std::ostream& out, const Program& program);

}  // namespace fairway::cli
