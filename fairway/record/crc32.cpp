// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/crc32.hpp"

#include <array>

namespace fairway {

namespace {

// tables[k][b]: the CRC of byte b followed by k zero bytes, so that eight bytes go in one step
constexpr auto tables = [] {
  std::array<std::array<std::uint32_t, 256>, 8> t{};
  for (std::uint32_t b = 0; b < 256; ++b) {
    std::uint32_t c = b;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? (c >> 1U) ^ 0xEDB88320U : c >> 1U;
    t[0][b] = c;
  }
  for (std::size_t k = 1; k < t.size(); ++k) {
    for (std::size_t b = 0; b < 256; ++b) t[k][b] = (t[k - 1][b] >> 8U) ^ t[0][t[k - 1][b] & 0xFFU];
  }
  return t;
}();

}  // namespace

std::uint32_t crc32(ByteView bytes, std::uint32_t before) noexcept {
  std::uint32_t c = ~before;
  const std::byte* p = bytes.data();
  std::size_t left = bytes.size();
  for (; left >= 8; left -= 8, p += 8) {
    std::uint64_t word{};
    std::memcpy(&word, p, 8);
    word ^= c;
    c = 0;
    for (std::size_t i = 0; i < 8; ++i) c ^= tables[7 - i][(word >> (8 * i)) & 0xFFU];
  }
  for (; left > 0; --left, ++p) c = (c >> 8U) ^ tables[0][(c ^ static_cast<std::uint32_t>(*p)) & 0xFFU];
  return ~c;
}

}  // namespace fairway
