// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/record/diff.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/quantities.hpp"
#include "fairway/record/testing/sample_run.hpp"
#include "fairway/record/word_messages.hpp"

namespace fairway {
namespace {

using testing::checked;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::recorded;
using testing::recorded_bytes;
using testing::SampleRun;
using testing::SpeakingRun;

/// All of a run, in order.
std::vector<SpokenWord> words_of(const SampleRun& run) {
  std::vector<SpokenWord> all;
  for (const auto& said : run.words) all.insert(all.end(), said.begin(), said.end());
  return all;
}

TEST(RecordedWord, IsGivenBackToTheBitInItsFrame) {
  const SpeakingRun run{3, 60};
  const Recording recording = recorded(run);
  EXPECT_TRUE(std::ranges::equal(recording.words(), words_of(run)));
  for (std::size_t i = 0; i < run.size(); ++i)
    EXPECT_TRUE(std::ranges::equal(recording.frame(i).words, run.words[i])) << i;
  EXPECT_EQ(recording.words().back().speech.size, Speech::most_bytes);
}

TEST(RecordedWord, IsKeptWhereItsFrameIsNot) {
  const SpeakingRun run{3, 11};
  const Recording recording = recorded(run, 4);  // frames 0, 4 and 8
  EXPECT_TRUE(std::ranges::equal(recording.words(), words_of(run)));
  EXPECT_THAT(recording.frame(0).words, IsEmpty());
  EXPECT_THAT(recording.frame(1).words, ElementsAre(run.words[2][0], run.words[4][0]));
  EXPECT_THAT(recording.frame(2).words, ElementsAre(run.words[6][0], run.words[8][0]));
}

TEST(RecordedWord, IsWrittenWhenItIsSaid) {
  auto times = testing::writings(recorded_bytes(SpeakingRun{3, 10}));
  EXPECT_THAT(times["/fairway/words"], ElementsAre(2, 4, 6, 8));
}

TEST(RecordedWord, LeavesARecordingOfNobodyWhoSpeaksAsItIs) {
  SpeakingRun silent;
  for (auto& said : silent.words) said.clear();
  EXPECT_EQ(recorded_bytes(silent), recorded_bytes(SampleRun{}));
  EXPECT_EQ(recorded(SpeakingRun{}).run_hash(), recorded(SampleRun{}).run_hash());
}

TEST(RecordedWord, IsWrittenWithoutAllocatingOnceTheBuffersHaveGrown) {
  EXPECT_LE(testing::allocations_from(600, SpeakingRun{4, 800}),
            8);  // entries that chunks add to the summary
}

TEST(WordMessage, IsRefusedForWhatIsNoWord) {
  const auto refusal_of = [](const auto& change) -> std::string {
    Bytes message;
    encode_word(message, {1, 0.5, {.bytes = {7, 8}, .size = 2}});
    change(message);
    try {
      decode_word(message);
    } catch (const Malformed& error) {
      return error.what();
    }
    return "accepted";
  };
  constexpr std::size_t length_before_end = 6;  // and two bytes
  EXPECT_EQ(refusal_of([](Bytes&) {}), "accepted");
  EXPECT_THAT(refusal_of([](Bytes& m) { m.pop_back(); }), HasSubstr("2 bytes where 1 are left"));
  EXPECT_THAT(refusal_of([](Bytes& m) { m.push_back(std::byte{0}); }), HasSubstr("damaged recording"));
  EXPECT_THAT(refusal_of([](Bytes& m) {
                m[m.size() - length_before_end] = std::byte{0};
                m.resize(m.size() - 2);
              }),
              HasSubstr("a word has 0 bytes; expected 1 to 25"));
  EXPECT_THAT(refusal_of([](Bytes& m) {
                m[m.size() - length_before_end] = std::byte{26};
                m.resize(m.size() + 24);
              }),
              HasSubstr("a word has 26 bytes"));
}

TEST(RecordedWord, OfNobodyThereOrOutOfOrderIsRefused) {
  const auto refusal_of = [](const SpokenWord& changed) {
    SpeakingRun run{3, 10};
    run.words[6] = {changed};
    return refusal_by([&] { recorded(run); });
  };
  EXPECT_THAT(refusal_of({3, 0.6, {.size = 1}}), HasSubstr("a word of a vehicle that is not there"));
  EXPECT_THAT(refusal_of({1, 0.3, {.size = 1}}), HasSubstr("words are not in order"));
}

TEST(HashChecker, ComparesWhatWasSaidWhereItIsRecorded) {
  SpeakingRun now{3, 10};
  const Recording recording = recorded(now), thinned = recorded(now, 3);
  EXPECT_TRUE(checked(recording, now).same());
  EXPECT_TRUE(checked(thinned, now).same());
  EXPECT_THAT(checked(recording, now).describe(), HasSubstr("recorded frames, and what was said"));
  EXPECT_TRUE(checked(recorded(SampleRun{3, 10}), now).same()) << "one without words says nothing of them";

  now.words[5] = now.words[4];
  EXPECT_FALSE(checked(recording, now).same());
  now.words[5].clear();
  now.words[8].clear();
  EXPECT_EQ(checked(recording, now).describe(), "another number of words: 4 were said, now 3");
  now.words[4][0].speech.bytes[1] = 0x5a;
  EXPECT_THAT(checked(thinned, now).describe(), HasSubstr("from tick 4 (0.4 s): words[1].bytes: "));
}

TEST(Diff, NamesTheFirstWordThatDiffers) {
  const SpeakingRun a{3, 10};
  SpeakingRun b{3, 10}, c{3, 10};
  b.words[6][0].from = 1;
  const Difference d = diff(recorded(a), recorded(b, 2));
  ASSERT_TRUE(d.first);
  EXPECT_EQ(d.first->tick, Tick{6});
  EXPECT_EQ(d.first->quantity, "words[2].from_index");
  c.words[8].clear();
  EXPECT_THAT(diff(recorded(a), recorded(c)).describe(),
              HasSubstr("tick 8 (0.8 s): word_count: 4 against 3"));
  EXPECT_TRUE(diff(recorded(a), recorded(SpeakingRun{3, 10})).same());
  const Difference unknown = diff(recorded(a), recorded(SampleRun{3, 10}));
  EXPECT_TRUE(unknown.same());
  EXPECT_THAT(unknown.setup, ElementsAre("word_count: 4 against 0"));
}

TEST(Diff, OfWordsLeavesAnEarlierDifferenceOfFramesFirst) {
  const SpeakingRun a{3, 10};
  SpeakingRun b{3, 10};
  b.words[6][0].from = 1;
  b.at(5, 2).power += 1.0;
  EXPECT_EQ(diff(recorded(a), recorded(b)).first->quantity, "power_w");
  b.words[4][0].from = 0;
  EXPECT_EQ(diff(recorded(a), recorded(b)).first->quantity, "words[1].from_index");
}

}  // namespace
}  // namespace fairway
