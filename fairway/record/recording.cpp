// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/recording.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

#include "fairway/core/error.hpp"
#include "fairway/record/layout.hpp"
#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/recording_assembly.hpp"

namespace fairway {

namespace {

const McapReader::Map& metadata(const McapReader& mcap, std::string_view name) {
  const auto found = mcap.metadata().find(std::string(name));
  if (found == mcap.metadata().end()) damaged("metadata '" + std::string(name) + "' is missing");
  return found->second;
}

const std::string& entry(const McapReader::Map& map, const std::string& key) {
  const auto found = map.find(key);
  if (found == map.end()) damaged("metadata entry '" + key + "' is missing");
  return found->second;
}

template <class T>
T number_entry(const McapReader::Map& map, const std::string& key) {
  const std::string& text = entry(map, key);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    damaged(key + " is '" + text + "'; expected a number");
  return value;
}

bool says_true(const McapReader::Map& map, const std::string& key) {
  const auto found = map.find(key);
  return found != map.end() && found->second == "true";
}

// A recording of ours, in this format.
const McapReader::Map& check_origin(const McapReader& mcap) {
  if (!mcap.metadata().contains(std::string(layout::run_metadata))) {
    throw Malformed{"not a recording of fairway: an MCAP file by '" + mcap.library() + "'"};
  }
  const auto& run = metadata(mcap, layout::run_metadata);
  const int format = number_entry<int>(run, "format");
  if (format < 1) damaged("format is " + std::to_string(format) + "; expected 1 or more");
  if (format != layout::format) {
    throw Malformed{"a recording of format " + std::to_string(format) + ", made by fairway " +
                    entry(run, "version") + "; expected format " + std::to_string(layout::format) +
                    (format > layout::format ? ": use a newer fairway" : ": run its scenario again")};
  }
  return run;
}

}  // namespace

Recording Recording::parse(ByteView bytes, const std::string& file) {
  try {
    const McapReader mcap{bytes};
    const auto& run = check_origin(mcap);
    Recording recording;
    RecordingInfo& info = recording.info_;
    info.version = entry(run, "version");
    info.scenario_name = entry(run, "scenario");
    info.seed = number_entry<std::uint64_t>(run, "seed");
    info.period = number_entry<double>(run, "period_s");
    recording.stride_ = number_entry<std::int64_t>(run, "stride");
    if (const auto program = run.find("program"); program != run.end()) info.program = program->second;
    if (const auto machine = run.find("machine"); machine != run.end()) info.machine = machine->second;
    info.perception = says_true(run, "perception");
    info.sketches = says_true(run, "sketches");
    const auto scenario = mcap.attachments().find(std::string(layout::scenario_attachment));
    if (scenario == mcap.attachments().end()) damaged("the scenario is missing");
    info.scenario_yaml = scenario->second;

    Assembly assembly{recording, mcap};
    for (const auto& v : nlohmann::json::parse(entry(run, "vehicles"))) {
      info.vehicles.push_back({.id = VehicleId{v.at("id").get<std::uint32_t>()},
                               .name = v.at("name").get<std::string>(),
                               .model = v.at("model").get<std::string>()});
      assembly.add_vehicle(v.at("topic").get<std::string>());
    }
    assembly.read_frames();

    const auto& end = metadata(mcap, layout::end_metadata);
    recording.run_hash_ = number_entry<std::uint64_t>(end, "run_hash");
    if (info.perception) recording.run_perception_hash_ = number_entry<std::uint64_t>(end, "perception_hash");
    recording.stopped_ = says_true(end, "stopped");
    recording.run_frame_count_ = number_entry<std::uint64_t>(end, "run_frame_count");
    if (const auto broke = end.find(std::string(layout::divergence)); broke != end.end())
      recording.divergence_ = broke->second;
    if (number_entry<std::uint64_t>(end, "frame_count") != recording.size()) damaged("frames are missing");
    return recording;
  } catch (const Malformed& error) {
    throw InputError{{.file = file}, "", error.what()};
  } catch (const nlohmann::json::exception& error) {
    throw InputError{{.file = file}, "", std::string("damaged recording: list of vehicles: ") + error.what()};
  }
}

Frame Recording::frame(std::size_t i) const {
  const std::size_t n = info_.vehicles.size();
  const Mark& mark = marks_[i];
  return {.tick = mark.tick,
          .time = mark.time,
          .period = mark.period,
          .vehicles = std::span{vehicles_}.subspan(i * n, n),
          .flights = mark.flights.of(flights_),
          .words = mark.words.of(words_)};
}

void Recording::play(FrameSink& sink) const {
  for (std::size_t i = 0; i < size(); ++i) sink.write(frame(i));
}

}  // namespace fairway
