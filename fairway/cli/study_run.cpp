// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/study_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "fairway/core/text.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/sim/divergence.hpp"
#include "fairway/studies/study_runs.hpp"
#include "fairway/view/playback.hpp"

namespace fairway::cli {
namespace {

void write_playback_of(const ShownRun& run, const Film& film, const std::string& path) {
  const PlaybackInfo info{.version = std::string(fairway_version),
                          .command = command_of(run.spec),
                          .period = run.scenario.step_s,
                          .explanation = nullptr};
  write_playback(path, playback_document(run.scenario, info, &film));
}

}  // namespace

std::string playback_path(const RunSpec& spec) {
  std::string name = name_of(spec);
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view{"_+=."}.find(c) != std::string_view::npos;
  };
  std::ranges::replace_if(
      name, [&](char c) { return !is_plain(c); }, '-');
  return "runs/" + name + "-" + Digest::of(spec.key).substr(0, 8) + ".html";
}

std::vector<Measure> make_shown(const ShownRun& run, const KeptRun& kept, const Catalog& avoiders) {
  std::unique_ptr<RecordingWriter> writer;
  std::optional<Film> film;
  std::vector<FrameSink*> sinks;
  if (!kept.recording.empty()) {
    writer = std::make_unique<RecordingWriter>(kept.recording.string(), recording_info(run.scenario));
    sinks.push_back(writer.get());
  }
  if (!kept.playback.empty()) sinks.push_back(&film.emplace(run.scenario, FilmLimits{}, &avoiders));

  std::vector<Measure> measures;
  try {
    measures = run.make(sinks);
  } catch (const RunDiverged& broke) {
    if (writer) writer->close({.divergence = broke.what()});
    throw;
  }
  if (writer) writer->close();
  if (film) film->finish();
  if (film) write_playback_of(run, *film, kept.playback.string());
  return measures;
}

void print_shown(const ShownRun& run, const std::vector<Measure>& measures, bool as_json) {
  if (!as_json) {
    std::cout << run.name << "\n";
    for (const Measure& m : measures) {
      const std::string vehicle = m.vehicle == Measure::fleet ? "fleet" : std::to_string(m.vehicle);
      std::cout << fmt::format("  {:<32} {:>5}  {}\n", m.quantity, vehicle, number_text(m.value));
    }
    return;
  }
  nlohmann::json list = nlohmann::json::array();
  for (const Measure& m : measures) {
    list.push_back({{"quantity", m.quantity},
                    {"vehicle", m.vehicle == Measure::fleet ? nlohmann::json() : nlohmann::json(m.vehicle)},
                    {"value", std::isfinite(m.value) ? nlohmann::json(m.value) : nlohmann::json()}});
  }
  const nlohmann::json document{
      {"run", run.name}, {"key", run.spec.key}, {"seed", run.spec.seed}, {"measures", std::move(list)}};
  std::cout << document.dump(2) << "\n";
}

}  // namespace fairway::cli
