// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/record/bytes.hpp"

namespace fairway {

/// CRC-32 of zlib, PNG and MCAP (reflected polynomial 0xEDB88320); of "123456789" it is 0xCBF43926.
/// `before` is the CRC of what precedes: crc32(b, crc32(a)) == crc32(a followed by b). O(bytes).
std::uint32_t crc32(ByteView bytes, std::uint32_t before = 0) noexcept;

}  // namespace fairway
