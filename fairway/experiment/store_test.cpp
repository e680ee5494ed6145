// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/sqlite.hpp"
#include "fairway/experiment/stored_results.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

RunRecord record(const std::string& key, const Labels& labels, std::uint64_t seed,
                 std::vector<Measure> measures) {
  return {.spec = {key, labels, seed}, .measures = std::move(measures), .wall_s = 1.5, .failure = {}};
}

void put(Store& store, const RunRecord& one) { store.put({&one, 1}); }

TEST(StoreTest, GivesBackEverythingThatWasPut) {
  const TemporaryFolder folder;
  const auto records = sample::records(9);
  {
    Store store = Store::open(folder.file("results.db"));
    store.put(records);
  }
  const Store store = Store::open_existing(folder.file("results.db"));
  const auto all = store.all();
  ASSERT_EQ(all.size(), records.size());
  for (const RunRecord& back : all) {
    const auto same = [&](const RunRecord& r) { return r.spec.key == back.spec.key; };
    const RunRecord& given = *std::find_if(records.begin(), records.end(), same);
    EXPECT_EQ(back.spec.labels, given.spec.labels);
    EXPECT_EQ(back.spec.seed, given.spec.seed);
    EXPECT_EQ(back.measures, given.measures);
    EXPECT_EQ(back.wall_s, given.wall_s);
    EXPECT_EQ(back.failure, "");
  }
}

TEST(StoreTest, KeepsTheCommandOfEachCell) {
  const TemporaryFolder folder;
  const std::string file = folder.file("results.db");
  {
    Store store = Store::open(file);
    RunRecord one = record("a", {{"method", "apf"}}, 7, {});
    one.spec.command = "fairway run a.yaml --seed ";
    put(store, one);
    put(store, record("b", {{"method", "orca3d"}}, 8, {}));
  }
  const auto all = Store::open_existing(file).all();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(command_of(all[0].spec), "fairway run a.yaml --seed 7");
  EXPECT_EQ(command_of(all[1].spec), "");
}

TEST(StoreTest, WithoutTheTableOfCommandsIsReadAndContinued) {
  const TemporaryFolder folder;
  const std::string file = folder.file("results.db");
  {
    Store store = Store::open(file);
    put(store, record("old", {{"method", "apf"}}, 1, {}));
  }
  Database{file, Database::Access::existing, 0}.execute("DROP TABLE commands");
  EXPECT_EQ(command_of(Store::open_existing(file).all().at(0).spec), "");
  {
    Store store = Store::open(file);
    RunRecord newer = record("new", {{"method", "orca3d"}}, 2, {});
    newer.spec.command = "fairway run b.yaml --seed ";
    put(store, newer);
  }
  const auto all = Store::open_existing(file).all();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(command_of(all[0].spec), "");
  EXPECT_EQ(command_of(all[1].spec), "fairway run b.yaml --seed 2");
}

TEST(StoreTest, NumbersComeBackToTheBit) {
  using Limit = std::numeric_limits<double>;
  const std::vector<double> values{0.0,
                                   -0.0,
                                   0.1,
                                   1e15,
                                   -9007199254740993.0,
                                   9.3e18,
                                   1.0 / 3.0,
                                   Limit::denorm_min(),
                                   Limit::max(),
                                   Limit::lowest(),
                                   Limit::infinity(),
                                   -Limit::infinity()};
  RunRecord given = record("a", {}, std::numeric_limits<std::uint64_t>::max(), {});
  for (std::size_t i = 0; i < values.size(); ++i)
    given.measures.push_back({"x_m", static_cast<int>(i), values[i]});
  given.measures.push_back({"x_m", Measure::fleet, Limit::quiet_NaN()});

  const TemporaryFolder folder;
  {
    Store store = Store::open(folder.file("results.db"));
    put(store, given);
  }
  const auto all = Store::open_existing(folder.file("results.db")).all();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].spec.seed, std::numeric_limits<std::uint64_t>::max());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(all[0].measures[i].value), std::bit_cast<std::uint64_t>(values[i]))
        << values[i];
  }
  EXPECT_TRUE(std::isnan(all[0].measures.back().value));
}

