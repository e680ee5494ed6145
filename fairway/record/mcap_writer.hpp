// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/record/bytes.hpp"
#include "fairway/record/mcap.hpp"
#include "fairway/record/output_file.hpp"

struct ZSTD_CCtx_s;

namespace fairway {

/// Writes an MCAP file (mcap.dev/spec, major version 0): messages in zstd chunks with message indexes, and
/// a summary section, so that readers can seek. The bytes depend on the calls alone. The file appears under
/// its name when it is finished. Between two chunks write() does not allocate once its buffers have grown.
/// Every member throws InputError naming the file when it cannot be written.
class McapWriter {
 public:
  using Map = std::vector<std::pair<std::string, std::string>>;

  /// Begins the file beside `path`. A chunk is closed when it holds `chunk_size` bytes.
  McapWriter(const std::string& path, std::string_view profile, std::string_view library,
             std::size_t chunk_size = std::size_t{1} << 20U);
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// The id by which channels name it, counting from 1.
  std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view text);
  /// The id by which messages name it, counting from 0.
  std::uint16_t add_channel(std::uint16_t schema, std::string_view topic, std::string_view encoding,
                            const Map& metadata = {});
  void add_metadata(std::string_view name, const Map& entries);
  /// A file within the file; log and creation time are 0.
  void attach(std::string_view name, std::string_view media_type, std::string_view data);

  /// `time` [ns] is both log and publish time.
  void write(std::uint16_t channel, std::uint64_t time, ByteView message);

  /// Writes the rest and puts the file in its place. Nothing may follow.
  void finish();

 private:
  struct Channel {
    Bytes index;            // (time, offset) of each message of the open chunk
    std::uint64_t count{};  // in the file
  };
  struct FreeContext {
    void operator()(ZSTD_CCtx_s* context) const;
  };

  void emit(ByteView bytes);
  void flush_chunk();
  void put_statistics(Bytes& out) const;
  static void put_map(Bytes& out, const Map& map);

  OutputFile file_;
  std::unique_ptr<ZSTD_CCtx_s, FreeContext> context_;
  std::size_t chunk_size_;
  std::uint64_t offset_{};  // bytes written so far
  std::uint32_t crc_{};     // of those bytes

  Bytes chunk_;       // records of the open chunk
  Bytes compressed_;  // and the same, compressed
  Bytes scratch_;
  std::uint64_t chunk_start_{}, chunk_end_{};  // least and greatest time in it
  std::vector<Channel> channels_;

  Bytes schema_records_, channel_records_, chunk_indexes_, attachment_indexes_, metadata_indexes_;
  std::uint64_t start_{}, end_{}, message_count_{};
  std::uint32_t schema_count_{}, chunk_count_{}, attachment_count_{}, metadata_count_{};
};

}  // namespace fairway
