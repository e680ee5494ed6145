// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/recording.hpp"

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/core/error.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/layout.hpp"
#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/messages.hpp"
#include "fairway/record/schemas.hpp"
#include "fairway/record/sketch_messages.hpp"

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

// Puts messages together to frames. A frame's mark comes first, then every vehicle's odometry and status.
class Recording::Assembly {
 public:
  Assembly(Recording& recording, const McapReader& mcap) : recording_{recording}, mcap_{mcap} {}

  // `topic` as in the metadata
  void add_vehicle(const std::string& topic) {
    const std::size_t index = recording_.info_.vehicles.size() - 1;
    find_channel(topic + "/" + std::string(layout::odometry_topic), odometry_schema(),
                 {Role::odometry, index});
    find_channel(topic + "/" + std::string(layout::status_topic), vehicle_status_schema(),
                 {Role::status, index});
    if (recording_.info_.perception) {
      find_channel(topic + "/" + std::string(layout::tracks_topic), tracks_schema(), {Role::tracks, index});
      find_channel(topic + "/" + std::string(layout::echoes_topic), echoes_schema(), {Role::echoes, index});
    }
    if (recording_.info_.sketches)
      find_channel(topic + "/" + std::string(layout::sketch_topic), sketch_schema(), {Role::sketch, index});
  }

  void read_frames() {
    find_channel(std::string(layout::frame_topic), frame_schema(), {Role::frame, 0});
    if (recording_.info_.perception) {
      find_channel(std::string(layout::perception_topic), perception_schema(), {Role::perception, 0});
    }
    if (recording_.info_.sketches)
      find_channel(std::string(layout::flights_topic), flights_schema(), {Role::flights, 0});
    shown_.resize(recording_.info_.vehicles.size());
    mcap_.for_each_message([this](const McapReader::Message& message) { see(message); });
    finish_frame();

    // the buffers move no more
    std::size_t offset = 0;
    for (std::size_t i = 0; i < counts_.size(); offset += counts_[i++]) {
      recording_.vehicles_[i].actuators = std::span{recording_.actuators_}.subspan(offset, counts_[i]);
    }
    for (std::size_t i = 0; i < history_.size(); ++i) {
      recording_.vehicles_[i].tracks = history_[i].tracks.of(recording_.tracks_);
      recording_.vehicles_[i].echoes = history_[i].echoes.of(recording_.echoes_);
      recording_.vehicles_[i].strokes = history_[i].strokes.of(recording_.strokes_);
    }
    verify();
  }

 private:
  enum class Role { frame, odometry, status, perception, tracks, echoes, flights, sketch };
  /// What a vehicle perceived and drew, as last written.
  struct Shown {
    Part tracks;
    Part echoes;
    Part strokes;
  };
  struct Target {
    Role role{};
    std::size_t vehicle{};
  };

  void find_channel(const std::string& topic, const MessageSchema& type, Target target) {
    for (const auto& [id, channel] : mcap_.channels()) {
      if (channel.topic != topic) continue;
      const auto schema = mcap_.schemas().find(channel.schema);
      if (channel.encoding != "cdr" || schema == mcap_.schemas().end() || schema->second.name != type.name ||
          schema->second.text != type.text) {
        damaged("topic " + topic + " is not the " + std::string(type.name) + " that this fairway knows");
      }
      if (!targets_.emplace(id, target).second) damaged("topic " + topic + " belongs to two vehicles");
      return;
    }
    damaged("topic " + topic + " is missing");
  }

  void see(const McapReader::Message& message) {
    const auto found = targets_.find(message.channel);
    if (found == targets_.end()) return;
    const auto [role, vehicle] = found->second;
    if (role == Role::frame) {
      finish_frame();
      begin_frame(decode_frame(message.data));
      return;
    }
    if (role != Role::odometry && role != Role::status) {
      see_shown(role, vehicle, message.data);
      return;
    }

    // each vehicle's messages once a frame, status in order, so that the actuators lie in order
    if (recording_.marks_.empty()) damaged("a vehicle before the first frame");
    VehicleFrame& v =
        recording_.vehicles_[recording_.vehicles_.size() - recording_.info_.vehicles.size() + vehicle];
    std::size_t& next = role == Role::odometry ? next_odometry_ : next_status_;
    if (next++ != vehicle) incomplete();
    if (role == Role::odometry) {
      v.state = decode_odometry(message.data);
    } else {
      const std::size_t before = recording_.actuators_.size();
      if (decode_status(message.data, v, recording_.actuators_) != recording_.marks_.back().tick)
        incomplete();
      counts_.push_back(recording_.actuators_.size() - before);
    }
  }

