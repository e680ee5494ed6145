// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/studies/study.hpp"

namespace fairway::cli {

/// What is kept of one run of a study beside its measures; nothing where a path is empty.
struct KeptRun {
  std::filesystem::path recording;  ///< MCAP
  std::filesystem::path playback;   ///< HTML
};

/// "runs/cube20_8-orca3d-corrected-1-3fa9c2d1.html", from the folder of the study's report: the run's name
/// and a digest of its key, so that a changed scenario has another page.
std::string playback_path(const RunSpec& spec);

/// Makes a run, and its recording and playback, in which `avoiders` read what was said. Throws InputError if
/// a file cannot be written, RunAbandoned if stopped; then neither is there.
std::vector<Measure> make_shown(const ShownRun& run, const KeptRun& kept, const Catalog& avoiders);

/// The measures to the bit, one a line; or as JSON.
void print_shown(const ShownRun& run, const std::vector<Measure>& measures, bool as_json);

}  // namespace fairway::cli