TEST(StoreTest, OrderIsByLabelsSeedAndKeyWhateverCameFirst) {
  std::vector<RunRecord> records{
      record("e", {{"crit_dist_m", "10"}}, 1, {}), record("d", {{"crit_dist_m", "6"}}, 10, {}),
      record("c", {{"crit_dist_m", "6"}}, 9, {}),  record("a", {{"crit_dist_m", "none"}}, 1, {}),
      record("b", {{"crit_dist_m", "6"}}, 9, {}),  record("f", {{"crit_dist_m", "6.0"}}, 0, {})};
  std::mt19937 shuffler{1};
  for (int round = 0; round < 5; ++round) {
    Store store = Store::in_memory();
    store.put(records);
    std::vector<std::string> keys;
    for (const RunRecord& r : store.all()) keys.push_back(r.spec.key);
    EXPECT_THAT(keys, ElementsAre("b", "c", "d", "f", "e", "a"));
    std::shuffle(records.begin(), records.end(), shuffler);
  }
}

TEST(StoreTest, ARunIsStoredOnceAndAFailureIsReplaced) {
  Store store = Store::in_memory();
  RunRecord run = record("a", {{"method", "apf"}}, 1, {});
  run.failure = "out of battery";
  put(store, run);
  EXPECT_EQ(store.status("a"), Store::Status::failed);
  EXPECT_EQ(store.all()[0].failure, "out of battery");

  run.failure.clear();
  run.measures = {{"makespan_s", Measure::fleet, 1.0}};
  put(store, run);
  EXPECT_EQ(store.status("a"), Store::Status::done);

  run.measures[0].value = 2.0;
  put(store, run);
  ASSERT_EQ(store.size(), 1U);
  EXPECT_EQ(store.all()[0].measures, (std::vector<Measure>{{"makespan_s", Measure::fleet, 1.0}}));
  EXPECT_EQ(store.status("b"), Store::Status::missing);
  EXPECT_TRUE(store.contains("a"));
  EXPECT_FALSE(store.contains("b"));
}

TEST(StoreTest, RefusesRecordsThatMakeNoSenseAndStoresNoneOfTheBatch) {
  Store store = Store::in_memory();
  const auto refused = [&](const RunRecord& bad) {
    const std::vector<RunRecord> batch{record("good", {}, 1, {}), bad};
    EXPECT_THROW(store.put(batch), std::invalid_argument);
    EXPECT_EQ(store.size(), 0U);
  };
  refused(record("", {}, 1, {}));
  refused(record("a", {{"seed", "1"}}, 1, {}));
  refused(record("a", {{"", "1"}}, 1, {}));
  refused(record("a", {{"case", "1"}, {"case", "2"}}, 1, {}));
  refused(record("a", {{"case", "\xff"}}, 1, {}));
  refused(record("a", {}, 1, {{"x_m", 0, 1.0}, {"x_m", 0, 2.0}}));
  // interned names of the failed batch are not taken for stored ones
  store.put(sample::records(2));
  EXPECT_EQ(store.all()[0].measures, sample::measures(0));
}

TEST(StoreTest, OpenedForReadingCannotBeWritten) {
  const TemporaryFolder folder;
  { Store::open(folder.file("results.db")); }
  Store store = Store::open_existing(folder.file("results.db"));
  EXPECT_THROW(store.put(sample::records(1)), std::logic_error);
}

TEST(StoreTest, LeavesNothingBesideTheFileWhenItIsClosed) {
  const TemporaryFolder folder;
  {
    Store store = Store::open(folder.file("results.db"));
    store.put(sample::records(3));
    EXPECT_TRUE(std::filesystem::exists(folder.file("results.db.lock")));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("results.db.lock")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("results.db-journal")));
}

TEST(StoreTest, HasOneWriterAndAnyNumberOfReaders) {
  const TemporaryFolder folder;
  Store writer = Store::open(folder.file("results.db"));
  writer.put(sample::records(2));
  EXPECT_THAT(refusal_by([&] { Store::open(folder.file("./results.db")); }),
              HasSubstr("results.db: another process is writing to it"));
  const Store reader = Store::open_existing(folder.file("results.db"));
  EXPECT_EQ(reader.size(), 2U);
  writer.put(sample::records(6));
  EXPECT_EQ(reader.size(), 6U);
  EXPECT_EQ(sample::csv_of(reader), sample::csv_of(writer));
}

