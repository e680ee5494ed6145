// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

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
    for (int bit = 0; bit < bits; ++bit, ++at_) {
      const bool set = at_ / 8 < bytes_.size() && (bytes_[at_ / 8] & (0x80U >> (at_ % 8))) != 0U;
      value = (value << 1U) | (set ? 1U : 0U);
    }
    return value;
  }
  double get(const Scale& scale) noexcept { return scale.value(get(scale.bits)); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_{0};
};

}  // namespace fairway::pledge
