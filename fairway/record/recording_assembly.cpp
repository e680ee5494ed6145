// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/recording_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "fairway/core/text.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/layout.hpp"
#include "fairway/record/sketch_messages.hpp"
#include "fairway/record/word_messages.hpp"

namespace fairway {

void Recording::Assembly::add_vehicle(const std::string& topic) {
  const std::size_t index = info_.vehicles.size() - 1;
  const auto find = [&](std::string_view name, const MessageSchema& type, Role role) {
    find_channel(topic + "/" + std::string(name), type, {role, index});
  };
  find(layout::odometry_topic, odometry_schema(), Role::odometry);
  find(layout::status_topic, vehicle_status_schema(), Role::status);
  if (info_.perception) {
    find(layout::tracks_topic, tracks_schema(), Role::tracks);
    find(layout::echoes_topic, echoes_schema(), Role::echoes);
  }
  if (info_.sketches) find(layout::sketch_topic, sketch_schema(), Role::sketch);
}

void Recording::Assembly::read_frames() {
  find_channel(layout::frame_topic, frame_schema(), {Role::frame, 0});
  if (info_.perception) find_channel(layout::perception_topic, perception_schema(), {Role::perception, 0});
  if (info_.sketches) find_channel(layout::flights_topic, flights_schema(), {Role::flights, 0});
  if (has_channel(layout::words_topic)) find_channel(layout::words_topic, word_schema(), {Role::words, 0});
  shown_.resize(info_.vehicles.size());

  mcap_.for_each_message([this](const McapReader::Message& message) { see(message); });
  finish_frame();
  point_into_buffers();
  share_out_words();
  verify();
}

void Recording::Assembly::find_channel(std::string_view topic, const MessageSchema& type, Target target) {
  const auto found = by_topic_.find(topic);
  if (found == by_topic_.end()) damaged("topic " + std::string(topic) + " is missing");
  const auto& channel = mcap_.channels().at(found->second);
  const auto schema = mcap_.schemas().find(channel.schema);
  if (channel.encoding != "cdr" || schema == mcap_.schemas().end() || schema->second.name != type.name ||
      schema->second.text != type.text) {
    damaged("topic " + channel.topic + " is not the " + std::string(type.name) + " that this fairway knows");
  }
  if (!targets_.emplace(found->second, target).second)
    damaged("topic " + channel.topic + " belongs to two vehicles");
}

void Recording::Assembly::see(const McapReader::Message& message) {
  const auto found = targets_.find(message.channel);
  if (found == targets_.end()) return;
  const auto [role, vehicle] = found->second;
  if (role == Role::frame) {
    finish_frame();
    begin_frame(decode_frame(message.data));
  } else if (role == Role::odometry || role == Role::status) {
    see_vehicle(role, vehicle, message.data);
  } else if (role == Role::words) {
    see_word(decode_word(message.data));
  } else {
    see_shown(role, vehicle, message.data);
  }
}

// each vehicle's messages once a frame, status in order, so that the actuators lie in order
void Recording::Assembly::see_vehicle(Role role, std::size_t vehicle, ByteView message) {
  if (recording_.marks_.empty()) damaged("a vehicle before the first frame");
  VehicleFrame& v = recording_.vehicles_[recording_.vehicles_.size() - info_.vehicles.size() + vehicle];
  std::size_t& next = role == Role::odometry ? next_odometry_ : next_status_;
  if (next++ != vehicle) incomplete();
  if (role == Role::odometry) {
    v.state = decode_odometry(message);
    return;
  }
  const std::size_t before = recording_.actuators_.size();
  if (decode_status(message, v, recording_.actuators_) != recording_.marks_.back().tick) incomplete();
  counts_.push_back(recording_.actuators_.size() - before);
}

// behind the vehicles: the mark, and what is not as in the frame before
void Recording::Assembly::see_shown(Role role, std::size_t vehicle, ByteView message) {
  if (recording_.marks_.empty()) damaged("what a vehicle perceives or draws before the first frame");
  const auto appended = [message](auto& buffer, const auto& decode) -> Part {
    const std::size_t begin = buffer.size();
    decode(message, buffer);
    return {begin, buffer.size()};
  };
  switch (role) {
    case Role::tracks:
      shown_[vehicle].tracks = appended(recording_.tracks_, decode_tracks);
      break;
    case Role::echoes:
      shown_[vehicle].echoes = appended(recording_.echoes_, decode_echoes);
      break;
    case Role::sketch:
      shown_[vehicle].strokes = appended(recording_.strokes_, decode_sketch);
      ++sketch_count_;
      break;
    case Role::flights:
      under_way_ = appended(recording_.flights_, decode_flights);
      ++flights_count_;
      break;
    default:
      see_perception(decode_perception(message));
  }
}

void Recording::Assembly::see_perception(const PerceptionMark& mark) {
  if (mark.tick != recording_.marks_.back().tick) incomplete("all that was perceived");
  recording_.perception_hashes_.push_back(mark.hash);
}

void Recording::Assembly::see_word(SpokenWord word) {
  std::vector<SpokenWord>& words = recording_.words_;
  if (word.from >= info_.vehicles.size()) damaged("a word of a vehicle that is not there");
  if (recording_.marks_.empty() || !(word.sent >= (words.empty() ? 0.0 : words.back().sent)))
    damaged("words are not in order");
  words.push_back(word);
}

void Recording::Assembly::begin_frame(const FrameMark& mark) {
  auto& marks = recording_.marks_;
  if (!marks.empty() && mark.tick <= marks.back().tick) damaged("ticks do not ascend");
  if (!(mark.time >= (marks.empty() ? 0.0 : marks.back().time) && std::isfinite(mark.time)))
    damaged("the frame at tick " + std::to_string(count(mark.tick)) + " is at " + number_text(mark.time) +
            " s; expected times that ascend from 0");
  marks.push_back({mark.tick, mark.time, mark.period, {}});
  recording_.hashes_.push_back(mark.hash);
  recording_.vehicles_.resize(recording_.vehicles_.size() + info_.vehicles.size());
  next_odometry_ = next_status_ = 0;
}

void Recording::Assembly::finish_frame() {
  if (recording_.marks_.empty()) return;
  const std::size_t vehicles = info_.vehicles.size();
  if (next_odometry_ != vehicles || next_status_ != vehicles) incomplete();
  if (info_.perception && recording_.perception_hashes_.size() != recording_.marks_.size())
    incomplete("all that was perceived");
  // all of it is in the first frame
  if (info_.sketches && (sketch_count_ < vehicles || flights_count_ == 0)) incomplete("all that was drawn");
  recording_.marks_.back().flights = under_way_;
  if (info_.perception || info_.sketches) history_.insert(history_.end(), shown_.begin(), shown_.end());
}

// once the buffers move no more
void Recording::Assembly::point_into_buffers() {
  std::size_t offset = 0;
  for (std::size_t i = 0; i < counts_.size(); offset += counts_[i++]) {
    recording_.vehicles_[i].actuators = std::span{recording_.actuators_}.subspan(offset, counts_[i]);
  }
  for (std::size_t i = 0; i < history_.size(); ++i) {
    recording_.vehicles_[i].tracks = history_[i].tracks.of(recording_.tracks_);
    recording_.vehicles_[i].echoes = history_[i].echoes.of(recording_.echoes_);
    recording_.vehicles_[i].strokes = history_[i].strokes.of(recording_.strokes_);
  }
}

// each to the first frame that is not before it
void Recording::Assembly::share_out_words() {
  const std::vector<SpokenWord>& words = recording_.words_;
  std::size_t end = 0;
  for (auto& mark : recording_.marks_) {
    const std::size_t begin = end;
    while (end < words.size() && words[end].sent <= mark.time) ++end;
    mark.words = {begin, end};
  }
}

void Recording::Assembly::verify() const {
  for (std::size_t i = 0; i < recording_.size(); ++i) {
    const Frame frame = recording_.frame(i);
    const bool perceived = !info_.perception || perception_hash(frame) == recording_.perception_hashes_[i];
    if (perceived && frame_hash(frame) == recording_.hashes_[i]) continue;
    damaged("the frame at tick " + std::to_string(count(frame.tick)) + " has not its recorded hash");
  }
}

void Recording::Assembly::incomplete(const char* missing) const {
  damaged("the frame at tick " + std::to_string(count(recording_.marks_.back().tick)) + " has not " +
          missing);
}

}  // namespace fairway
