// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/mcap_writer.hpp"
#include "fairway/record/testing/sample_run.hpp"

namespace fairway {
namespace {

using mcap::Opcode;
using testing::bytes_in;
using ::testing::ElementsAre;

struct Found {
  Opcode opcode{};
  std::size_t offset{};
  ByteView content;
};

// Records from the front until the bytes are used up.
std::vector<Found> records_in(ByteView file, std::size_t from, std::size_t to) {
  std::vector<Found> found;
  ByteReader reader{file.subspan(from, to - from)};
  while (reader.remaining() > 0) {
    const std::size_t offset = to - reader.remaining();
    const auto opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
    found.push_back({opcode, offset, reader.take(reader.number<std::uint64_t>())});
  }
  return found;
}

Bytes small_file() {
  const TemporaryFolder folder;
  McapWriter writer{folder.file("a.mcap"), "p", "l", 64};  // a chunk every few messages
  const auto schema = writer.add_schema("pkg/msg/Type", "ros2msg", "uint8 x\n");
  const auto a = writer.add_channel(schema, "/a", "cdr");
  const auto b = writer.add_channel(schema, "/b", "cdr");
  writer.add_metadata("m", {{"k", "v"}, {"", ""}});
  writer.attach("f", "text/plain", "hello");
  for (std::uint64_t i = 0; i < 10; ++i)
    writer.write(i % 3 == 0 ? b : a, 100 + i, bytes_of(std::string(i, 'x')));
  writer.finish();
  return bytes_in(folder.file("a.mcap"));
}

TEST(Mcap, BeginsAndEndsAsTheSpecificationSays) {
  const TemporaryFolder folder;
  McapWriter writer{folder.file("a.mcap"), "p", "lib"};
  writer.finish();
  const Bytes file = bytes_in(folder.file("a.mcap"));
  std::vector<int> start;
  for (std::size_t i = 0; i < 8 + 9 + 12; ++i) start.push_back(static_cast<int>(file[i]));
  EXPECT_THAT(start, ElementsAre(0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n',  // magic
                                 1, 12, 0, 0, 0, 0, 0, 0, 0,                 // header, 12 bytes
                                 1, 0, 0, 0, 'p', 3, 0, 0, 0, 'l', 'i', 'b'));
  EXPECT_TRUE(std::ranges::equal(ByteView{file}.last(8), mcap::magic));
}

TEST(Mcap, OffsetsPointWhereTheySay) {
  const Bytes file = small_file();
  const std::size_t footer_start = file.size() - 8 - mcap::footer_size;
  const auto footer = records_in(file, footer_start, file.size() - 8);
  ByteReader footer_reader{footer.at(0).content};
  const auto summary_start = footer_reader.number<std::uint64_t>();
  const auto offsets_start = footer_reader.number<std::uint64_t>();

  std::map<std::size_t, Found> data;
  for (const Found& r : records_in(file, 8, summary_start)) data[r.offset] = r;
  std::size_t chunks = 0;
  for (const Found& record : records_in(file, summary_start, offsets_start)) {
    ByteReader reader{record.content};
    if (record.opcode == Opcode::chunk_index) {
      ++chunks;
      const auto first = reader.number<std::uint64_t>();
      const auto last = reader.number<std::uint64_t>();
      const auto offset = reader.number<std::uint64_t>();
      const auto length = reader.number<std::uint64_t>();
      const Found& chunk = data.at(offset);
      EXPECT_EQ(chunk.opcode, Opcode::chunk);
      EXPECT_EQ(length, chunk.content.size() + mcap::prefix_size);
      ByteReader chunk_reader{chunk.content};
      EXPECT_EQ(chunk_reader.number<std::uint64_t>(), first);
      EXPECT_EQ(chunk_reader.number<std::uint64_t>(), last);
      EXPECT_GE(last, first);

      // the message indexes lie behind the chunk, one a channel
      ByteReader map{reader.take(reader.number<std::uint32_t>())};
      std::size_t end = offset + length;
      while (map.remaining() > 0) {
        const auto channel = map.number<std::uint16_t>();
        const Found& index = data.at(map.number<std::uint64_t>());
        EXPECT_EQ(index.opcode, Opcode::message_index);
        EXPECT_EQ(index.offset, end);
        EXPECT_EQ(ByteReader{index.content}.number<std::uint16_t>(), channel);
        end += index.content.size() + mcap::prefix_size;
      }
      EXPECT_EQ(reader.number<std::uint64_t>(), end - offset - length);
    } else if (record.opcode == Opcode::metadata_index || record.opcode == Opcode::attachment_index) {
      const Found& target = data.at(reader.number<std::uint64_t>());
      EXPECT_EQ(target.opcode,
                record.opcode == Opcode::metadata_index ? Opcode::metadata : Opcode::attachment);
      EXPECT_EQ(reader.number<std::uint64_t>(), target.content.size() + mcap::prefix_size);
    }
  }
  EXPECT_GT(chunks, 2U);

  // groups of the summary
  std::size_t covered = summary_start;
  for (const Found& record : records_in(file, offsets_start, footer_start)) {
    ByteReader reader{record.content};
    const auto opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
    const auto start = reader.number<std::uint64_t>();
    const auto length = reader.number<std::uint64_t>();
    EXPECT_EQ(start, covered);
    covered += length;
    for (const Found& r : records_in(file, start, start + length)) EXPECT_EQ(r.opcode, opcode);
  }
  EXPECT_EQ(covered, offsets_start);
}

TEST(Mcap, IsReadAsItWasWritten) {
  const Bytes file = small_file();
  const McapReader reader{file};
  EXPECT_EQ(reader.profile(), "p");
  EXPECT_EQ(reader.library(), "l");
  EXPECT_EQ(reader.schemas().at(1).text, "uint8 x\n");
  EXPECT_EQ(reader.channels().at(1).topic, "/b");
  EXPECT_THAT(reader.metadata().at("m"), ElementsAre(std::pair{"", ""}, std::pair{"k", "v"}));
  EXPECT_EQ(reader.attachments().at("f"), "hello");
  std::uint64_t i = 0;
  reader.for_each_message([&](const McapReader::Message& message) {
    EXPECT_EQ(message.channel, i % 3 == 0 ? 1 : 0);
    EXPECT_EQ(message.time, 100 + i);
    EXPECT_EQ(ByteReader::text(message.data), std::string(i, 'x'));
    ++i;
  });
  EXPECT_EQ(i, 10U);
}

}  // namespace
}  // namespace fairway
