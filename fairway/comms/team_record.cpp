// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/team_record.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

/// Whole numbers of some bits, one after another.
struct BitWriter {
  TeamRecord record{};
  std::size_t at{};

  void write(std::int64_t value, std::size_t bits) {
    for (std::size_t bit = bits; bit-- > 0; ++at)
      record[at / 8] |= static_cast<std::uint8_t>((value >> bit & 1) << (7 - at % 8));
  }
};

struct BitReader {
  const TeamRecord& record;
  std::size_t at{};

  std::int64_t read_unsigned(std::size_t bits) {
    std::int64_t value = 0;
    for (std::size_t i = 0; i < bits; ++i, ++at) value = value << 1 | (record[at / 8] >> (7 - at % 8) & 1);
    return value;
  }

  /// In two's complement.
  std::int64_t read(std::size_t bits) {
    const std::int64_t value = read_unsigned(bits);
    return value >> (bits - 1) == 0 ? value : value - (std::int64_t{1} << bits);
  }
};

/// How a vector is told: the width of each component, and how many steps make a metre or a metre per second.
struct VectorCode {
  std::array<std::size_t, 3> bits;
  double per_unit;

  /// The largest number along an axis.
  std::int64_t largest(int axis) const {
    return (std::int64_t{1} << (bits[static_cast<std::size_t>(axis)] - 1)) - 1;
  }
};

constexpr VectorCode position_code{{24, 24, 22}, 100.0};
constexpr VectorCode velocity_code{{12, 12, 12}, 100.0};
constexpr VectorCode destination_code{{14, 14, 12}, 4.0};
constexpr std::size_t id_bits = 10;
constexpr std::size_t time_bits = 16;
constexpr std::size_t yaw_bits = 8;
constexpr std::size_t radius_bits = 9;
constexpr std::size_t priority_bits = 10;

constexpr std::size_t bits_of(const VectorCode& code) { return code.bits[0] + code.bits[1] + code.bits[2]; }
static_assert(id_bits + time_bits + bits_of(position_code) + bits_of(velocity_code) + yaw_bits + radius_bits +
                  priority_bits + 1 + bits_of(destination_code) ==
              8 * std::tuple_size_v<TeamRecord>);

constexpr double times_per_second = 50.0;
static_assert(times_per_second * record_cycle_s == 1 << time_bits);
constexpr double yaws_per_radian = (1 << yaw_bits) / (2.0 * pi);
constexpr double radii_per_metre = 10.0;
static_assert(radii_per_metre * most_told_radius_m == (1 << radius_bits) - 1);
constexpr std::int64_t last_of_all = (1 << (priority_bits - 1)) - 1;

/// The nearest whole number in [lo, hi]; `lo` for what is not a number.
std::int64_t nearest(double value, std::int64_t lo, std::int64_t hi) {
  if (!(value > static_cast<double>(lo))) return lo;
  return value < static_cast<double>(hi) ? std::llround(value) : hi;
}

void write(BitWriter& bits, const VectorCode& code, const Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t largest = code.largest(axis);
    bits.write(nearest(code.per_unit * vector[axis], -largest, largest),
               code.bits[static_cast<std::size_t>(axis)]);
  }
}

Vec3 read(BitReader& bits, const VectorCode& code) {
  Vec3 vector;
  for (int axis = 0; axis < 3; ++axis) {
    vector[axis] = static_cast<double>(bits.read(code.bits[static_cast<std::size_t>(axis)])) / code.per_unit;
  }
  return vector;
}

/// `vector` shortened, where it must be, so that the code holds every component.
Vec3 shortened(const VectorCode& code, const Vec3& vector) {
  double excess = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    excess =
        std::max(excess, code.per_unit * std::fabs(vector[axis]) / static_cast<double>(code.largest(axis)));
  }
  return vector / excess;
}

/// The position that is read from the record.
Vec3 as_told(const Vec3& position) {
  BitWriter bits;
  write(bits, position_code, position);
  BitReader back{bits.record};
  return read(back, position_code);
}

std::int64_t code_of_priority(std::int32_t priority) {
  if (priority == last_priority) return last_of_all;
  return std::clamp<std::int64_t>(priority, -last_of_all - 1, last_of_all - 1);
}

/// The last tick whose time, counted in steps, is `told` modulo the field's width.
Tick sent_tick(std::int64_t told, Tick now, double period) {
  const std::int64_t steps = std::llround(seconds(now, period) * times_per_second);
  constexpr std::int64_t mask = (1 << time_bits) - 1;
  const std::int64_t age = (steps - told) & mask;
  const double sent = static_cast<double>(steps - age) / times_per_second;
  return std::min(Tick{std::llround(sent / period)}, now);
}

}  // namespace

bool can_be_told(const Vec3& position) noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    const double largest = static_cast<double>(position_code.largest(axis));
    if (!(position_code.per_unit * std::fabs(position[axis]) < largest - 0.5)) return false;
  }
  return true;
}

TeamRecord encode(const Message& message, double period) {
  BitWriter bits;
  bits.write(number(message.from), id_bits);
  bits.write(std::llround(seconds(message.sent, period) * times_per_second), time_bits);
  write(bits, position_code, message.position);
  write(bits, velocity_code, shortened(velocity_code, message.velocity));
  constexpr std::int64_t half_turn = 1 << (yaw_bits - 1);
  bits.write(nearest(wrap_angle(message.yaw) * yaws_per_radian, -half_turn, half_turn), yaw_bits);

  // rounded up, but not for the sake of the last bit of 1.1
  const double radius = std::ceil(radii_per_metre * message.radius - 1e-9);
  bits.write(nearest(radius, 0, (1 << radius_bits) - 1), radius_bits);
  bits.write(code_of_priority(message.priority), priority_bits);

  bits.write(message.destination ? 1 : 0, 1);
  const Vec3 onward =
      message.destination ? Vec3{*message.destination - as_told(message.position)} : Vec3{Vec3::Zero()};
  write(bits, destination_code, shortened(destination_code, onward));
  return bits.record;
}

Message decode(const TeamRecord& record, Tick now, double period) {
  BitReader bits{record};
  Message message{.from = VehicleId{static_cast<std::uint32_t>(bits.read_unsigned(id_bits))}};
  message.sent = sent_tick(bits.read_unsigned(time_bits), now, period);
  message.position = read(bits, position_code);
  message.velocity = read(bits, velocity_code);
  message.yaw = static_cast<double>(bits.read(yaw_bits)) / yaws_per_radian;
  message.radius = static_cast<double>(bits.read_unsigned(radius_bits)) / radii_per_metre;
  const std::int64_t priority = bits.read(priority_bits);
  message.priority = priority == last_of_all ? last_priority : static_cast<std::int32_t>(priority);
  const bool is_going = bits.read_unsigned(1) == 1;
  const Vec3 onward = read(bits, destination_code);
  if (is_going) message.destination = message.position + onward;
  return message;
}

}  // namespace fairway
