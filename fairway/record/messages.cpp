// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/messages.hpp"

#include <array>
#include <cmath>

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/cdr.hpp"

namespace fairway {

namespace {

constexpr std::size_t covariance_size = 36;

std::span<const double> values(const Vec3& v) { return {v.data(), 3}; }
std::span<double> values(Vec3& v) { return {v.data(), 3}; }

// Eigen keeps x, y, z, w, which is the order of geometry_msgs/Quaternion
std::span<const double> values(const Eigen::Quaterniond& q) { return {q.coeffs().data(), 4}; }
std::span<double> values(Eigen::Quaterniond& q) { return {q.coeffs().data(), 4}; }

void put_header(CdrWriter& cdr, Stamp stamp) {
  constexpr std::uint64_t second = 1'000'000'000;
  cdr.number(static_cast<std::int32_t>(stamp.nanoseconds / second));
  cdr.number(static_cast<std::uint32_t>(stamp.nanoseconds % second));
  cdr.text(world_frame);
}

void skip_header(CdrReader& cdr) {
  cdr.number<std::int32_t>();
  cdr.number<std::uint32_t>();
  cdr.skip_text();
}

std::span<const double> values(const Wrench& w) { return {w.data(), 6}; }
std::span<double> values(Wrench& w) { return {w.data(), 6}; }

template <class E>
E enumerator(std::uint8_t value, const char* what) {
  if (value >= EnumNames<E>::names.size()) {
    throw Malformed{std::string("damaged recording: a ") + what + " is " + std::to_string(value) +
                    "; expected 0 to " + std::to_string(EnumNames<E>::names.size() - 1)};
  }
  return static_cast<E>(value);
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
  cdr.number(static_cast<std::uint8_t>(vehicle.command.mode));
  cdr.boolean(vehicle.command.astern);
  cdr.boolean(vehicle.command.heading.has_value());
  cdr.boolean(vehicle.command.turn_rate.has_value());
  cdr.boolean(vehicle.command.wrench.has_value());
  cdr.array(values(vehicle.command.velocity));
  cdr.number(vehicle.command.heading.value_or(0.0));
  cdr.number(vehicle.command.turn_rate.value_or(0.0));
  const Wrench commanded = vehicle.command.wrench.value_or(Wrench{Wrench::Zero()});
  cdr.array(values(commanded));
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
  vehicle.command.mode = enumerator<Mode>(cdr.number<std::uint8_t>(), "mode");
  vehicle.command.astern = cdr.boolean();
  const bool has_heading = cdr.boolean();
  const bool has_turn_rate = cdr.boolean();
  const bool has_wrench = cdr.boolean();
  cdr.array(values(vehicle.command.velocity));
  const auto heading = cdr.number<double>();
  if (has_heading) vehicle.command.heading = heading;
  const auto turn_rate = cdr.number<double>();
  if (has_turn_rate) vehicle.command.turn_rate = turn_rate;
  Wrench commanded;
  cdr.array(values(commanded));
  if (has_wrench) vehicle.command.wrench = commanded;
  cdr.array(values(vehicle.goal));
  vehicle.goal_speed = cdr.number<double>();
  vehicle.power = cdr.number<double>();
  cdr.array(values(vehicle.wrench));
  cdr.sequence(actuators);
  cdr.finish();
  return tick;
}

}  // namespace fairway
