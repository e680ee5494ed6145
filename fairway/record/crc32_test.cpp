// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/crc32.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(Crc32, HasThePublishedCheckValue) { EXPECT_EQ(crc32(bytes_of("123456789")), 0xCBF43926U); }

TEST(Crc32, OfNothingIsZero) { EXPECT_EQ(crc32({}), 0U); }

// the definition: one bit at a time
std::uint32_t by_definition(ByteView bytes) {
  std::uint32_t c = 0xFFFFFFFFU;
  for (const std::byte b : bytes) {
    c ^= static_cast<std::uint32_t>(b);
    for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? (c >> 1U) ^ 0xEDB88320U : c >> 1U;
  }
  return ~c;
}

TEST(Crc32, IsItsDefinitionAtEveryLengthAndSplit) {
  Bytes bytes;
  for (unsigned i = 0; i < 70; ++i) {
    EXPECT_EQ(crc32(bytes), by_definition(bytes)) << i;
    for (std::size_t split = 0; split <= bytes.size(); ++split) {
      const ByteView all{bytes};
      EXPECT_EQ(crc32(all.subspan(split), crc32(all.first(split))), crc32(all)) << i << " split at " << split;
    }
    bytes.push_back(static_cast<std::byte>(i * 37U + 11U));
  }
}

}  // namespace
}  // namespace fairway
