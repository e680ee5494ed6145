// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/frame_hash.hpp"

#include <bit>

namespace fairway {

namespace {

class Hash {
 public:
  void add(std::uint64_t word) { value_ = mix_hash(value_, word); }
  void add(std::span<const double> values) {
    for (const double v : values) add(std::bit_cast<std::uint64_t>(v));
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& v) { add(std::span{v.data(), 3}); }
  void add(const Mat3& m) { add(std::span{m.data(), 9}); }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_{14695981039346656037ULL};
};

void add(Hash& hash, const Track& track) {
  const auto& [id, position, velocity, yaw, radius, age, priority, destination, reacts, position_covariance,
               velocity_covariance] = track;
  hash.add(std::uint64_t{number(id)} | std::uint64_t{std::bit_cast<std::uint32_t>(priority)} << 32U);
  hash.add(std::uint64_t{reacts} | std::uint64_t{destination.has_value()} << 1U);
  hash.add(position);
  hash.add(velocity);
  for (const double value : {yaw, radius, age}) hash.add(value);
  if (destination) hash.add(*destination);
  hash.add(position_covariance);
  hash.add(velocity_covariance);
}

}  // namespace

std::uint64_t frame_hash(const Frame& frame) noexcept {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(count(frame.tick)));
  hash.add(std::uint64_t{frame.vehicles.size()});
  for (const VehicleFrame& v : frame.vehicles) {
    // what is discrete, in one word
    const Command& command = v.command;
    hash.add(std::uint64_t{number(v.id)} | static_cast<std::uint64_t>(v.phase) << 32U |
             static_cast<std::uint64_t>(command.mode) << 40U | std::uint64_t{command.astern} << 48U |
             std::uint64_t{command.heading.has_value()} << 56U |
             std::uint64_t{command.wrench.has_value()} << 57U |
             std::uint64_t{command.turn_rate.has_value()} << 58U);

    hash.add(v.state.p_n);
    hash.add(std::span{v.state.q_nb.coeffs().data(), 4});
    hash.add(v.state.v_b);
    hash.add(v.state.omega_b);
    hash.add(command.velocity);
    hash.add(std::bit_cast<std::uint64_t>(command.heading.value_or(0.0)));
    if (command.turn_rate) hash.add(std::bit_cast<std::uint64_t>(*command.turn_rate));
    if (command.wrench) hash.add(std::span{command.wrench->data(), 6});
    hash.add(v.goal);
    hash.add(std::bit_cast<std::uint64_t>(v.goal_speed));
    hash.add(std::bit_cast<std::uint64_t>(v.power));
    hash.add(std::span{v.wrench.data(), 6});
    hash.add(std::uint64_t{v.actuators.size()});
    hash.add(v.actuators);
  }
  return hash.value();
}

std::uint64_t perception_hash(const Frame& frame) noexcept {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(count(frame.tick)));
  hash.add(std::uint64_t{frame.vehicles.size()});
  for (const VehicleFrame& v : frame.vehicles) {
    hash.add(std::uint64_t{v.tracks.size()});
    for (const Track& track : v.tracks) add(hash, track);
    hash.add(std::uint64_t{v.echoes.size()});
    for (const auto& [range, bearing] : v.echoes) {
      hash.add(range);
      hash.add(bearing);
    }
  }
  return hash.value();
}

}  // namespace fairway
