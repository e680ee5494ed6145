// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/recording_writer.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/layout.hpp"
#include "fairway/record/mcap_writer.hpp"
#include "fairway/record/messages.hpp"
#include "fairway/record/schemas.hpp"
#include "fairway/record/sketch_messages.hpp"
#include "fairway/record/word_messages.hpp"

namespace fairway {

namespace {

std::string topic_of(const std::string& vehicle, std::string_view topic) {
  return "/" + vehicle + "/" + std::string(topic);
}

std::string vehicles_json(const std::vector<RecordingInfo::Vehicle>& vehicles,
                          std::span<const std::string> topics) {
  auto list = nlohmann::json::array();
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const auto& v = vehicles[i];
    list.push_back({{"id", number(v.id)}, {"name", v.name}, {"model", v.model}, {"topic", "/" + topics[i]}});
  }
  return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// MCAP numbers its channels by 16 bits. A vehicle has one for each kind of message, and a few are the run's.
void refuse_too_many(const RecordingInfo& info, const std::string& path) {
  constexpr std::size_t channels = 65'000;
  const std::size_t each = 2 + (info.perception ? 2 : 0) + (info.sketches ? 1 : 0);
  if (info.vehicles.size() > channels / each)
    throw InputError{{.file = path},
                     "",
                     "cannot hold " + std::to_string(info.vehicles.size()) +
                         " vehicles; with what is recorded of each it has room for " +
                         std::to_string(channels / each)};
}

/// What says of itself what no run has would not be read.
void refuse_unreadable(const RecordingInfo& info) {
  if (!(info.period > 0.0 && std::isfinite(info.period)))
    throw InputError{{}, "period_s", "is " + number_text(info.period) + "; expected a positive number"};
  const std::pair<const char*, const std::string*> texts[] = {{"version", &info.version},
                                                              {"scenario", &info.scenario_name},
                                                              {"program", &info.program},
                                                              {"machine", &info.machine}};
  for (const auto& [name, text] : texts)
    if (not_utf8(*text)) throw InputError{{}, name, "is not UTF-8; expected text in that encoding"};
}

std::uint16_t add_schema(McapWriter& mcap, const MessageSchema& schema) {
  return mcap.add_schema(schema.name, "ros2msg", schema.text);
}

}  // namespace

std::vector<std::string> topic_names(const std::vector<RecordingInfo::Vehicle>& vehicles) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  std::vector<std::string> names;
  std::unordered_set<std::string> taken;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    std::string name = vehicles[i].name;
    std::ranges::replace_if(name, std::not_fn(plain), '_');
    const bool unusable = name.empty() || (name[0] >= '0' && name[0] <= '9');
    if (unusable || taken.contains(name)) name = "vehicle_" + std::to_string(i);
    while (!taken.insert(name).second) name += '_';
    names.push_back(std::move(name));
  }
  return names;
}

RecordingWriter::RecordingWriter(std::string path, RecordingInfo info, std::int64_t stride)
    : path_{std::move(path)}, info_{std::move(info)}, stride_{stride} {
  if (stride_ < 1) throw InputError{{}, "stride", "is " + std::to_string(stride_) + "; expected 1 or more"};
  refuse_too_many(info_, path_);
  refuse_unreadable(info_);
  mcap_ = std::make_unique<McapWriter>(path_, "ros2", "fairway " + info_.version);
  const std::vector<std::string> topics = topic_names(info_.vehicles);
  shown_.resize(topics.size());
  add_vehicles(topics);
  if (info_.perception) add_perception(topics);
  if (info_.sketches) add_sketches(topics);
  describe_run(topics);
}

std::uint16_t RecordingWriter::add_channel(std::uint16_t schema, std::string_view topic) {
  // the profile "ros2" requires the key; empty means the usual quality of service
  return mcap_->add_channel(schema, topic, "cdr", {{"offered_qos_profiles", ""}});
}

void RecordingWriter::add_vehicles(std::span<const std::string> topics) {
  const std::uint16_t frame = add_schema(*mcap_, frame_schema());
  const std::uint16_t odometry = add_schema(*mcap_, odometry_schema());
  const std::uint16_t status = add_schema(*mcap_, vehicle_status_schema());
  const std::uint16_t transforms = add_schema(*mcap_, transforms_schema());
  frame_channel_ = add_channel(frame, layout::frame_topic);
  transforms_channel_ = add_channel(transforms, layout::transforms_topic);
  for (const std::string& topic : topics) {
    channels_.push_back({.odometry = add_channel(odometry, topic_of(topic, layout::odometry_topic)),
                         .status = add_channel(status, topic_of(topic, layout::status_topic))});
    child_frames_.push_back(topic + "/" + std::string(layout::body_frame));
  }
}

void RecordingWriter::add_perception(std::span<const std::string> topics) {
  const std::uint16_t perception = add_schema(*mcap_, perception_schema());
  const std::uint16_t tracks = add_schema(*mcap_, tracks_schema());
  const std::uint16_t echoes = add_schema(*mcap_, echoes_schema());
  perception_channel_ = add_channel(perception, layout::perception_topic);
  for (std::size_t i = 0; i < topics.size(); ++i) {
    channels_[i].tracks = add_channel(tracks, topic_of(topics[i], layout::tracks_topic));
    channels_[i].echoes = add_channel(echoes, topic_of(topics[i], layout::echoes_topic));
  }
}

void RecordingWriter::add_sketches(std::span<const std::string> topics) {
  const std::uint16_t sketch = add_schema(*mcap_, sketch_schema());
  const std::uint16_t flights = add_schema(*mcap_, flights_schema());
  flights_channel_ = add_channel(flights, layout::flights_topic);
  for (std::size_t i = 0; i < topics.size(); ++i) {
    channels_[i].sketch = add_channel(sketch, topic_of(topics[i], layout::sketch_topic));
  }
}

