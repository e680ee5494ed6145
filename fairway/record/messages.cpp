// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/messages.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/error.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/cdr.hpp"
#include "fairway/record/message_parts.hpp"
#include "fairway/record/record_cdr.hpp"

namespace fairway {

namespace {

constexpr std::size_t covariance_size = 36;

/// The layout of a point in an echoes' message: float32 x, y, z, 4 bytes unused, float64 range, bearing.
constexpr std::uint32_t point_step = 32, range_offset = 16, bearing_offset = 24;

void put_field(CdrWriter& cdr, std::string_view name, std::uint32_t offset, std::uint8_t datatype) {
  cdr.text(name);
  cdr.number(offset);
  cdr.number(datatype);
  cdr.number(std::uint32_t{1});
}

}  // namespace

Stamp stamp_of(double time) {
  if (!(time >= 0.0 && time < 0x1p31)) {
    throw InputError{
        {}, "", "a frame at " + number_text(time) + " s cannot be recorded; expected 0 to 2^31 s"};
  }
  return {static_cast<std::uint64_t>(std::llround(time * 1e9))};
}

void encode_frame(Bytes& out, Stamp stamp, const FrameMark& mark) {
  CdrWriter cdr{out};
  put_header(cdr, stamp);
  cdr.number(count(mark.tick));
  cdr.number(mark.time);
  cdr.number(mark.period);
  cdr.number(mark.hash);
}

void encode_odometry(Bytes& out, Stamp stamp, std::string_view child_frame, const VehicleState& state) {
  CdrWriter cdr{out};
  put_header(cdr, stamp);
  cdr.text(child_frame);
  cdr.array(values(state.p_n));
  cdr.array(values(state.q_nb));
  cdr.zeros(covariance_size);
  cdr.array(values(state.v_b));
  cdr.array(values(state.omega_b));
  cdr.zeros(covariance_size);
}

void encode_status(Bytes& out, Stamp stamp, Tick tick, const VehicleFrame& vehicle) {
  CdrWriter cdr{out};
  put_header(cdr, stamp);
  cdr.number(count(tick));
  cdr.number(number(vehicle.id));
  cdr.number(static_cast<std::uint8_t>(vehicle.phase));
  put_record(cdr, vehicle.command);
  cdr.array(values(vehicle.goal));
  cdr.number(vehicle.goal_speed);
  cdr.number(vehicle.power);
  cdr.array(values(vehicle.wrench));
  cdr.sequence(vehicle.actuators);
}

void encode_transforms(Bytes& out, Stamp stamp, std::span<const std::string> child_frames,
                       std::span<const VehicleFrame> vehicles) {
  CdrWriter cdr{out};
  cdr.number(static_cast<std::uint32_t>(vehicles.size()));
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    put_header(cdr, stamp);
    cdr.text(child_frames[i]);
    cdr.array(values(vehicles[i].state.p_n));
    cdr.array(values(vehicles[i].state.q_nb));
  }
}

void encode_perception(Bytes& out, Stamp stamp, const PerceptionMark& mark) {
  CdrWriter cdr{out};
  put_header(cdr, stamp);
  cdr.number(count(mark.tick));
  cdr.number(mark.hash);
}

void encode_tracks(Bytes& out, Stamp stamp, std::span<const Track> tracks) {
  CdrWriter cdr{out};
  put_header(cdr, stamp);
  cdr.number(static_cast<std::uint32_t>(tracks.size()));
  for (const Track& track : tracks) put_record(cdr, track);
}

void encode_echoes(Bytes& out, Stamp stamp, std::string_view body_frame, std::span<const Echo> echoes) {
  constexpr std::uint8_t float32 = 7, float64 = 8;
  const auto count = static_cast<std::uint32_t>(echoes.size());
  CdrWriter cdr{out};
  put_header(cdr, stamp, body_frame);
  cdr.number(std::uint32_t{1});  // height
  cdr.number(count);             // width
  cdr.number(std::uint32_t{5});
  put_field(cdr, "x", 0, float32);
  put_field(cdr, "y", 4, float32);
  put_field(cdr, "z", 8, float32);
  put_field(cdr, "range_m", range_offset, float64);
  put_field(cdr, "bearing_rad", bearing_offset, float64);
  cdr.boolean(false);  // big-endian
  cdr.number(point_step);
  cdr.number(point_step * count);

  cdr.number(point_step * count);
  for (const auto& [range, bearing] : echoes) {
    put(out, static_cast<float>(range * math::cos(bearing)));
    put(out, static_cast<float>(range * math::sin(bearing)));
    put(out, 0.0F);
    put(out, std::uint32_t{0});
    put(out, range);
    put(out, bearing);
  }
  cdr.boolean(true);  // dense
}

