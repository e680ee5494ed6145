// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/messages.hpp"
#include "fairway/record/recording.hpp"
#include "fairway/record/schemas.hpp"

namespace fairway {

/// Puts messages together to frames: a frame's mark comes first, then every vehicle's odometry and status,
/// then what is shown besides. Throws Malformed.
class Recording::Assembly {
 public:
  Assembly(Recording& recording, const McapReader& mcap) : recording_{recording}, mcap_{mcap} {
    for (const auto& [id, channel] : mcap.channels()) by_topic_.emplace(channel.topic, id);
  }

  /// The last of the recording's vehicles, with its `topic` as in the metadata.
  void add_vehicle(const std::string& topic);

  /// All of them, behind the last vehicle. O(messages).
  void read_frames();

 private:
  enum class Role { frame, odometry, status, perception, tracks, echoes, flights, sketch, words };
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

  void find_channel(std::string_view topic, const MessageSchema& type, Target target);
  bool has_channel(std::string_view topic) const { return by_topic_.contains(topic); }

  void see(const McapReader::Message& message);
  void see_vehicle(Role role, std::size_t vehicle, ByteView message);
  void see_shown(Role role, std::size_t vehicle, ByteView message);
  void see_perception(const PerceptionMark& mark);
  void see_word(SpokenWord word);
  void begin_frame(const FrameMark& mark);
  void finish_frame();

  void point_into_buffers();
  void share_out_words();
  void verify() const;
  [[noreturn]] void incomplete(const char* missing = "all its vehicles") const;

  Recording& recording_;
  const McapReader& mcap_;
  const RecordingInfo& info_ = recording_.info_;
  std::unordered_map<std::string_view, std::uint16_t> by_topic_;  // of several channels the first
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

}  // namespace fairway
