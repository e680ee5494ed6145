// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/mcap_reader.hpp"

#include <zstd.h>

#include <algorithm>

#include "fairway/record/crc32.hpp"

namespace fairway {

namespace {

using mcap::Opcode;

// larger chunks are refused before memory is taken: the writer closes one at 1 MiB
constexpr std::uint64_t max_chunk_size = std::uint64_t{64} << 20U;

struct Record {
  Opcode opcode{};
  ByteView content;
};

Record next_record(ByteReader& reader) {
  const auto opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
  return {opcode, reader.take(reader.number<std::uint64_t>())};
}

McapReader::Map read_map(ByteReader& reader) {
  ByteReader entries{reader.take(reader.number<std::uint32_t>())};
  McapReader::Map map;
  while (entries.remaining() > 0) {
    std::string key = entries.string();
    map.insert_or_assign(std::move(key), entries.string());
  }
  return map;
}

void check_crc(std::uint32_t recorded, ByteView bytes, const char* of_what) {
  if (recorded != 0 && crc32(bytes) != recorded)
    damaged(std::string("the checksum of ") + of_what + " is wrong");
}

// The records of a chunk, decompressed into `buffer` where that is needed.
ByteView open_chunk(ByteView content, Bytes& buffer) {
  ByteReader reader{content};
  reader.take(8 + 8);  // first and last time
  const auto size = reader.number<std::uint64_t>();
  const auto crc = reader.number<std::uint32_t>();
  const std::string compression = reader.string();
  ByteView records = reader.take(reader.number<std::uint64_t>());

  if (compression == "zstd") {
    if (size > max_chunk_size) damaged("a chunk of " + std::to_string(size) + " bytes");
    if (ZSTD_getFrameContentSize(records.data(), records.size()) != size)
      damaged("a chunk is not of its size");
    buffer.resize(static_cast<std::size_t>(size));
    const std::size_t got = ZSTD_decompress(buffer.data(), buffer.size(), records.data(), records.size());
    if (ZSTD_isError(got) != 0 || got != size) damaged("a chunk cannot be decompressed");
    records = buffer;
  } else if (!compression.empty()) {
    throw Malformed{"a chunk is compressed with '" + compression + "'; expected zstd"};
  }
  check_crc(crc, records, "a chunk");
  return records;
}

constexpr std::size_t magic_size = mcap::magic.size();
constexpr std::size_t tail_size = mcap::footer_size + magic_size;

/// Throws Malformed unless the file begins and ends as those of MCAP do.
void check_magic(ByteView file) {
  const ByteView magic{mcap::magic};
  const ByteView start = file.first(std::min(file.size(), magic_size));
  if (file.empty()) throw Malformed{"empty file; expected a recording (MCAP)"};
  if (!std::equal(start.begin(), start.end(), magic.begin())) {
    if (start.size() == magic_size && std::equal(start.begin(), start.begin() + 5, magic.begin())) {
      throw Malformed{"an MCAP file of another major version than 0, or damaged in its first bytes"};
    }
    throw Malformed{"not a recording: it does not begin as an MCAP file does"};
  }
  if (file.size() < magic_size + tail_size || !std::ranges::equal(file.last(magic_size), magic)) {
    throw Malformed{"truncated recording: the footer is missing; " + std::to_string(file.size()) +
                    " bytes read"};
  }
}

/// Where the data section ends and, if there is one, the summary begins. Throws Malformed unless the footer
/// and the summary are whole.
std::size_t end_of_data(ByteView file) {
  const ByteView tail = file.last(tail_size);
  ByteReader tail_reader{tail};
  const auto [opcode, content] = next_record(tail_reader);
  if (opcode != Opcode::footer || content.size() != mcap::footer_size - mcap::prefix_size) {
    throw Malformed{"truncated or damaged recording: the footer is missing; " + std::to_string(file.size()) +
                    " bytes read"};
  }
  ByteReader footer{content};
  const auto summary_start = footer.number<std::uint64_t>();
  footer.take(8);  // summary_offset_start
  const auto summary_crc = footer.number<std::uint32_t>();
  const std::size_t tail_offset = file.size() - tail_size;
  if (summary_start > tail_offset) damaged("the footer points beyond the end");
  const std::size_t data_end = summary_start == 0 ? tail_offset : static_cast<std::size_t>(summary_start);
  const std::size_t crc_end = tail_offset + mcap::footer_size - sizeof(summary_crc);
  check_crc(summary_crc, file.subspan(data_end, crc_end - data_end), "the summary");
  return data_end;
}

}  // namespace

McapReader::McapReader(ByteView file) {
  check_magic(file);
  const std::size_t data_end = end_of_data(file);

  // data section: header, records, end
  if (data_end < magic_size) damaged("the footer points into the first bytes");
  ByteReader data{file.subspan(magic_size, data_end - magic_size)};
  const Record header = next_record(data);
  if (header.opcode != Opcode::header) damaged("the header is missing");
  ByteReader header_reader{header.content};
  profile_ = header_reader.string();
  library_ = header_reader.string();

  const ByteView records = file.subspan(data_end - data.remaining(), data.remaining());
  bool ended = false;
  while (data.remaining() > 0) {
    const std::size_t here = data_end - data.remaining();
    const Record record = next_record(data);
    if (record.opcode == Opcode::data_end) {
      check_crc(ByteReader{record.content}.number<std::uint32_t>(), file.first(here), "the data section");
      if (data.remaining() > 0) damaged("records follow the end of the data section");
      data_ = records.first(records.size() - (data_end - here));
      ended = true;
    }
  }
  if (!ended) damaged("the end of the data section is missing");

  // schemas and channels of chunks are repeated in the summary, so no chunk is opened for them
  collect(data_);
  collect(file.subspan(data_end, file.size() - tail_size - data_end));
}

void McapReader::collect(ByteView records) {
  ByteReader reader{records};
  while (reader.remaining() > 0) {
    const auto [opcode, content] = next_record(reader);
    collect(opcode, content);
  }
}

void McapReader::collect(Opcode opcode, ByteView content) {
  ByteReader reader{content};
  switch (opcode) {
    case Opcode::schema: {
      const auto id = reader.number<std::uint16_t>();
      Schema schema{.name = reader.string(), .encoding = reader.string(), .text = reader.string()};
      schemas_.insert_or_assign(id, std::move(schema));
      break;
    }
    case Opcode::channel: {
      const auto id = reader.number<std::uint16_t>();
      const auto schema = reader.number<std::uint16_t>();
      channels_.insert_or_assign(id, Channel{schema, reader.string(), reader.string()});
      break;
    }
    case Opcode::metadata: {
      std::string name = reader.string();
      metadata_.insert_or_assign(std::move(name), read_map(reader));
      break;
    }
    case Opcode::attachment: {
      reader.take(8 + 8);  // log and creation time
      std::string name = reader.string();
      reader.string();  // media type
      std::string data = ByteReader::text(reader.take(reader.number<std::uint64_t>()));
      const std::size_t checked = content.size() - reader.remaining();
      check_crc(reader.number<std::uint32_t>(), content.first(checked), "an attachment");
      attachments_.insert_or_assign(std::move(name), std::move(data));
      break;
    }
    default:
      break;
  }
}

void McapReader::for_each_message(const std::function<void(const Message&)>& see) const {
  const auto see_message = [&see](ByteView content) {
    ByteReader reader{content};
    Message message;
    message.channel = reader.number<std::uint16_t>();
    reader.take(4);  // sequence
    message.time = reader.number<std::uint64_t>();
    reader.take(8);  // publish time
    message.data = reader.take(reader.remaining());
    see(message);
  };
  Bytes buffer;
  ByteReader reader{data_};
  while (reader.remaining() > 0) {
    const auto [opcode, content] = next_record(reader);
    if (opcode == Opcode::message) see_message(content);
    if (opcode != Opcode::chunk) continue;
    ByteReader chunk{open_chunk(content, buffer)};
    while (chunk.remaining() > 0) {
      const Record record = next_record(chunk);
      if (record.opcode == Opcode::message) see_message(record.content);
    }
  }
}

}  // namespace fairway
