// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fairway/record/bytes.hpp"
#include "fairway/record/frame.hpp"
#include "fairway/record/recording_writer.hpp"

namespace fairway {

/// A recorded run, in memory, to the bit as it was written. Movable, not copyable: frames are views into it.
class Recording {
 public:
  /// Throws InputError with the file's name and what was expected for a file that is missing, empty,
  /// truncated, damaged, not a recording, or of a newer format than this program knows. Every checksum and
  /// every frame's hashes are verified. O(size).
  static Recording read(const std::string& file);
  /// The same from memory; `file` is used in messages.
  static Recording parse(ByteView bytes, const std::string& file);

  Recording(Recording&&) = default;
  Recording& operator=(Recording&&) = default;

  const RecordingInfo& info() const { return info_; }
  /// Every how many frames of the run one was kept.
  std::int64_t stride() const { return stride_; }

  std::size_t size() const { return marks_.size(); }
  /// Frame `i` < size(), ticks ascending. Valid while this lives. O(1).
  Frame frame(std::size_t i) const;
  /// frame_hash() of each frame.
  std::span<const std::uint64_t> hashes() const { return hashes_; }
  /// The hash of all frames of the run, kept or not: mix_hash() over their hashes, from 0.
  std::uint64_t run_hash() const { return run_hash_; }
  std::uint64_t run_frame_count() const { return run_frame_count_; }
  /// How the run broke behind the last frame, in a line; empty if it is whole.
  const std::string& divergence() const { return divergence_; }

  /// The run was stopped before its end: what it would have come to is not recorded.
  bool stopped() const { return stopped_; }

  // Where info().perception says that it is recorded; else empty and 0, and no frame has tracks or echoes.

  /// perception_hash() of each frame.
  std::span<const std::uint64_t> perception_hashes() const { return perception_hashes_; }
  /// As run_hash(), of perception_hash().
  std::uint64_t run_perception_hash() const { return run_perception_hash_; }

  /// Every word that methods said, in order: of instants between the frames too. Empty where nobody spoke,
  /// and of a run that was recorded before words were.
  std::span<const SpokenWord> words() const { return words_; }

  // Where info().sketches says so, strokes and messages under way are in the frames; else they are empty.

  /// Gives every frame to `sink`, in order.
  void play(FrameSink& sink) const;

 private:
  class Assembly;
  /// A part of one of the buffers, from `begin` to before `end`.
  struct Part {
    std::size_t begin{};
    std::size_t end{};

    template <class T>
    std::span<const T> of(const std::vector<T>& buffer) const {
      return std::span{buffer}.subspan(begin, end - begin);
    }
  };
  struct Mark {
    Tick tick{};
    double time{};
    double period{};
    Part flights;
    Part words;
  };

  Recording() = default;

  RecordingInfo info_;
  std::int64_t stride_{1};
  std::uint64_t run_hash_{};
  std::uint64_t run_frame_count_{};
  std::string divergence_;
  bool stopped_{};
  std::vector<Mark> marks_;
  std::vector<std::uint64_t> hashes_;
  std::uint64_t run_perception_hash_{};
  std::vector<std::uint64_t> perception_hashes_;
  std::vector<VehicleFrame> vehicles_;  // frame after frame
  std::vector<double> actuators_;       // of all of them; their spans point here
  std::vector<Track> tracks_;           // likewise, once for all frames in which a vehicle's stay the same
  std::vector<Echo> echoes_;
  std::vector<Stroke> strokes_;
  std::vector<MessageFlight> flights_;
  std::vector<SpokenWord> words_;
};

}  // namespace fairway