void RecordingWriter::describe_run(std::span<const std::string> topics) {
  McapWriter::Map run{{"format", std::to_string(layout::format)},
                      {"version", info_.version},
                      {"scenario", info_.scenario_name},
                      {"seed", std::to_string(info_.seed)},
                      {"period_s", number_text(info_.period)},
                      {"stride", std::to_string(stride_)},
                      {"vehicle_count", std::to_string(info_.vehicles.size())},
                      {"vehicles", vehicles_json(info_.vehicles, topics)}};
  if (info_.program != RecordingInfo{}.program) run.emplace_back("program", info_.program);
  if (!info_.machine.empty()) run.emplace_back("machine", info_.machine);
  if (info_.perception) run.emplace_back("perception", "true");
  if (info_.sketches) run.emplace_back("sketches", "true");
  mcap_->add_metadata(layout::run_metadata, run);
  mcap_->attach(layout::scenario_attachment, "application/yaml", info_.scenario_yaml);
}

RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::write(const Frame& frame) {
  if (!mcap_ || frame.vehicles.size() != channels_.size() || count(frame.tick) <= last_tick_) {
    throw InputError{{.file = path_},
                     "",
                     "a frame that does not follow cannot be recorded: tick " +
                         std::to_string(count(frame.tick)) + " with " +
                         std::to_string(frame.vehicles.size()) + " vehicles after tick " +
                         std::to_string(last_tick_) + " with " + std::to_string(channels_.size())};
  }
  const std::uint64_t hash = frame_hash(frame);
  run_hash_ = mix_hash(run_hash_, hash);
  const std::uint64_t perceived = info_.perception ? perception_hash(frame) : 0;
  if (info_.perception) perception_hash_ = mix_hash(perception_hash_, perceived);
  last_tick_ = count(frame.tick);
  if (frames_seen_++ % static_cast<std::uint64_t>(stride_) == 0) {
    write_state(frame, hash);
    if (info_.perception) write_perception(frame, perceived);
    if (info_.sketches) write_sketches(frame);
    ++frames_kept_;
  }
  write_words(frame);
}

// the frame, its vehicles, and their transforms for viewers
void RecordingWriter::write_state(const Frame& frame, std::uint64_t hash) {
  const Stamp stamp = stamp_of(frame.time);
  const double period = frame.period * static_cast<double>(stride_);
  encode_frame(message_, stamp, {.tick = frame.tick, .time = frame.time, .period = period, .hash = hash});
  mcap_->write(frame_channel_, stamp.nanoseconds, message_);
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
    const VehicleFrame& vehicle = frame.vehicles[i];
    encode_odometry(message_, stamp, child_frames_[i], vehicle.state);
    mcap_->write(channels_[i].odometry, stamp.nanoseconds, message_);
    encode_status(message_, stamp, frame.tick, vehicle);
    mcap_->write(channels_[i].status, stamp.nanoseconds, message_);
  }
  encode_transforms(message_, stamp, child_frames_, frame.vehicles);
  mcap_->write(transforms_channel_, stamp.nanoseconds, message_);
}

void RecordingWriter::write_perception(const Frame& frame, std::uint64_t hash) {
  const Stamp stamp = stamp_of(frame.time);
  encode_perception(message_, stamp, {frame.tick, hash});
  mcap_->write(perception_channel_, stamp.nanoseconds, message_);
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
    encode_tracks(message_, stamp, frame.vehicles[i].tracks);
    write_if_changed(channels_[i].tracks, stamp.nanoseconds, shown_[i].tracks);
    encode_echoes(message_, stamp, child_frames_[i], frame.vehicles[i].echoes);
    write_if_changed(channels_[i].echoes, stamp.nanoseconds, shown_[i].echoes);
  }
}

void RecordingWriter::write_sketches(const Frame& frame) {
  const Stamp stamp = stamp_of(frame.time);
  encode_flights(message_, stamp, frame.flights);
  write_if_changed(flights_channel_, stamp.nanoseconds, flights_);
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
    encode_sketch(message_, stamp, frame.vehicles[i].strokes);
    write_if_changed(channels_[i].sketch, stamp.nanoseconds, shown_[i].sketch);
  }
}

// every one, of frames that are left out too; where nobody speaks there is no topic
void RecordingWriter::write_words(const Frame& frame) {
  for (const SpokenWord& word : frame.words) {
    if (!words_channel_) words_channel_ = add_channel(add_schema(*mcap_, word_schema()), layout::words_topic);
    encode_word(message_, word);
    mcap_->write(*words_channel_, stamp_of(word.sent).nanoseconds, message_);
  }
}

void RecordingWriter::write_if_changed(std::uint16_t channel, std::uint64_t time, Bytes& last) {
  if (same_content(message_, last)) return;
  mcap_->write(channel, time, message_);
  std::swap(message_, last);
}

void RecordingWriter::close(const RunEnd& how) {
  if (!mcap_) return;
  McapWriter::Map end{{"frame_count", std::to_string(frames_kept_)},
                      {"run_frame_count", std::to_string(frames_seen_)},
                      {"run_hash", std::to_string(run_hash_)}};
  if (info_.perception) end.emplace_back("perception_hash", std::to_string(perception_hash_));
  if (!how.divergence.empty()) end.emplace_back(layout::divergence, how.divergence);
  if (how.stopped) end.emplace_back("stopped", "true");
  mcap_->add_metadata(layout::end_metadata, end);
  mcap_->finish();
  mcap_.reset();
}

}  // namespace fairway
