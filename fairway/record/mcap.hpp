// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fairway::mcap {

/// First and last bytes of an MCAP file; the sixth, '0', is the major version (mcap.dev/spec).
inline constexpr std::array magic{std::byte{0x89}, std::byte{'M'}, std::byte{'C'},  std::byte{'A'},
                                  std::byte{'P'},  std::byte{'0'}, std::byte{'\r'}, std::byte{'\n'}};

/// The first byte of every record; 8 bytes of content length and the content follow.
enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

/// Opcode and content length.
inline constexpr std::size_t prefix_size = 1 + 8;
/// A footer: prefix, summary_start, summary_offset_start, summary_crc.
inline constexpr std::size_t footer_size = prefix_size + 8 + 8 + 4;

}  // namespace fairway::mcap
