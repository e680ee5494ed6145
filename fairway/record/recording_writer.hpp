// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/record/bytes.hpp"
#include "fairway/record/frame.hpp"
#include "fairway/record/output_check.hpp"

namespace fairway {

class McapWriter;

/// As RecordingWriter writes it.
inline constexpr FileKind recording_file{
    .name = "a recording of fairway", .begins = "\x89MCAP0\r\n", .holds = "fairway "};

/// How a recorded run ended.
struct RunEnd {
  std::string divergence;  ///< how it broke behind the last frame, in a line; empty if it is whole
  bool stopped{false};     ///< before its end
};

/// What a recording says of the run as a whole.
struct RecordingInfo {
  struct Vehicle {
    VehicleId id{};
    std::string name;
    std::string model;  ///< of the vehicle catalog

    friend bool operator==(const Vehicle&, const Vehicle&) = default;
  };

  std::string version;  ///< of fairway
  std::string scenario_name;
  std::string scenario_yaml;  ///< resolved: to_yaml(scenario), from which the run can be repeated
  std::uint64_t seed{};
  double period{};                 ///< between the frames of the run [s]
  std::vector<Vehicle> vehicles;   ///< by index, as in the frames
  std::string program{"fairway"};  ///< that made the run: one with methods of its own, or "Python"
  std::string machine;             ///< that it ran on: processor and compiler; empty if it is not said
  bool perception{false};          ///< tracks and echoes are in the frames too
  bool sketches{false};            ///< what methods drew and the messages under way are in the frames too
};

/// Records a run as an MCAP file with ROS 2 messages, stamped with simulation time; README.md has the
/// format. The same frames give the same bytes. The file appears under its name when it is closed; if close()
/// is never reached, there is none, and a file that was there is as it was (OutputFile).
class RecordingWriter : public FrameSink {
 public:
  /// Keeps the first frame and then every `stride`-th, and the words of all. Throws InputError if the file
  /// cannot be written, `stride` or the period is not positive, or a text of the info is not UTF-8.
  RecordingWriter(std::string path, RecordingInfo info, std::int64_t stride = 1);
  ~RecordingWriter() override;
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// O(vehicles, what they perceive and draw); allocates only while its buffers grow. Throws InputError if
  /// the disk is full, if the frame has not the vehicles of the info, if its time is outside what a stamp
  /// holds, or if the meaning of a stroke is not UTF-8.
  void write(const Frame& frame) override;
  bool wants_thoughts() const override { return info_.sketches; }
  bool wants_tracks() const override { return info_.perception; }

  /// Completes the file, and says in it how the run ended. Throws InputError if that fails; does nothing the
  /// second time.
  void close(const RunEnd& how = {});

 private:
  struct Channels {
    std::uint16_t odometry{};
    std::uint16_t status{};
    std::uint16_t tracks{};
    std::uint16_t echoes{};
    std::uint16_t sketch{};
  };
  /// Last messages of a vehicle that are not written again until they change.
  struct Shown {
    Bytes tracks;
    Bytes echoes;
    Bytes sketch;
  };

  std::uint16_t add_channel(std::uint16_t schema, std::string_view topic);
  void add_vehicles(std::span<const std::string> topics);
  void add_perception(std::span<const std::string> topics);
  void add_sketches(std::span<const std::string> topics);
  void describe_run(std::span<const std::string> topics);
  void write_state(const Frame& frame, std::uint64_t hash);
  void write_perception(const Frame& frame, std::uint64_t hash);
  void write_sketches(const Frame& frame);
  void write_words(const Frame& frame);
  void write_if_changed(std::uint16_t channel, std::uint64_t time, Bytes& last);

  std::string path_;
  RecordingInfo info_;
  std::int64_t stride_;
  std::unique_ptr<McapWriter> mcap_;
  std::uint16_t frame_channel_{};
  std::uint16_t transforms_channel_{};
  std::uint16_t perception_channel_{};
  std::uint16_t flights_channel_{};
  std::optional<std::uint16_t> words_channel_;  // from the first word on
  std::vector<Channels> channels_;              // by vehicle
  std::vector<std::string> child_frames_;       // by vehicle
  std::vector<Shown> shown_;                    // by vehicle
  Bytes flights_;                               // last message of those under way
  Bytes message_;
  std::uint64_t frames_seen_{};
  std::uint64_t frames_kept_{};
  std::uint64_t run_hash_{};
  std::uint64_t perception_hash_{};  // as run_hash_
  std::int64_t last_tick_{-1};
};

/// The names under which vehicles appear in topics and frames: their own, every character but letters,
/// digits and '_' replaced by '_'; "vehicle_<index>" where that is empty, begins with a digit or is taken.
std::vector<std::string> topic_names(const std::vector<RecordingInfo::Vehicle>& vehicles);

}  // namespace fairway
