// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/merge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/experiment/local_store.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::size_t all_runs = 60;

Maker on(const std::string& processor, const std::string& host) {
  return {.version = "1",
          .commit = "c",
          .epoch = "5",
          .compiler = "g++",
          .c_library = "glibc",
          .processor = processor,
          .host = host};
}

class MergeTest : public ::testing::Test {
 protected:
  /// A store of those runs of the campaign whose index `holds`.
  template <class Holds>
  std::string part(const std::string& name, const Holds& holds,
                   const Origin& origin = {.campaign = "test", .digest = "d", .run_count = all_runs}) {
    const std::string file = folder_.file(name);
    std::vector<RunRecord> records;
    for (std::size_t i = 0; i < all_runs; ++i) {
      if (holds(i)) records.push_back(sample::records(all_runs)[i]);
    }
    Store store = Store::open(file);
    store.put(records);
    store.note(origin);
    store.note(on("x86_64", name));
    return file;
  }
  std::string third(std::size_t rest) {
    return part("part" + std::to_string(rest) + ".db", [=](std::size_t i) { return i % 3 == rest; });
  }

  /// What merging ends with, without the folder's name.
  std::string refusal(const std::vector<std::string>& files) const {
    std::string message = refusal_by([&] {
      Store store = Store::in_memory();
      merge_into(store, "all.db", files);
    });
    const std::string prefix = folder_.file("");
    for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix))
      message.erase(at, prefix.size());
    return message;
  }

  TemporaryFolder folder_;
};

TEST_F(MergeTest, OfShardsInAnyOrderGivesTheBytesOfOneMachine) {
  Store one = Store::in_memory();
  one.put(sample::records(all_runs));
  std::vector<std::string> files{third(0), third(1), third(2)};
  do {
    Store store = Store::in_memory();
    const MergeReport report = merge_into(store, "all.db", files);
    EXPECT_EQ(sample::csv_of(store), sample::csv_of(one));
    EXPECT_EQ(report.runs, all_runs);
    EXPECT_EQ(report.missing(), 0U);
    EXPECT_THAT(report.origin.makers, SizeIs(3));
  } while (std::ranges::next_permutation(files).found);
}

TEST_F(MergeTest, AgainAndAgainIsTheSame) {
  Store store = Store::in_memory();
  merge_into(store, "all.db", std::vector{third(0), third(1)});
  const std::string before = sample::csv_of(store);
  EXPECT_EQ(merge_into(store, "all.db", std::vector{third(1), third(0), third(0)}).missing(), all_runs / 3);
  EXPECT_EQ(sample::csv_of(store), before);
}

TEST_F(MergeTest, TakesRunsThatShardsShareOnce) {
  Store store = Store::in_memory();
  const auto most = part("most.db", [](std::size_t i) { return i < 50; });
  EXPECT_EQ(merge_into(store, "all.db", std::vector{third(2), most}).runs, 50U + 4U);
}

TEST_F(MergeTest, PrefersTheAttemptThatWentWell) {
  RunRecord failed = sample::records(1).front();
  failed.measures.clear();
  failed.failure = "broke";
  for (const bool first : {true, false}) {
    const std::string file = folder_.file(first ? "a.db" : "b.db");
    {
      Store store = Store::open(file);
      store.note(Origin{.campaign = "test", .digest = "d", .run_count = all_runs});
      store.put(std::vector{failed});
    }
    Store store = Store::in_memory();
    const MergeReport report =
        merge_into(store, "all.db", first ? std::vector{file, third(0)} : std::vector{third(0), file});
    EXPECT_EQ(report.failed, 0U);
    EXPECT_EQ(report.runs, all_runs / 3);
  }
}

TEST_F(MergeTest, RefusesWhatIsOfAnotherCampaignAndSaysWhich) {
  const auto none = [](std::size_t) { return false; };
  EXPECT_THAT(refusal({third(0), part("other.db", none, {.campaign = "other", .digest = "e"})}),
              HasSubstr("other.db: is of campaign other, and part0.db of campaign test; nothing was merged"));
  EXPECT_THAT(refusal({third(0), part("new.db", none, {.campaign = "test", .digest = "e"})}),
              HasSubstr("new.db: is of another version of campaign test than part0.db"));
}

TEST_F(MergeTest, RefusesAnotherResultsEpoch) {
  const std::string file = third(0);
  Database{file, Database::Access::existing, 0}.execute(
      "UPDATE meta SET value = '1' WHERE name = 'results_epoch'");
  EXPECT_THAT(refusal({file}), HasSubstr("part0.db: is of results epoch 1, and this fairway of "));
}

TEST_F(MergeTest, RefusesOtherResultsOfTheSameRun) {
  const std::string file = third(1);
  Database{file, Database::Access::existing, 0}.execute(
      "UPDATE measures SET value = value * (1 + 2.3e-16) WHERE vehicle = -1; UPDATE marks SET digest = ''");
  const std::string all = part("all_of_one.db", [](std::size_t) { return true; });
  EXPECT_THAT(refusal({all, file}), AllOf(HasSubstr("part1.db: came to other results of the run case="),
                                          HasSubstr("than all_of_one.db"), HasSubstr("same bits")));
}

TEST_F(MergeTest, RefusesTwoVersionsOfOneRun) {
  const std::string file = third(1);
  Database{file, Database::Access::existing, 0}.execute("UPDATE runs SET key = key || 'x'");
  EXPECT_THAT(refusal({third(0), file, part("part.db", [](std::size_t i) { return i % 3 == 1; })}),
              HasSubstr("part.db: has another version of the run case="));
}

