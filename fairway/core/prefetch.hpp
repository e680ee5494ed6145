// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace fairway {

/// Asks the memory for `size` bytes from `begin` on that will be looked at soon: of what is too large for a
/// cache, to wait for one line at a time costs more than what is done with it. Changes nothing.
inline void prefetch(const void* begin, std::size_t size) noexcept {
  constexpr std::size_t line = 64;  // [B]
  const char* bytes = static_cast<const char*>(begin);
  for (std::size_t at = 0; at < size; at += line) __builtin_prefetch(bytes + at);
}

}  // namespace fairway
