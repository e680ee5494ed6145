// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

#include "fairway/record/recording.hpp"

namespace fairway {

/// One vehicle at one recorded frame.
struct Instant {
  std::size_t vehicle{};  ///< its index
  std::size_t frame{};    ///< index in the recording
};

/// The index of the vehicle that is called `text`: its name, else its id, else its index. Throws InputError
/// with the nearest name. O(vehicles).
std::size_t vehicle_called(const RecordingInfo& info, std::string_view text);

/// The last recorded frame at or before `time` [s]; a time that is a frame's but for the last digits is that
/// frame's. Throws InputError for a time outside the run, which lasts until its last frame's period is over.
/// O(log frames).
std::size_t frame_at(const Recording& recording, double time);

}  // namespace fairway