TEST_F(MergeTest, RefusesADamagedStoreByItsName) {
  const std::string file = third(1);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_THAT(refusal({third(0), file}), HasSubstr("part1.db: is a damaged store"));
}

TEST_F(MergeTest, RefusesRunsOfTwoStudies) {
  std::vector<std::string> files;
  for (const std::string study : {"cubes", "uuv"}) {
    RunRecord record = sample::records(1).front();
    record.spec.key = study + "/cube20_8/1";
    files.push_back(folder_.file(study + ".db"));
    Store::open(files.back()).put(std::vector{record});
  }
  EXPECT_THAT(refusal(files), HasSubstr("uuv.db: is of study uuv, and cubes.db of study cubes"));
}

TEST_F(MergeTest, ALocalStoreStandsInItsPlaceOnlyWhenItIsPublished) {
  const std::string file = folder_.file("all.db");
  {
    LocalStore local{file};
    local.store().put(sample::records(3));
    EXPECT_FALSE(std::filesystem::exists(file));
    local.publish();
    EXPECT_EQ(Store::open_existing(file).size(), 3U);
    local.store().put(sample::records(5));
    EXPECT_EQ(Store::open_existing(file).size(), 3U);
  }
  EXPECT_EQ(Store::open_existing(file).size(), 3U);
  LocalStore goes_on{file};
  EXPECT_EQ(goes_on.store().size(), 3U);
}

TEST_F(MergeTest, ALocalStoreIsTheOnlyWriterOfItsFile) {
  const std::string file = folder_.file("all.db");
  {
    LocalStore local{file};
    EXPECT_THAT(refusal_by([&] { LocalStore{file}; }), HasSubstr("all.db: another process is writing to it"));
    EXPECT_THAT(refusal_by([&] { Store::open(file); }),
                HasSubstr("all.db: another process is writing to it"));
    local.publish();
  }
  EXPECT_FALSE(std::filesystem::exists(file + ".lock"));
  const Store swept = Store::open(file);
  EXPECT_THAT(refusal_by([&] { LocalStore{file}; }), HasSubstr("all.db: another process is writing to it"));
}

TEST_F(MergeTest, CountsAsMissingWhatIsNotOfThisCampaignAsItIs) {
  const std::string file = folder_.file("grown.db");
  const std::vector<RunRecord> records = sample::records(all_runs);
  {
    Store store = Store::open(file);
    store.note(Origin{.campaign = "before", .digest = "b", .run_count = 50});
    store.put(std::span{records}.first(50));
    store.note(Origin{.campaign = "test", .digest = "d", .run_count = all_runs});
    store.put(std::span{records}.last(10));
  }
  Store store = Store::in_memory();
  const MergeReport report = merge_into(store, "all.db", std::vector{file});
  EXPECT_EQ(report.runs, all_runs);
  EXPECT_EQ(report.of_campaign, 10U);
  EXPECT_EQ(report.missing(), 50U);
  // some of them are asked for by this one, too
  store.note(Origin{.campaign = "test", .digest = "d", .run_count = all_runs});
  store.claim(sample::specs(20));
  EXPECT_EQ(store.campaign_size(), 30U);
}

TEST_F(MergeTest, OfStoresWithoutMarksTakesEveryRunForTheCampaigns) {
  const std::string file = third(0);
  Database{file, Database::Access::existing, 0}.execute("DROP TABLE marks");
  Store store = Store::in_memory();
  EXPECT_EQ(merge_into(store, "all.db", std::vector{file, third(1)}).missing(), all_runs / 3);
}

TEST_F(MergeTest, ALocalStoreThatCannotBePublishedIsKept) {
  std::filesystem::create_directory(folder_.file("nowhere"));
  LocalStore local{folder_.file("nowhere/all.db")};
  local.store().put(sample::records(3));
  std::filesystem::remove_all(folder_.file("nowhere"));
  const std::string message = refusal_by([&] { local.publish(); });
  EXPECT_THAT(message, HasSubstr("nowhere/all.db: cannot be written"));
  const std::string kept = message.substr(message.find("kept in ") + 8);
  EXPECT_EQ(Store::open_existing(kept).size(), 3U);
  std::filesystem::remove_all(std::filesystem::path(kept).parent_path());
}

TEST(Makers, AreToldByKindWithTheirHosts) {
  const std::vector<Maker> makers{on("x86_64", "n2"), on("aarch64", "a1"), on("x86_64", "n1")};
  EXPECT_THAT(kinds_of(makers), ElementsAre("fairway 1 (c, epoch 5), g++, glibc, aarch64: a1",
                                            "fairway 1 (c, epoch 5), g++, glibc, x86_64: n1, n2"));
  EXPECT_THAT(remark_on(makers), HasSubstr("2 kinds of program or machine"));
  EXPECT_THAT(remark_on(std::vector{on("x86_64", "n1"), on("x86_64", "n2")}), IsEmpty());
}

TEST(Makers, OfThisMachineAreKnown) {
  const Maker maker = this_maker(true);
  EXPECT_THAT(maker.c_library, HasSubstr("glibc 2."));
  EXPECT_THAT(maker.host, ::testing::Not(IsEmpty()));
  EXPECT_THAT(this_maker(false).host, IsEmpty());
}

}  // namespace
}  // namespace fairway
