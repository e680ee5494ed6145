// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "fairway/record/frame.hpp"
#include "fairway/record/recording.hpp"

namespace fairway {

/// Compares a run, as it happens, with the recording of an earlier one, and remembers where they part;
/// perception, sketches and words too if they are recorded; where sketches are, the run has to show its
/// thoughts.
/// Keep the recording alive as long as this.
class HashChecker : public FrameSink {
 public:
  struct Mismatch {
    Tick tick{};
    double time{};             ///< [s]
    std::uint64_t expected{};  ///< frame_hash() in the recording
    std::uint64_t actual{};    ///< the same if it is a time, perception, a sketch or a word that differs
    std::string what;          ///< "otter_1 x_m: 1 was recorded, now 1.0000000000000002"
  };

  explicit HashChecker(const Recording& recording) : recording_{recording} {}

  /// Never throws for a difference, so that the run goes on to its end.
  void write(const Frame& frame) override;

  /// True when a run that was stopped has been followed as far as it is recorded: it is to go no further.
  bool is_over() const { return recording_.stopped() && seen_ >= recording_.run_frame_count(); }

  const std::optional<Mismatch>& first_mismatch() const { return mismatch_; }
  /// Frames that were in the recording and had the same hash.
  std::size_t matched() const { return matched_; }

  /// After the run: all frames seen, those between the recorded ones too, are those of the recorded run.
  bool same() const;
  /// The verdict in a line.
  std::string describe() const;

 private:
  void check_words(const Frame& frame);

  const Recording& recording_;
  std::size_t next_{};       // frame of the recording
  std::size_t next_word_{};  // likewise
  std::size_t matched_{};
  std::uint64_t seen_{};
  std::uint64_t run_hash_{};
  std::uint64_t run_perception_hash_{};
  std::optional<Mismatch> mismatch_;
};

}  // namespace fairway
