// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/recording.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "fairway/core/error.hpp"
#include "fairway/record/layout.hpp"
#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/recording_assembly.hpp"
#include "fairway/scenario/tree.hpp"

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
std::optional<T> number_told(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

template <class T>
T number_entry(const McapReader::Map& map, const std::string& key) {
  const std::string& text = entry(map, key);
  const std::optional<T> value = number_told<T>(text);
  if (!value) damaged(key + " is '" + text + "'; expected a number");
  return *value;
}

double period_entry(const McapReader::Map& run) {
  const auto period = number_entry<double>(run, "period_s");
  if (!(period > 0.0 && std::isfinite(period)))
    damaged("period_s is '" + entry(run, "period_s") + "'; expected a positive number");
  return period;
}

std::int64_t stride_entry(const McapReader::Map& run) {
  const auto stride = number_entry<std::int64_t>(run, "stride");
  if (stride < 1) damaged("stride is " + std::to_string(stride) + "; expected 1 or more");
  return stride;
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

/// All that is told before the frames, but for the vehicles.
RecordingInfo told_info(const McapReader& mcap, const McapReader::Map& run) {
  RecordingInfo info;
  info.version = entry(run, "version");
  info.scenario_name = entry(run, "scenario");
  info.seed = number_entry<std::uint64_t>(run, "seed");
  info.period = period_entry(run);
  if (const auto program = run.find("program"); program != run.end()) info.program = program->second;
  if (const auto machine = run.find("machine"); machine != run.end()) info.machine = machine->second;
  info.perception = says_true(run, "perception");
  info.sketches = says_true(run, "sketches");
  const auto scenario = mcap.attachments().find(std::string(layout::scenario_attachment));
  if (scenario == mcap.attachments().end()) damaged("the scenario is missing");
  info.scenario_yaml = scenario->second;
  return info;
}

/// What the recording and the scenario in it both tell, they tell alike.
void expect_agreement(const McapReader::Map& run, const RecordingInfo& info, const std::string& file) {
  const yaml::Tree scenario = yaml::parse_tree(info.scenario_yaml, file + " (scenario)");
  const auto agree = [&](const std::string& name, const std::string& key, auto value) {
    const yaml::Tree* told = scenario.find(key);
    if (told == nullptr || number_told<decltype(value)>(told->text) == value) return;
    damaged(name + " is " + entry(run, name) + ", and its scenario has " + key + ": " +
            yaml::shown(told->text));
  };
  agree("seed", "seed", info.seed);
  agree("period_s", "step_s", info.period);
}

/// Of the frames of the run the first is kept, and then one in every stride.
void expect_counts(const McapReader::Map& end, const Recording& recording) {
  if (number_entry<std::uint64_t>(end, "frame_count") != recording.size()) damaged("frames are missing");
  const std::uint64_t run = recording.run_frame_count();
  const auto stride = static_cast<std::uint64_t>(recording.stride());
  if ((run == 0 ? 0 : (run - 1) / stride + 1) != recording.size())
    damaged("of " + std::to_string(run) + " frames it has " + std::to_string(recording.size()) +
            "; expected one in " + std::to_string(stride));
}

/// Text of a file may have line breaks, and a message is one line.
std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return text;
}

}  // namespace

Recording Recording::parse(ByteView bytes, const std::string& file) {
  try {
    const McapReader mcap{bytes};
    const auto& run = check_origin(mcap);
    Recording recording;
    RecordingInfo& info = recording.info_ = told_info(mcap, run);
    recording.stride_ = stride_entry(run);
    expect_agreement(run, info, file);

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
    if (recording.stopped_ && !recording.divergence_.empty()) damaged("its run broke and was stopped");
    expect_counts(end, recording);
    return recording;
  } catch (const Malformed& error) {
    throw InputError{{.file = file}, "", in_one_line(error.what())};
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