bool same_content(ByteView a, ByteView b) noexcept {
  constexpr std::size_t behind_stamp = 12;  // encapsulation, sec, nanosec
  return a.size() == b.size() && a.size() >= behind_stamp &&
         std::ranges::equal(a.subspan(behind_stamp), b.subspan(behind_stamp));
}

FrameMark decode_frame(ByteView message) {
  CdrReader cdr{message};
  skip_header(cdr);
  FrameMark mark;
  mark.tick = Tick{cdr.number<std::int64_t>()};
  mark.time = cdr.number<double>();
  mark.period = cdr.number<double>();
  mark.hash = cdr.number<std::uint64_t>();
  cdr.finish();
  return mark;
}

VehicleState decode_odometry(ByteView message) {
  CdrReader cdr{message};
  skip_header(cdr);
  cdr.skip_text();
  VehicleState state;
  cdr.array(values(state.p_n));
  cdr.array(values(state.q_nb));
  cdr.skip_array(covariance_size);
  cdr.array(values(state.v_b));
  cdr.array(values(state.omega_b));
  cdr.skip_array(covariance_size);
  cdr.finish();
  return state;
}

Tick decode_status(ByteView message, VehicleFrame& vehicle, std::vector<double>& actuators) {
  CdrReader cdr{message};
  skip_header(cdr);
  const Tick tick{cdr.number<std::int64_t>()};
  vehicle.id = VehicleId{cdr.number<std::uint32_t>()};
  vehicle.phase = enumerator<Phase>(cdr.number<std::uint8_t>(), "phase");
  get_record(cdr, vehicle.command);
  cdr.array(values(vehicle.goal));
  vehicle.goal_speed = cdr.number<double>();
  vehicle.power = cdr.number<double>();
  cdr.array(values(vehicle.wrench));
  cdr.sequence(actuators);
  cdr.finish();
  return tick;
}

PerceptionMark decode_perception(ByteView message) {
  CdrReader cdr{message};
  skip_header(cdr);
  PerceptionMark mark;
  mark.tick = Tick{cdr.number<std::int64_t>()};
  mark.hash = cdr.number<std::uint64_t>();
  cdr.finish();
  return mark;
}

void decode_tracks(ByteView message, std::vector<Track>& tracks) {
  CdrReader cdr{message};
  skip_header(cdr);
  for (auto left = cdr.number<std::uint32_t>(); left > 0; --left) get_record(cdr, tracks.emplace_back());
  cdr.finish();
}

void decode_echoes(ByteView message, std::vector<Echo>& echoes) {
  CdrReader cdr{message};
  skip_header(cdr);
  cdr.number<std::uint32_t>();
  const auto count = cdr.number<std::uint32_t>();
  for (auto fields = cdr.number<std::uint32_t>(); fields > 0; --fields) {
    cdr.skip_text();
    cdr.number<std::uint32_t>();
    cdr.number<std::uint8_t>();
    cdr.number<std::uint32_t>();
  }
  cdr.boolean();
  const auto step = cdr.number<std::uint32_t>();
  cdr.number<std::uint32_t>();
  const ByteView points = cdr.bytes();
  cdr.boolean();
  cdr.finish();

  if (step != point_step || points.size() != std::uint64_t{point_step} * count) {
    throw Malformed{"damaged recording: echoes of another layout"};
  }
  for (std::size_t at = 0; at < points.size(); at += point_step) {
    ByteReader point{points.subspan(at + range_offset, sizeof(double) * 2)};
    const auto range = point.number<double>();
    echoes.push_back({range, point.number<double>()});
  }
}

}  // namespace fairway
