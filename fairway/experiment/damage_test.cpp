// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"

namespace fairway {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// What either way of opening says; both must refuse.
std::string refusal_of(const std::string& file) {
  const std::string writing = refusal_by([&] { Store::open(file); });
  const std::string reading = refusal_by([&] { Store::open_existing(file); });
  EXPECT_THAT(writing, AllOf(HasSubstr(file), Not(HasSubstr("\n"))));
  EXPECT_THAT(reading, AllOf(HasSubstr(file), Not(HasSubstr("\n"))));
  return writing == reading ? writing : writing + " | " + reading;
}

void execute(const std::string& file, const char* sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
}

class DamagedStoreTest : public testing::Test {
 protected:
  DamagedStoreTest() {
    Store store = Store::open(file_);
    store.put(sample::records(400));
  }
  TemporaryFolder folder_;
  std::string file_ = folder_.file("results.db");
};

TEST_F(DamagedStoreTest, AnotherKindOfFileIsRefusedAndLeftAlone) {
  const std::string text = "case,method,seed\n" + std::string(4000, 'x');
  sample::write_bytes(file_, text);
  EXPECT_THAT(refusal_of(file_), HasSubstr("is not a results store: not a SQLite file"));
  EXPECT_EQ(sample::bytes_of(file_), text);
}

TEST_F(DamagedStoreTest, AnotherProgramsDatabaseIsRefusedAndLeftAlone) {
  const std::string file = folder_.file("foreign.db");
  execute(file, "CREATE TABLE runs(key, value); INSERT INTO runs VALUES (1, 2)");
  const std::string before = sample::bytes_of(file);
  EXPECT_THAT(refusal_of(file), HasSubstr("is a SQLite database, but not a results store of fairway"));
  EXPECT_EQ(sample::bytes_of(file), before);
}

TEST_F(DamagedStoreTest, AStoreOfANewerVersionIsRefused) {
  execute(file_, "PRAGMA user_version = 7");
  EXPECT_THAT(refusal_of(file_), AllOf(HasSubstr("version 7"), HasSubstr("use a newer fairway")));
}

TEST_F(DamagedStoreTest, ATruncatedStoreIsRefusedWhereverItWasCut) {
  const std::string whole = sample::bytes_of(file_);
  for (const double share : {0.001, 0.01, 0.1, 0.5, 0.9, 0.999}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    sample::write_bytes(file_, std::string_view(whole).substr(0, size));
    EXPECT_THAT(refusal_of(file_), testing::AnyOf(HasSubstr("damaged store"), HasSubstr("not a SQLite file")))
        << size;
  }
}

TEST_F(DamagedStoreTest, OverwrittenBytesAreRefusedOrReadButNeverAnAccident) {
  const std::string whole = sample::bytes_of(file_);
  Rng rng{3};
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    std::string bytes = whole;
    const auto from = static_cast<std::size_t>(rng.index(bytes.size()));
    const auto count = std::min(bytes.size() - from, static_cast<std::size_t>(1 + rng.index(64)));
    for (std::size_t i = 0; i < count; ++i) bytes[from + i] = static_cast<char>(rng.index(256));
    sample::write_bytes(file_, bytes);
    const std::string message = refusal_by([&] {
      Store store = Store::open(file_);
      sample::csv_of(store);
      if (round % 5 == 0) store.put(sample::records(420));
    });
    EXPECT_THAT(message, Not(HasSubstr("\n")));
    refused += message == "accepted" ? 0 : 1;
  }
  // most of a store is numbers and text in which no structure is hurt
  EXPECT_GT(refused, 30);
}

TEST_F(DamagedStoreTest, WhatARunCannotHaveIsRefusedByTheFilesName) {
  const std::string whole = sample::bytes_of(file_);
  const auto read_after = [&](const char* sql) {
    sample::write_bytes(file_, whole);
    execute(file_, sql);
    const std::string message = refusal_by([&] { Store::open_existing(file_).all(); });
    EXPECT_THAT(message, AllOf(HasSubstr(file_ + ": is a damaged store ("), Not(HasSubstr("\n")))) << sql;
    return message;
  };
  EXPECT_THAT(read_after("UPDATE measures SET value = value + 1 WHERE run = 3 AND place = 0"),
              HasSubstr("other values than were stored of the run case=cube20_8 method="));
  EXPECT_THAT(read_after("UPDATE runs SET seed = 1000 WHERE id = 3"), HasSubstr(" seed=1000"));
  EXPECT_THAT(read_after("DELETE FROM measures WHERE run = 3 AND place = 2"), HasSubstr("other values"));
  EXPECT_THAT(read_after("UPDATE measures SET quantity = 999 WHERE run = 3 AND place = 0"),
              HasSubstr("a measure of a quantity that is not there"));
  EXPECT_THAT(read_after("UPDATE runs SET labels = 999 WHERE id = 3"),
              HasSubstr("a run whose labels are not there"));
  EXPECT_THAT(read_after("UPDATE measures SET vehicle = 1 WHERE run = 3 AND place = 1"),
              HasSubstr("measured twice in one run"));
  EXPECT_THAT(read_after("UPDATE label_sets SET labels = '{\"seed\":\"1\"}' WHERE id = 1"),
              HasSubstr("cannot be a label's name"));
  EXPECT_THAT(read_after("UPDATE runs SET key = '' WHERE id = 3"), HasSubstr("a run without a key"));
}

TEST_F(DamagedStoreTest, OfAStoreWithoutMarksTheValuesAreTakenAsTheyAre) {
  execute(file_, "DROP TABLE marks; UPDATE measures SET value = 1");
  EXPECT_EQ(Store::open_existing(file_).all().size(), 400U);
  { Store::open(file_).put(sample::records(401)); }
  EXPECT_EQ(Store::open_existing(file_).all().size(), 401U);
}

TEST_F(DamagedStoreTest, AnEmptyFileIsNoStoreYet) {
  sample::write_bytes(file_, "");
  EXPECT_THAT(refusal_by([&] { Store::open_existing(file_); }), HasSubstr("the file is empty"));
  Store store = Store::open(file_);
  EXPECT_EQ(store.size(), 0U);
}

TEST_F(DamagedStoreTest, PathsThatCannotBeAStoreAreRefused) {
  EXPECT_THAT(refusal_by([&] { Store::open_existing(folder_.file("none.db")); }),
              HasSubstr("no such results store"));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("none.db")));
  EXPECT_THAT(refusal_by([&] { Store::open(folder_.file("none/results.db")); }),
              HasSubstr("cannot be written: No such file"));
  EXPECT_THAT(refusal_by([&] { Store::open(file_ + "/results.db"); }),
              HasSubstr("cannot be written: Not a directory"));
  EXPECT_THAT(refusal_by([&] { Store::open("/proc/fairway.db"); }),
              HasSubstr("/proc/fairway.db: cannot be written"));
  EXPECT_THAT(refusal_of(folder_.file(".")), HasSubstr("is a folder"));
  EXPECT_THAT(refusal_by([&] { Store::open(""); }), HasSubstr("needs a file name"));
}

}  // namespace
}  // namespace fairway
