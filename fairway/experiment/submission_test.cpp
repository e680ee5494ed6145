// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/submission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"

namespace fairway {
namespace {

using ::testing::HasSubstr;

TEST(Submission, HasShardsThatAreLongEnoughAndEndTogether) {
  // 4 for each of 8 nodes
  EXPECT_EQ(shard_count({.total_s = 1e4, .runs = 100'000, .nodes = 8}), 32U);
  // of 30 s at least: 100 s / 30 s
  EXPECT_EQ(shard_count({.total_s = 100, .runs = 100'000, .nodes = 8}), 3U);
  EXPECT_EQ(shard_count({.total_s = 1, .runs = 100'000, .nodes = 8}), 1U);
  // of four cores, 400 s of work take 100 s
  EXPECT_EQ(shard_count({.total_s = 400, .runs = 100'000, .nodes = 8, .cores = 4}), 3U);
  // half of the limit: 1e5 s / 300 s = 334, of which 328 are 41 for each of 8 nodes
  EXPECT_EQ(shard_count({.total_s = 1e5, .runs = 100'000, .nodes = 8, .limit_s = 600}), 328U);
  // no more than an array may have, nor than there are runs; and none alone in a last round
  EXPECT_EQ(shard_count({.total_s = 1e7, .runs = 10'000'000, .nodes = 1000}), 1000U);
  EXPECT_EQ(shard_count({.total_s = 1e7, .runs = 20, .nodes = 8}), 16U);
}

TEST(Submission, WritesRangesAsSlurmReadsThem) {
  EXPECT_EQ(ranges_text(std::vector<std::uint32_t>{3, 7, 8, 9, 12}), "3,7-9,12");
  EXPECT_EQ(ranges_text(std::vector<std::uint32_t>{}), "");
}

TEST(Submission, ReadsWhatItsFolderHoldsOfEveryShard) {
  const TemporaryFolder folder;
  Submission s{.campaign = "c", .digest = "d", .folder = folder.file(""), .runs = {4, 4, 4, 4, 4}};
  std::filesystem::create_directories(s.folder + "/parts");
  const auto put = [&](std::uint32_t shard, std::size_t runs, const std::string& digest) {
    Store store = Store::open(s.part(shard));
    store.note(Origin{.campaign = "c", .digest = digest});
    store.put(sample::records(runs));
  };
  put(0, 4, "d");
  put(1, 2, "d");
  put(2, 4, "of another version");
  put(3, 4, "d");
  std::filesystem::resize_file(s.part(3), 5000);
  const std::vector<ShardProgress> progress = progress_of(s);
  EXPECT_EQ(progress[0].state, ShardState::whole);
  EXPECT_EQ(progress[1].state, ShardState::begun);
  EXPECT_EQ(progress[1].runs, 2U);
  EXPECT_EQ(progress[2].state, ShardState::damaged);
  EXPECT_EQ(progress[3].state, ShardState::damaged);
  EXPECT_EQ(progress[4].state, ShardState::missing);
}

TEST(Submission, CountsTheRunsOfItsOwnVersionOfTheCampaignAlone) {
  const TemporaryFolder folder;
  const Submission s{.campaign = "c", .digest = "new", .folder = folder.file(""), .runs = {4}};
  std::filesystem::create_directories(s.folder + "/parts");
  const std::vector<RunRecord> records = sample::records(4);
  for (const std::string& file : {s.part(0), s.merged()}) {
    Store store = Store::open(file);
    store.note(Origin{.campaign = "c", .digest = "old"});
    store.put(std::span{records}.first(3));
    store.note(Origin{.campaign = "c", .digest = "new"});
    store.put(std::span{records}.last(1));
  }
  EXPECT_EQ(progress_of(s)[0].state, ShardState::begun);
  EXPECT_EQ(progress_of(s)[0].runs, 1U);
  EXPECT_FALSE(is_merged(s));
  {
    Store store = Store::open(s.merged());
    store.note(Origin{.campaign = "c", .digest = "new"});
    store.claim(sample::specs(4));
  }
  EXPECT_TRUE(is_merged(s));
}

TEST(Submission, NamesItsJobsInQuotesForTheScheduler) {
  Submission s{
      .campaign = "two \"words\" \\", .folder = "/f", .engine = "slurm", .runs = {1}, .expected_s = {1}};
  const std::vector<std::uint32_t> shards{0};
  EXPECT_THAT(shards_script(s, shards), HasSubstr(R"(#SBATCH --job-name="two \"words\" \\")"
                                                  "\n"));
  EXPECT_THAT(merge_script(s), HasSubstr(R"(#SBATCH --job-name="two \"words\" \\-merge")"
                                         "\n"));
  s.engine = "mpi";
  EXPECT_THAT(shards_script(s, shards), HasSubstr(R"(#SBATCH --job-name="two \"words\" \\")"
                                                  "\n"));
}

TEST(Submission, KnowsTheErrorOfAShardByTheLastLineOfItsLog) {
  const TemporaryFolder folder;
  const Submission s{.folder = folder.file(""), .runs = {1}};
  std::filesystem::create_directories(s.folder + "/logs");
  EXPECT_EQ(error_of(s, 0), "");
  const auto after = [&](const std::string& line) {
    std::ofstream{s.said(0), std::ios::app} << line << "\n";
    return error_of(s, 0);
  };
  EXPECT_EQ(after("c, shard 0/1: 4 of 4 runs; 4 made, 0 of them failed, 0 were there"), "");
  EXPECT_EQ(after("fairway: p.db: cannot be written: No space left on device"),
            "p.db: cannot be written: No space left on device");
  EXPECT_EQ(after("---- sent again"), "");
  EXPECT_EQ(after("fairway: terminated after 3 runs; the same command goes on from here"), "");
  EXPECT_EQ(after("fairway: warning: the disk is nearly full"), "");
}

TEST(Submission, ThatIsNoneIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal_by([&] { read_submission(folder.file("nowhere")); }),
              HasSubstr("nowhere/submission.json: cannot be read"));
  sample::write_bytes(folder.file("submission.json"), "{\"campaign\": 3}");
  EXPECT_THAT(refusal_by([&] { read_submission(folder.file("")); }),
              HasSubstr("is no submission of fairway"));
}

}  // namespace
}  // namespace fairway
