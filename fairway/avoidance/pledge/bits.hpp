// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fairway/core/speech.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::pledge {

/// A number as it is told: `bits` wide, in steps of `step` from `lowest` on.
struct Scale {
  int bits;
  double step;
  double lowest;

  constexpr std::uint32_t last() const { return (1U << static_cast<unsigned>(bits)) - 1U; }

  /// The code of the nearest value that fits; NaN is told as the lowest.
  std::uint32_t code(double value) const noexcept {
    const double steps = std::floor((value - lowest) / step + 0.5);
    if (!(steps > 0.0)) return 0;
    return steps < static_cast<double>(last()) ? static_cast<std::uint32_t>(steps) : last();
  }
  /// The value that fits and is nearest above, but for a hair that is rounded off; the greatest at most.
  double at_least(double given) const noexcept { return value(code(given + (0.5 - 1e-6) * step)); }
  /// The value that fits and is nearest, or, where that is more than `most`, the one below it.
  double nearest(double given, double most) const noexcept {
    const std::uint32_t told = code(given);
    return told > 0 && value(told) > most + 1e-6 * step ? value(told - 1) : value(told);
  }
  double value(std::uint32_t code) const noexcept { return lowest + step * code; }
};

/// Writes numbers one behind the other, most significant bit first. What does not fit is left out.
class BitWriter {
 public:
  explicit BitWriter(std::span<std::uint8_t> bytes) : bytes_{bytes} {
    std::ranges::fill(bytes_, std::uint8_t{0});
  }

  void put(std::uint32_t value, int bits) noexcept {
    for (int bit = bits - 1; bit >= 0; --bit, ++at_) {
      if (at_ / 8 < bytes_.size() && ((value >> static_cast<unsigned>(bit)) & 1U) != 0U)
        bytes_[at_ / 8] |= static_cast<std::uint8_t>(0x80U >> (at_ % 8));
    }
  }
  void put(double value, const Scale& scale) noexcept { put(scale.code(value), scale.bits); }

 private:
  std::span<std::uint8_t> bytes_;
  std::size_t at_{0};
};

/// Reads them again; beyond the end everything is 0.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_{bytes} {}

  std::uint32_t get(int bits) noexcept {
    std::uint32_t value = 0;
    for (auto left = static_cast<std::size_t>(bits); left > 0;) {
      const std::size_t used = at_ % 8, taken = std::min(left, 8 - used);
      const std::uint32_t byte = at_ / 8 < bytes_.size() ? bytes_[at_ / 8] : 0U;
      value = (value << taken) | ((byte >> (8 - used - taken)) & ((1U << taken) - 1U));
      at_ += taken;
      left -= taken;
    }
    return value;
  }
  double get(const Scale& scale) noexcept { return scale.value(get(scale.bits)); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_{0};
};

/// Places are told relative to a datum: so far north and east of it, and so deep, from as far above the
/// surface on as waves lift [m].
inline constexpr Scale across{14, 0.02, -163.84}, depth{14, 0.02, -0.5};

inline void put_place(BitWriter& bits, const Vec3& p, const Vec2& datum, const Scale& scale = across,
                      const Scale& down = depth) noexcept {
  bits.put(p.x() - datum.x(), scale);
  bits.put(p.y() - datum.y(), scale);
  bits.put(p.z(), down);
}

inline Vec3 get_place(BitReader& bits, const Vec2& datum, const Scale& scale = across,
                      const Scale& down = depth) noexcept {
  const double north = bits.get(scale), east = bits.get(scale);
  return {north + datum.x(), east + datum.y(), bits.get(down)};
}

/// Times are told in tenths of a second, modulo 409.6 s.
inline constexpr int clock_bits = 12;
inline constexpr double tenth = 0.1, clock_period = 4096 * tenth;  // [s]

inline std::uint32_t told_time(double time) noexcept {
  const double tenths = std::floor(time / tenth + 0.5);
  return static_cast<std::uint32_t>(tenths - 4096.0 * std::floor(tenths / 4096.0));
}

/// The time nearest to `now` that is told so [s].
inline double time_of(std::uint32_t told, double now) noexcept {
  const double time = told * tenth;
  return time + clock_period * std::floor((now - time) / clock_period + 0.5);
}

/// FNV-1a.
inline std::uint32_t hash(std::span<const std::uint8_t> bytes, std::uint32_t from = 0x811c9dc5U) noexcept {
  for (const std::uint8_t byte : bytes) from = (from ^ byte) * 0x01000193U;
  return from;
}

/// The last byte of a speech is a check on the others: CRC-8 by x^8 + x^4 + x^3 + x^2 + 1 from ones on
/// (SAE J1850), by which no two bits that are wrong pass.
inline std::uint8_t check_of(const Speech& speech) noexcept {
  static constexpr std::array<std::uint8_t, 256> rests = [] {  // of each byte
    std::array<std::uint8_t, 256> all{};
    for (std::uint32_t byte = 0; byte < all.size(); ++byte) {
      std::uint32_t rest = byte;
      for (int bit = 0; bit < 8; ++bit) rest = (rest << 1U) ^ ((rest & 0x80U) != 0U ? 0x11dU : 0U);
      all[byte] = static_cast<std::uint8_t>(rest);
    }
    return all;
  }();
  std::uint8_t rest = 0xffU;
  for (const std::uint8_t byte : std::span{speech.bytes}.first(Speech::most_bytes - 1))
    rest = rests[rest ^ byte];
  return static_cast<std::uint8_t>(~rest);
}

inline std::span<std::uint8_t> body_of(Speech& speech) noexcept {
  return std::span{speech.bytes}.first(Speech::most_bytes - 1);
}

inline Speech sealed(Speech speech) noexcept {
  speech.size = Speech::most_bytes;
  speech.bytes.back() = check_of(speech);
  return speech;
}

inline bool is_intact(const Speech& speech) noexcept {
  return speech.size == Speech::most_bytes && speech.bytes.back() == check_of(speech);
}

}  // namespace fairway::pledge
