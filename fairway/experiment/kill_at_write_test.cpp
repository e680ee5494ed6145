// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "fairway/experiment/executor.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"

namespace fairway {
namespace {

constexpr std::size_t few_runs = 12;
constexpr std::size_t batch = 4;
constexpr int died = 9;

/// In a process that is to die: at which of the system calls of SQLite that change files, and how.
struct Death {
  int calls_left{};
  bool half{};  ///< in the middle of a write
};
Death death;

/// True for the call at which it is to die.
bool is_last() { return --death.calls_left == 0; }

using Open = int (*)(const char*, int, int);
using Close = int (*)(int);
using Write = ssize_t (*)(int, const void*, std::size_t, std::int64_t);
using Truncate = int (*)(int, off_t);
using Unlink = int (*)(const char*);
Open real_open;
Close real_close;
Write real_write;
Truncate real_truncate;
Unlink real_unlink;

int dying_open(const char* path, int flags, int mode) {
  if (is_last()) ::_exit(died);
  return real_open(path, flags, mode);
}
int dying_close(int file) {
  if (is_last()) ::_exit(died);
  return real_close(file);
}
ssize_t dying_write(int file, const void* bytes, std::size_t size, std::int64_t at) {
  if (is_last()) {
    if (death.half) real_write(file, bytes, size / 2, at);
    ::_exit(died);
  }
  return real_write(file, bytes, size, at);
}
int dying_truncate(int file, off_t size) {
  if (is_last()) ::_exit(died);
  return real_truncate(file, size);
}
int dying_unlink(const char* path) {
  if (is_last()) ::_exit(died);
  return real_unlink(path);
}

/// Puts `ours` before the system call `name` of SQLite, and says whether it has one of that name.
template <class Call>
bool intercept(const char* name, Call& real, Call ours) {
  sqlite3_vfs* vfs = sqlite3_vfs_find(nullptr);
  const sqlite3_syscall_ptr found = vfs->xGetSystemCall(vfs, name);
  if (found == nullptr) return false;
  real = reinterpret_cast<Call>(found);
  return vfs->xSetSystemCall(vfs, name, reinterpret_cast<sqlite3_syscall_ptr>(ours)) == SQLITE_OK;
}

bool intercept_all() {
  const bool writes =
      intercept("pwrite64", real_write, dying_write) || intercept("pwrite", real_write, dying_write);
  return writes && intercept("open", real_open, dying_open) && intercept("close", real_close, dying_close) &&
         intercept("ftruncate", real_truncate, dying_truncate) &&
         intercept("unlink", real_unlink, dying_unlink);
}

/// Stores the runs of specs() in batches.
void store_all(const std::string& file) {
  Store store = Store::open(file);
  const auto records = sample::records(few_runs);
  for (std::size_t i = 0; i < few_runs; i += batch) store.put(std::span(records).subspan(i, batch));
}

/// Makes those that are missing.
void resume(const std::string& file) {
  Store store = Store::open(file);
  run_missing(sample::specs(few_runs), sample::measures, store);
}

/// The exit code of a process that does store_all() and dies at the `n`-th call.
int store_and_die(const std::string& file, int n, bool half) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    death = {n, half};
    if (!intercept_all()) ::_exit(2);
    try {
      store_all(file);
      ::_exit(0);
    } catch (...) {
      ::_exit(1);
    }
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string whole_store() {
  Store store = Store::in_memory();
  run_missing(sample::specs(few_runs), sample::measures, store);
  return sample::csv_of(store);
}

/// Dies at the first call, then at the second, and so on until one lives to its end.
void die_at_every_call(bool half) {
  const std::string expected = whole_store();
  int absent = 0;
  int parts = 0;
  for (int n = 1;; ++n) {
    ASSERT_LT(n, 2000) << "it never comes to its end";
    const TemporaryFolder folder;
    const std::string file = folder.file("results.db");
    const int code = store_and_die(file, n, half);
    ASSERT_TRUE(code == died || code == 0) << "call " << n << ": exit code " << code;
    if (std::filesystem::exists(file)) {
      const std::size_t kept = Store::open_existing(file).size();
      EXPECT_EQ(kept % batch, 0U) << "call " << n << ": part of a batch";
      parts += kept > 0 && kept < few_runs ? 1 : 0;
    } else {
      ++absent;
    }
    resume(file);
    ASSERT_EQ(sample::csv_of(Store::open_existing(file)), expected) << "call " << n;
    if (code == 0) break;
  }
  EXPECT_GT(absent, 3) << "no store was caught in the making";
  EXPECT_GT(parts, 3) << "no batch was caught in the writing";
}

TEST(KillAtWriteTest, AStoreIsWholeOrNotThereWhicheverCallIsTheLast) { die_at_every_call(false); }

TEST(KillAtWriteTest, AStoreIsWholeOrNotThereWhereverAWriteIsCut) { die_at_every_call(true); }

TEST(KillAtWriteTest, TheJournalOfADeletedStoreDoesNotGetIntoTheNextOfItsName) {
  const std::string expected = whole_store();
  // its pages are others than those of the next
  const TemporaryFolder other;
  const auto records = sample::records(400);
  Store::open(other.file("large.db")).put(std::span(records).subspan(few_runs));
  const std::string large = sample::bytes_of(other.file("large.db"));
  int journals = 0;
  for (int n = 1, code = died; code == died; ++n) {
    const TemporaryFolder folder;
    const std::string file = folder.file("results.db");
    sample::write_bytes(file, large);
    code = store_and_die(file, n, false);
    if (sample::bytes_of(file + "-journal").empty()) continue;
    ++journals;
    std::filesystem::remove(file);
    resume(file);
    ASSERT_EQ(sample::csv_of(Store::open_existing(file)), expected) << "call " << n;
  }
  EXPECT_GT(journals, 10);
}

}  // namespace
}  // namespace fairway
