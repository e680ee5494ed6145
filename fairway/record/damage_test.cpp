// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "fairway/core/error.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/layout.hpp"
#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/mcap_writer.hpp"
#include "fairway/record/testing/parsed.hpp"
#include "fairway/record/testing/sample_run.hpp"

// Nothing but InputError may come of a file, whatever is in it.

namespace fairway {
namespace {

using testing::accepted;
using testing::bytes_in;
using ::testing::HasSubstr;
using testing::refusal;
using testing::SampleRun;
using ::testing::StartsWith;

Bytes sample() {
  SampleRun run{2, 3};
  run.perceive();
  run.sketch();
  run.speak();
  return testing::recorded_bytes(run);
}

TEST(DamagedRecording, IsRefusedAtEveryLength) {
  const Bytes whole = sample();
  ASSERT_EQ(refusal(whole), accepted);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    ASSERT_THAT(refusal(ByteView{whole}.first(size)), StartsWith("run.mcap: ")) << size;
  }
  EXPECT_EQ(refusal({}), "run.mcap: empty file; expected a recording (MCAP)");
  EXPECT_EQ(refusal(ByteView{whole}.first(1000)),
            "run.mcap: truncated recording: the footer is missing; 1000 bytes read");
}

TEST(DamagedRecording, IsRefusedWhereverABitIsFlipped) {
  Bytes bytes = sample();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::byte kept = bytes[i];
    bytes[i] ^= std::byte{1} << static_cast<int>(i % 8);
    ASSERT_NE(refusal(bytes), accepted) << "byte " << i << " of " << bytes.size();
    bytes[i] = kept;
  }
}

// The same file with every checksum 0, which means that there is none: lengths are all that is left to
// protect the reader.
Bytes without_checksums(Bytes bytes) {
  std::size_t at = mcap::magic.size();
  while (at < bytes.size() - mcap::magic.size()) {
    std::uint64_t length{};
    std::memcpy(&length, bytes.data() + at + 1, sizeof(length));
    std::byte* content = bytes.data() + at + mcap::prefix_size;
    const auto opcode = static_cast<mcap::Opcode>(bytes[at]);
    if (opcode == mcap::Opcode::chunk) std::memset(content + 24, 0, 4);
    if (opcode == mcap::Opcode::attachment || opcode == mcap::Opcode::data_end ||
        opcode == mcap::Opcode::footer) {
      std::memset(content + length - 4, 0, 4);
    }
    at += mcap::prefix_size + length;
  }
  return bytes;
}

/// Whoever prints a recording, as JSON too, relies on it.
void expect_all_text(const Recording& recording) {
  const RecordingInfo& info = recording.info();
  std::vector<std::string> texts{info.version, info.scenario_name, info.scenario_yaml,
                                 info.program, info.machine,       recording.divergence()};
  for (const RecordingInfo::Vehicle& vehicle : info.vehicles)
    texts.insert(texts.end(), {vehicle.name, vehicle.model});
  for (std::size_t i = 0; i < recording.size(); ++i) {
    for (const VehicleFrame& vehicle : recording.frame(i).vehicles)
      for (const Stroke& stroke : vehicle.strokes) texts.push_back(stroke.meaning);
  }
  for (const std::string& text : texts) EXPECT_FALSE(not_utf8(text)) << text;
}

TEST(DamagedRecording, WithoutChecksumsIsReadOrRefused) {
  const Bytes whole = without_checksums(sample());
  ASSERT_EQ(refusal(whole), accepted);
  Rng rng{1};
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    Bytes bytes = whole;
    for (std::uint64_t n = rng.index(3) + 1; n > 0; --n) {
      bytes[rng.index(bytes.size())] = static_cast<std::byte>(rng.index(256));
    }
    const bool is_accepted = refusal(bytes) == accepted;
    refused += is_accepted ? 0 : 1;
    if (is_accepted) expect_all_text(Recording::parse(bytes, "run.mcap"));
  }
  EXPECT_GT(refused, 2000);  // the rest hit text that means nothing to the reader
}

TEST(DamagedRecording, WithAHugeLengthTakesNoMemoryForIt) {
  // greatest and middling lengths at every place; too much memory would be std::bad_alloc, no InputError
  Bytes bytes = without_checksums(sample());
  for (const std::size_t width : {4, 8}) {
    for (std::size_t i = mcap::magic.size(); i + width < bytes.size(); ++i) {
      std::array<std::byte, 8> kept{};
      std::memcpy(kept.data(), bytes.data() + i, width);
      std::memset(bytes.data() + i, 0x7F, width);
      refusal(bytes);
      std::memcpy(bytes.data() + i, kept.data(), width);
    }
  }
}

TEST(ForeignFile, IsRefusedWithWhatItIs) {
  EXPECT_EQ(refusal(bytes_of("name: crossing\nvehicles: []\n")),
            "run.mcap: not a recording: it does not begin as an MCAP file does");
  EXPECT_THAT(refusal(bytes_of("\x89MCAP1\r\n some bytes that mean something later")),
              HasSubstr("major version"));
  const TemporaryFolder folder;
  McapWriter mcap{folder.file("other.mcap"), "", "another tool"};
  mcap.finish();
  EXPECT_EQ(refusal(bytes_in(folder.file("other.mcap"))),
            "run.mcap: not a recording of fairway: an MCAP file by 'another tool'");
}

TEST(MissingFile, IsNamed) {
  EXPECT_EQ(refusal_by([] { Recording::read("no/such.mcap"); }),
            "no/such.mcap: cannot be read: No such file or directory; expected a recording (MCAP)");
  EXPECT_THAT(refusal_by([] { Recording::read("/"); }), HasSubstr("Is a directory"));
}

}  // namespace
}  // namespace fairway