TEST(StoreTest, RemembersTheCampaignAndItsOrder) {
  const TemporaryFolder folder;
  {
    Store store = Store::open(folder.file("results.db"));
    EXPECT_EQ(store.origin().campaign, "");
    store.note({.campaign = "first", .summary = "what for", .order = {{"method", {"orca3d", "apf"}}}});
    store.note({.campaign = "second",
                .quantities = {"makespan_s"},
                .order = {{"case", {"bay"}}, {"method", {"vo", "apf"}}}});
  }
  const Origin origin = Store::open_existing(folder.file("results.db")).origin();
  EXPECT_EQ(origin.campaign, "second");
  EXPECT_EQ(origin.quantities, std::vector<std::string>{"makespan_s"});
  EXPECT_EQ(origin.version, fairway_version);
  EXPECT_EQ(origin.epoch, std::to_string(results_epoch));
  EXPECT_EQ(origin.order, (LabelValues{{"case", {"bay"}}, {"method", {"vo", "apf", "orca3d"}}}));
  EXPECT_EQ(values_of(origin.order, "method").front(), "vo");
  EXPECT_TRUE(values_of(origin.order, "speed").empty());
  EXPECT_THROW(Store::open_existing(folder.file("results.db")).note(Origin{}), std::logic_error);
}

TEST(StoreTest, SeveralAreReadAsOne) {
  const TemporaryFolder folder;
  const std::vector<RunRecord> records = sample::records(6);
  {
    Store one = Store::open(folder.file("one.db"));
    one.note({.campaign = "tides", .order = {{"method", {"orca3d"}}}});
    one.put(std::span{records}.first(4));
    Store two = Store::open(folder.file("two.db"));
    two.put(std::span{records}.last(4));  // two of them are in both
  }
  const StoredResults all = read_stores(std::vector{folder.file("one.db"), folder.file("two.db")});
  EXPECT_EQ(all.records.size(), 6U);
  EXPECT_EQ(all.origin.campaign, "tides, two");
  EXPECT_EQ(values_of(all.origin.order, "method"), std::vector<std::string>{"orca3d"});
}

TEST(StoreTest, SeveralAreReadAlikeInAnyOrder) {
  const TemporaryFolder folder;
  std::vector<RunRecord> records = sample::records(4);
  const auto keep = [&](const std::string& name, const Origin& origin) {
    Store store = Store::open(folder.file(name));
    store.note(origin);
    store.put(records);
    return folder.file(name);
  };
  const auto read = [&](std::vector<std::string> files, Together purpose = Together::compared) {
    std::string said;
    for (int order = 0; order < 2; ++order) {
      const std::string message = refusal_by([&] {
        for (const RunRecord& record : read_stores(files, purpose).records) EXPECT_EQ(record.failure, "");
      });
      said += (order == 0 ? "" : " | ") + message;
      std::ranges::reverse(files);
    }
    return said;
  };
  const std::string one = keep("one.db", {.campaign = "tides", .digest = "d"});
  const std::string grown = keep("grown.db", {.campaign = "tides", .digest = "e"});
  EXPECT_THAT(read({one, grown}), HasSubstr("one.db: is of another version of campaign tides than "));
  EXPECT_THAT(read({one, grown}), HasSubstr("grown.db: is of another version of campaign tides than "));
  EXPECT_EQ(read({one, grown}, Together::compared_mixed), "accepted | accepted");

  const std::string old = keep("old.db", {.campaign = "ebbs"});
  Database{old, Database::Access::existing, 0}.execute(
      "UPDATE meta SET value = '1' WHERE name = 'results_epoch'");
  EXPECT_THAT(read({one, old}), HasSubstr("old.db: is of results epoch 1, and "));
  EXPECT_EQ(read({old}), "accepted | accepted");
  EXPECT_EQ(read({one, old}, Together::compared_mixed), "accepted | accepted");

  const std::string continued = keep("continued.db", {.campaign = "neaps"});
  Store::open(continued).note(Maker{.epoch = "1"});
  EXPECT_THAT(read({continued}), HasSubstr("continued.db: is of results epoch "));
  EXPECT_EQ(read({continued}, Together::compared_mixed), "accepted | accepted");

  records[0].measures[0].value += 1e-9;
  const std::string other = keep("other.db", {});
  EXPECT_THAT(read({one, other}), HasSubstr("other.db: came to other results of the run case="));
  EXPECT_THAT(read({other, one}), HasSubstr("one.db: came to other results of the run case="));

  records[0].measures.clear();
  records[0].failure = "out of battery";
  EXPECT_EQ(read({one, keep("failed.db", {})}), "accepted | accepted");
}

TEST(StoreTest, AFailureThatWasNotStoredIsDamage) {
  const TemporaryFolder folder;
  const std::string file = folder.file("results.db");
  std::vector<RunRecord> records = sample::records(2);
  records[0].measures.clear();
  records[0].failure = "out of battery";
  Store::open(file).put(records);
  EXPECT_EQ(Store::open_existing(file).all().size(), 2U);
  Database{file, Database::Access::existing, 0}.execute("UPDATE runs SET failure = 'x' WHERE failure = ''");
  EXPECT_THAT(refusal_by([&] { Store::open_existing(file).all(); }),
              HasSubstr("a failure that was not stored of the run "));
}

