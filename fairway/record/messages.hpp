// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/record/bytes.hpp"
#include "fairway/record/frame.hpp"

namespace fairway {

/// The fixed frame of a recording: local north-east-down.
inline constexpr std::string_view world_frame = "world_ned";

/// Simulation time since the start [ns].
struct Stamp {
  std::uint64_t nanoseconds{};
};

/// The nearest nanosecond; throws InputError unless 0 <= `time` < 2^31 s, which is what ROS can hold.
Stamp stamp_of(double time);

/// The message fairway_msgs/msg/Frame without its header.
struct FrameMark {
  Tick tick{};
  double time{};
  double period{};
  std::uint64_t hash{};
};

/// The message fairway_msgs/msg/Perception without its header.
struct PerceptionMark {
  Tick tick{};
  std::uint64_t hash{};
};

// CDR messages; `out` is emptied first. The schemas are in schemas.cpp.
void encode_frame(Bytes& out, Stamp stamp, const FrameMark& mark);
void encode_odometry(Bytes& out, Stamp stamp, std::string_view child_frame, const VehicleState& state);
void encode_status(Bytes& out, Stamp stamp, Tick tick, const VehicleFrame& vehicle);
/// `child_frames` by index, as `vehicles`.
void encode_transforms(Bytes& out, Stamp stamp, std::span<const std::string> child_frames,
                       std::span<const VehicleFrame> vehicles);
void encode_perception(Bytes& out, Stamp stamp, const PerceptionMark& mark);
void encode_tracks(Bytes& out, Stamp stamp, std::span<const Track> tracks);
/// A PointCloud2 in `body_frame`: x, y, z for viewers, in single precision, then range and bearing.
void encode_echoes(Bytes& out, Stamp stamp, std::string_view body_frame, std::span<const Echo> echoes);

/// True if two messages with a header are the same but for their stamps.
bool same_content(ByteView a, ByteView b) noexcept;

// The way back, to the bit. Throw Malformed for anything that is not such a message.
FrameMark decode_frame(ByteView message);
VehicleState decode_odometry(ByteView message);
/// Fills all of `vehicle` but its state and actuators; these are appended to `actuators`.
Tick decode_status(ByteView message, VehicleFrame& vehicle, std::vector<double>& actuators);
PerceptionMark decode_perception(ByteView message);
/// Append to `tracks` or `echoes`.
void decode_tracks(ByteView message, std::vector<Track>& tracks);
void decode_echoes(ByteView message, std::vector<Echo>& echoes);

}  // namespace fairway