  // behind the vehicles: the mark, and what is not as in the frame before
  void see_shown(Role role, std::size_t vehicle, ByteView message) {
    if (recording_.marks_.empty()) damaged("what a vehicle perceives or draws before the first frame");
    switch (role) {
      case Role::tracks:
        shown_[vehicle].tracks = appended(message, recording_.tracks_, decode_tracks);
        break;
      case Role::echoes:
        shown_[vehicle].echoes = appended(message, recording_.echoes_, decode_echoes);
        break;
      case Role::sketch:
        shown_[vehicle].strokes = appended(message, recording_.strokes_, decode_sketch);
        ++sketch_count_;
        break;
      case Role::flights:
        under_way_ = appended(message, recording_.flights_, decode_flights);
        ++flights_count_;
        break;
      default:
        see_perception(decode_perception(message));
    }
  }

  void see_perception(const PerceptionMark& mark) {
    if (mark.tick != recording_.marks_.back().tick) incomplete("all that was perceived");
    recording_.perception_hashes_.push_back(mark.hash);
  }

  template <class T>
  static Part appended(ByteView message, std::vector<T>& buffer, void (*decode)(ByteView, std::vector<T>&)) {
    const std::size_t begin = buffer.size();
    decode(message, buffer);
    return {begin, buffer.size()};
  }

  void begin_frame(const FrameMark& mark) {
    auto& marks = recording_.marks_;
    if (!marks.empty() && mark.tick <= marks.back().tick) damaged("ticks do not ascend");
    marks.push_back({mark.tick, mark.time, mark.period, {}});
    recording_.hashes_.push_back(mark.hash);
    recording_.vehicles_.resize(recording_.vehicles_.size() + recording_.info_.vehicles.size());
    next_odometry_ = next_status_ = 0;
  }

  void finish_frame() {
    if (recording_.marks_.empty()) return;
    const std::size_t vehicles = recording_.info_.vehicles.size();
    if (next_odometry_ != vehicles || next_status_ != vehicles) incomplete();
    const RecordingInfo& info = recording_.info_;
    if (info.perception && recording_.perception_hashes_.size() != recording_.marks_.size())
      incomplete("all that was perceived");
    // all of it is in the first frame
    if (info.sketches && (sketch_count_ < vehicles || flights_count_ == 0)) incomplete("all that was drawn");
    recording_.marks_.back().flights = under_way_;
    if (info.perception || info.sketches) history_.insert(history_.end(), shown_.begin(), shown_.end());
  }

  void verify() const {
    for (std::size_t i = 0; i < recording_.size(); ++i) {
      const Frame frame = recording_.frame(i);
      const bool perceived =
          !recording_.info_.perception || perception_hash(frame) == recording_.perception_hashes_[i];
      if (perceived && frame_hash(frame) == recording_.hashes_[i]) continue;
      damaged("the frame at tick " + std::to_string(count(frame.tick)) + " has not its recorded hash");
    }
  }

  [[noreturn]] void incomplete(const char* missing = "all its vehicles") const {
    damaged("the frame at tick " + std::to_string(count(recording_.marks_.back().tick)) + " has not " +
            missing);
  }

  Recording& recording_;
  const McapReader& mcap_;
  std::map<std::uint16_t, Target> targets_;
  std::vector<std::size_t> counts_;  // of actuators, by vehicle and frame
  std::vector<Shown> shown_;         // by vehicle, at present
  std::vector<Shown> history_;       // likewise, frame after frame
  Part under_way_;                   // messages, at present
  std::size_t sketch_count_{};       // read so far
  std::size_t flights_count_{};      // likewise
  std::size_t next_odometry_{};
  std::size_t next_status_{};
};

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
    recording.run_frame_count_ = number_entry<std::uint64_t>(end, "run_frame_count");
    if (number_entry<std::uint64_t>(end, "frame_count") != recording.size()) damaged("frames are missing");
    return recording;
  } catch (const Malformed& error) {
    throw InputError{{.file = file}, "", error.what()};
  } catch (const nlohmann::json::exception& error) {
    throw InputError{{.file = file}, "", std::string("damaged recording: list of vehicles: ") + error.what()};
  }
}

Recording Recording::read(const std::string& file) {
  const auto refuse = [&](const std::string& reason) {
    throw InputError{{.file = file}, "", "cannot be read: " + reason + "; expected a recording (MCAP)"};
  };
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) refuse(error.message());
  Bytes bytes(static_cast<std::size_t>(size));
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{std::fopen(file.c_str(), "rb"), std::fclose};
  if (!stream || std::fread(bytes.data(), 1, bytes.size(), stream.get()) != bytes.size()) {
    refuse(std::generic_category().message(errno));
  }
  return parse(bytes, file);
}

Frame Recording::frame(std::size_t i) const {
  const std::size_t n = info_.vehicles.size();
  const Mark& mark = marks_[i];
  return {.tick = mark.tick,
          .time = mark.time,
          .period = mark.period,
          .vehicles = std::span{vehicles_}.subspan(i * n, n),
          .flights = mark.flights.of(flights_)};
}

void Recording::play(FrameSink& sink) const {
  for (std::size_t i = 0; i < size(); ++i) sink.write(frame(i));
}

}  // namespace fairway