TEST(StoreTest, OfAnotherResultsEpochIsReadButNotContinuedByACampaign) {
  const TemporaryFolder folder;
  const std::string file = folder.file("results.db");
  Store::open(file).put(sample::records(2));
  Database{file, Database::Access::existing, 0}.execute(
      "UPDATE meta SET value = '1' WHERE name = 'results_epoch'");
  EXPECT_EQ(Store::open_existing(file).all().size(), 2U);
  EXPECT_THAT(refusal_by([&] { Store::open(file).refuse_other_epoch(); }),
              HasSubstr("results.db: was begun under results epoch 1, and this fairway is of "));
}

TEST(StoreTest, TheCampaignSaysWhatIsAskedUnlessOneAsksOtherwise) {
  const Origin origin{.quantities = {"makespan_s"}, .order = {{"method", {"vo", "apf"}}}};
  EXPECT_EQ(options_for(origin, {}).quantities, std::vector<std::string>{"makespan_s"});
  EXPECT_EQ(options_for({.quantities = {"energy_j", "makespan_s", "energy_j"}}, {}).quantities,
            (std::vector<std::string>{"energy_j", "makespan_s"}));
  EXPECT_EQ(options_for(origin, {}).order, (std::vector<std::string>{"vo", "apf"}));
  EXPECT_EQ(options_for(origin, {.quantities = {"energy_j"}}).quantities,
            std::vector<std::string>{"energy_j"});
  EXPECT_TRUE(options_for(origin, {.quantities = {"all"}}).quantities.empty());

  StoredResults results{.origin = origin, .records = sample::records(1)};
  add_questions(results, {.quantities = {"energy_j", "makespan_s"}});
  EXPECT_EQ(results.origin.quantities, (std::vector<std::string>{"makespan_s", "energy_j"}));
  add_questions(results, {});
  EXPECT_TRUE(results.origin.quantities.empty());
}

TEST(StoreTest, AMeasureTakesLessThanThirtyBytes) {
  const TemporaryFolder folder;
  {
    Store store = Store::open(folder.file("results.db"));
    std::vector<RunRecord> records = sample::records(1000);
    for (RunRecord& r : records) {
      for (int vehicle = 2; vehicle < 40; ++vehicle)
        r.measures.push_back({"navigation_time_s", vehicle, 0.1 * vehicle});
    }
    store.put(records);
  }
  EXPECT_LT(std::filesystem::file_size(folder.file("results.db")), 1000U * 41U * 30U);
}

TEST(CsvTest, IsLongWithOneColumnForEachLabel) {
  Store store = Store::in_memory();
  put(store, record("b", {{"case", "cube, \"small\""}, {"method", "apf"}}, 2,
                    {{"makespan_s", Measure::fleet, 0.1}, {"nearest_m", 3, 1e300}}));
  put(store, record("a", {{"case", "pair"}}, 1,
                    {{"min_separation_m", Measure::fleet, std::numeric_limits<double>::infinity()}}));
  RunRecord failed = record("c", {{"case", "pair"}, {"method", "orca3d"}}, 3, {});
  failed.failure = "no thrust";
  put(store, failed);
  EXPECT_EQ(sample::csv_of(store),
            "case,method,seed,vehicle,quantity,value\n"
            "\"cube, \"\"small\"\"\",apf,2,,makespan_s,0.1\n"
            "\"cube, \"\"small\"\"\",apf,2,3,nearest_m,1e+300\n"
            "pair,,1,,min_separation_m,inf\n"
            "pair,orca3d,3,,failure_count,1\n");
}

TEST(CsvTest, OfAnEmptyStoreIsItsHeader) {
  EXPECT_EQ(sample::csv_of(Store::in_memory()), "seed,vehicle,quantity,value\n");
}

TEST(LabelsTest, OrderIsTotalAndNatural) {
  EXPECT_TRUE(natural_order("6", "10") < 0);
  EXPECT_TRUE(natural_order("10", "apf") < 0);
  EXPECT_TRUE(natural_order("-1", "1e-3") < 0);
  EXPECT_TRUE(natural_order("6", "6.0") != 0);
  EXPECT_TRUE(natural_order("nan", "6") > 0);
  EXPECT_TRUE(natural_order("apf", "apf") == 0);
}

}  // namespace
}  // namespace fairway
