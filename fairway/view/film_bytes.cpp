// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film_bytes.hpp"

#include <zstd.h>

#include <cstdint>
#include <new>

namespace fairway {
namespace {

constexpr int page_compression_level = 3;
constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64_of(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (k < group.size() ? static_cast<std::uint8_t>(group[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= group.size() ? base64_digits[bits >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

std::string zstd_of(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), page_compression_level);
  if (ZSTD_isError(size) != 0) throw std::bad_alloc{};  // all that can fail with room enough
  packed.resize(size);
  return packed;
}

}  // namespace fairway
