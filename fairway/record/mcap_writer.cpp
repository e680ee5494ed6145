// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/mcap_writer.hpp"

#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

#include "fairway/core/error.hpp"
#include "fairway/record/crc32.hpp"

namespace fairway {

namespace {

using mcap::Opcode;

// of zstd; see README.md for the sizes and times measured
constexpr int compression_level = 1;

// What is put at the end of a buffer while this lives: its length in bytes goes before it.
template <class Length>
class Counted {
 public:
  explicit Counted(Bytes& out) : out_{out} {
    put(out_, Length{0});
    start_ = out_.size();
  }
  ~Counted() {
    const auto length = static_cast<Length>(out_.size() - start_);
    std::memcpy(out_.data() + start_ - sizeof(length), &length, sizeof(length));
  }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  Bytes& out_;
  std::size_t start_;
};
using CountedList = Counted<std::uint32_t>;  // a map or array

// A record under construction, behind its opcode.
class RecordScope {
 public:
  RecordScope(Bytes& out, Opcode opcode) : content_{begun(out, opcode)} {}

 private:
  static Bytes& begun(Bytes& out, Opcode opcode) {
    put(out, static_cast<std::uint8_t>(opcode));
    return out;
  }
  Counted<std::uint64_t> content_;
};

}  // namespace

void McapWriter::FreeContext::operator()(ZSTD_CCtx_s* context) const { ZSTD_freeCCtx(context); }

McapWriter::~McapWriter() = default;

McapWriter::McapWriter(const std::string& path, std::string_view profile, std::string_view library,
                       std::size_t chunk_size)
    : file_{path}, context_{ZSTD_createCCtx()}, chunk_size_{chunk_size} {
  if (!context_) throw std::bad_alloc{};
  chunk_.reserve(chunk_size + chunk_size / 8);
  compressed_.reserve(ZSTD_compressBound(chunk_.capacity()));

  emit(mcap::magic);
  scratch_.clear();
  {
    const RecordScope record{scratch_, Opcode::header};
    put_string(scratch_, profile);
    put_string(scratch_, library);
  }
  emit(scratch_);
}

void McapWriter::emit(ByteView bytes) {
  file_.stream().write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
  file_.check();
  crc_ = crc32(bytes, crc_);
  offset_ += bytes.size();
}

void McapWriter::put_map(Bytes& out, const Map& map) {
  const CountedList counted{out};
  for (const auto& [key, value] : map) {
    put_string(out, key);
    put_string(out, value);
  }
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view encoding,
                                     std::string_view text) {
  const auto id = static_cast<std::uint16_t>(++schema_count_);
  const std::size_t start = schema_records_.size();
  {
    const RecordScope record{schema_records_, Opcode::schema};
    put(schema_records_, id);
    put_string(schema_records_, name);
    put_string(schema_records_, encoding);
    put_string(schema_records_, text);
  }
  emit(ByteView{schema_records_}.subspan(start));
  return id;
}

std::uint16_t McapWriter::add_channel(std::uint16_t schema, std::string_view topic, std::string_view encoding,
                                      const Map& metadata) {
  if (channels_.size() > std::numeric_limits<std::uint16_t>::max()) {
    throw InputError{{.file = file_.path()}, "", "cannot be written: MCAP has room for 65536 channels"};
  }
  const auto id = static_cast<std::uint16_t>(channels_.size());
  channels_.emplace_back();
  const std::size_t start = channel_records_.size();
  {
    const RecordScope record{channel_records_, Opcode::channel};
    put(channel_records_, id);
    put(channel_records_, schema);
    put_string(channel_records_, topic);
    put_string(channel_records_, encoding);
    put_map(channel_records_, metadata);
  }
  emit(ByteView{channel_records_}.subspan(start));
  return id;
}

void McapWriter::add_metadata(std::string_view name, const Map& entries) {
  flush_chunk();
  scratch_.clear();
  {
    const RecordScope record{scratch_, Opcode::metadata};
    put_string(scratch_, name);
    put_map(scratch_, entries);
  }
  {
    const RecordScope index{metadata_indexes_, Opcode::metadata_index};
    put(metadata_indexes_, offset_);
    put(metadata_indexes_, std::uint64_t{scratch_.size()});
    put_string(metadata_indexes_, name);
  }
  ++metadata_count_;
  emit(scratch_);
}

void McapWriter::attach(std::string_view name, std::string_view media_type, std::string_view data) {
  flush_chunk();
  constexpr std::uint64_t no_time = 0;
  scratch_.clear();
  {
    const RecordScope record{scratch_, Opcode::attachment};
    put(scratch_, no_time);
    put(scratch_, no_time);
    put_string(scratch_, name);
    put_string(scratch_, media_type);
    put(scratch_, std::uint64_t{data.size()});
    put(scratch_, bytes_of(data));
    put(scratch_, crc32(ByteView{scratch_}.subspan(mcap::prefix_size)));
  }
  {
    const RecordScope index{attachment_indexes_, Opcode::attachment_index};
    put(attachment_indexes_, offset_);
    put(attachment_indexes_, std::uint64_t{scratch_.size()});
    put(attachment_indexes_, no_time);
    put(attachment_indexes_, no_time);
    put(attachment_indexes_, std::uint64_t{data.size()});
    put_string(attachment_indexes_, name);
    put_string(attachment_indexes_, media_type);
  }
  ++attachment_count_;
  emit(scratch_);
}

void McapWriter::write(std::uint16_t channel, std::uint64_t time, ByteView message) {
  Channel& c = channels_.at(channel);

  // index entry
  chunk_start_ = chunk_.empty() ? time : std::min(chunk_start_, time);
  chunk_end_ = chunk_.empty() ? time : std::max(chunk_end_, time);
  start_ = message_count_ == 0 ? time : std::min(start_, time);
  end_ = message_count_ == 0 ? time : std::max(end_, time);
  put(c.index, time);
  put(c.index, std::uint64_t{chunk_.size()});

  // message
  {
    const RecordScope record{chunk_, Opcode::message};
    put(chunk_, channel);
    put(chunk_, static_cast<std::uint32_t>(c.count));
    put(chunk_, time);
    put(chunk_, time);
    put(chunk_, message);
  }
  ++c.count;
  ++message_count_;
  if (chunk_.size() >= chunk_size_) flush_chunk();
}

void McapWriter::flush_chunk() {
  if (chunk_.empty()) return;

  compressed_.resize(ZSTD_compressBound(chunk_.size()));
  const std::size_t size = ZSTD_compressCCtx(context_.get(), compressed_.data(), compressed_.size(),
                                             chunk_.data(), chunk_.size(), compression_level);
  if (ZSTD_isError(size) != 0) throw std::bad_alloc{};  // the only way it can fail with a full-size buffer
  compressed_.resize(size);

  // chunk; the record is written in two pieces, so its length is not that of the buffer
  const std::uint64_t chunk_offset = offset_;
  constexpr std::string_view compression = "zstd";
  const std::uint64_t content = 8 + 8 + 8 + 4 + 4 + compression.size() + 8 + size;
  scratch_.clear();
  put(scratch_, static_cast<std::uint8_t>(Opcode::chunk));
  put(scratch_, content);
  put(scratch_, chunk_start_);
  put(scratch_, chunk_end_);
  put(scratch_, std::uint64_t{chunk_.size()});
  put(scratch_, crc32(chunk_));
  put_string(scratch_, compression);
  put(scratch_, std::uint64_t{size});
  emit(scratch_);
  emit(compressed_);
  const std::uint64_t chunk_length = offset_ - chunk_offset;

  // where each channel's messages are in it, and where this is said
  {
    const RecordScope index{chunk_indexes_, Opcode::chunk_index};
    put(chunk_indexes_, chunk_start_);
    put(chunk_indexes_, chunk_end_);
    put(chunk_indexes_, chunk_offset);
    put(chunk_indexes_, chunk_length);
    scratch_.clear();
    {
      const CountedList offsets{chunk_indexes_};
      for (std::size_t id = 0; id < channels_.size(); ++id) {
        Bytes& entries = channels_[id].index;
        if (entries.empty()) continue;
        put(chunk_indexes_, static_cast<std::uint16_t>(id));
        put(chunk_indexes_, offset_ + scratch_.size());
        const RecordScope record{scratch_, Opcode::message_index};
        put(scratch_, static_cast<std::uint16_t>(id));
        put(scratch_, static_cast<std::uint32_t>(entries.size()));
        put(scratch_, entries);
        entries.clear();
      }
    }
    put(chunk_indexes_, std::uint64_t{scratch_.size()});
    put_string(chunk_indexes_, compression);
    put(chunk_indexes_, std::uint64_t{size});
    put(chunk_indexes_, std::uint64_t{chunk_.size()});
  }
  emit(scratch_);
  ++chunk_count_;
  chunk_.clear();
}

void McapWriter::put_statistics(Bytes& out) const {
  const RecordScope record{out, Opcode::statistics};
  put(out, message_count_);
  put(out, static_cast<std::uint16_t>(schema_count_));
  put(out, static_cast<std::uint32_t>(channels_.size()));
  put(out, attachment_count_);
  put(out, metadata_count_);
  put(out, chunk_count_);
  put(out, start_);
  put(out, end_);
  const CountedList counts{out};
  for (std::size_t id = 0; id < channels_.size(); ++id) {
    put(out, static_cast<std::uint16_t>(id));
    put(out, channels_[id].count);
  }
}

void McapWriter::finish() {
  flush_chunk();

  // end of the data section
  scratch_.clear();
  {
    const RecordScope record{scratch_, Opcode::data_end};
    put(scratch_, crc_);
  }
  emit(scratch_);

  // summary, grouped by opcode, and where each group is
  const std::uint64_t summary_start = offset_;
  Bytes summary, offsets;
  const auto add_group = [&](Opcode opcode, ByteView records) {
    if (records.empty()) return;
    const RecordScope record{offsets, Opcode::summary_offset};
    put(offsets, static_cast<std::uint8_t>(opcode));
    put(offsets, summary_start + summary.size());
    put(offsets, std::uint64_t{records.size()});
    put(summary, records);
  };
  Bytes statistics;
  put_statistics(statistics);
  add_group(Opcode::schema, schema_records_);
  add_group(Opcode::channel, channel_records_);
  add_group(Opcode::statistics, statistics);
  add_group(Opcode::chunk_index, chunk_indexes_);
  add_group(Opcode::attachment_index, attachment_indexes_);
  add_group(Opcode::metadata_index, metadata_indexes_);

  // footer; its CRC begins at the summary and ends before itself
  const std::uint64_t summary_offset_start = summary_start + summary.size();
  put(summary, offsets);
  put(summary, static_cast<std::uint8_t>(Opcode::footer));
  put(summary, std::uint64_t{mcap::footer_size - mcap::prefix_size});
  put(summary, summary_start);
  put(summary, summary_offset_start);
  put(summary, crc32(summary));
  put(summary, mcap::magic);
  emit(summary);
  file_.commit();
}

}  // namespace fairway
