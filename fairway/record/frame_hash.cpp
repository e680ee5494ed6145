// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/frame_hash.hpp"

#include <bit>

#include "fairway/record/record_kinds.hpp"

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

/// Small numbers two to a word, then all switches in one word, then the real numbers that are there.
template <RecordType R>
void add(Hash& hash, const R& record) {
  std::uint64_t word = 0, switches = 0;
  unsigned in_word = 0, switched = 0;
  const auto add_small = [&](std::uint32_t value) {
    word |= std::uint64_t{value} << 32U * in_word;
    if (++in_word < 2) return;
    hash.add(word);
    word = in_word = 0;
  };
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::Discrete<T> && !std::same_as<T, bool>)
      add_small(static_cast<std::uint32_t>(record.*m.at));
  });
  if (in_word > 0) hash.add(word);
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (std::same_as<T, bool>) switches |= std::uint64_t{record.*m.at} << switched++;
  });
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::is_optional<T>) switches |= std::uint64_t{(record.*m.at).has_value()} << switched++;
  });
  hash.add(switches);
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::is_optional<T>) {
      if (record.*m.at) hash.add(*(record.*m.at));
    } else if constexpr (detail::Real<T>) {
      hash.add(record.*m.at);
    }
  });
}

}  // namespace

std::uint64_t frame_hash(const Frame& frame) noexcept {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(count(frame.tick)));
  hash.add(std::uint64_t{frame.vehicles.size()});
  for (const VehicleFrame& v : frame.vehicles) {
    // what is discrete, in one word; a command's note is for people alone
    const auto& [velocity, mode, astern, heading, turn_rate, wrench, note] = v.command;
    hash.add(std::uint64_t{number(v.id)} | static_cast<std::uint64_t>(v.phase) << 32U |
             static_cast<std::uint64_t>(mode) << 40U | std::uint64_t{astern} << 48U |
             std::uint64_t{heading.has_value()} << 56U | std::uint64_t{wrench.has_value()} << 57U |
             std::uint64_t{turn_rate.has_value()} << 58U);

    hash.add(v.state.p_n);
    hash.add(std::span{v.state.q_nb.coeffs().data(), 4});
    hash.add(v.state.v_b);
    hash.add(v.state.omega_b);
    hash.add(velocity);
    hash.add(std::bit_cast<std::uint64_t>(heading.value_or(0.0)));
    if (turn_rate) hash.add(std::bit_cast<std::uint64_t>(*turn_rate));
    if (wrench) hash.add(std::span{wrench->data(), 6});
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
