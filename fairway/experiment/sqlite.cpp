// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/sqlite.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <limits>

#include "fairway/core/error.hpp"

namespace fairway {
namespace {

/// What an error code asks of the user; `detail` is SQLite's own wording.
std::string advice(int code, const std::string& detail) {
  switch (code & 0xFF) {
    case SQLITE_NOTADB:
      return "is not a results store: not a SQLite file";
    case SQLITE_CORRUPT:
      return "is a damaged store (" + detail + "); restore a copy, or delete it and run again";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "is in use by another process (" + detail + "); try again when it has ended";
    case SQLITE_CANTOPEN:
      return "cannot be opened; is its folder there, and may you write in it?";
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return "cannot be written: " + detail;
    case SQLITE_FULL:
      return "cannot be written: the disk is full; make room and run again, what was stored is kept";
    case SQLITE_IOERR:
      return "cannot be read or written (" + detail + "): is the disk sound, and may a file be so large?";
    default:
      return detail;
  }
}

/// SQLite quotes what a damaged file holds, line ends and all.
std::string on_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

}  // namespace

Database::Database(const std::string& path, Access access, int patience_ms)
    : name_{path.empty() ? "results in memory" : path} {
  // a leading ":" would be a special name to SQLite
  const std::string file = path.empty() ? ":memory:" : path.starts_with(':') ? "./" + path : path;
  const int create = access == Access::create ? SQLITE_OPEN_CREATE : 0;
  if (sqlite3_open_v2(file.c_str(), &handle_, SQLITE_OPEN_READWRITE | create, nullptr) != SQLITE_OK) {
    const std::string message = name_ + ": " + advice(sqlite3_errcode(handle_), sqlite3_errmsg(handle_));
    sqlite3_close_v2(handle_);
    throw InputError(message);
  }
  sqlite3_extended_result_codes(handle_, 1);
  sqlite3_busy_timeout(handle_, patience_ms);
  // a damaged or foreign file must not make SQL functions run
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
}

Database::~Database() { sqlite3_close_v2(handle_); }

void Database::execute(const char* sql) {
  if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

std::int64_t Database::integer(const char* sql) {
  Statement statement{*this, sql};
  return statement.step() ? statement.integer(0) : 0;
}

void Database::fail() const {
  refuse(advice(sqlite3_errcode(handle_), on_one_line(sqlite3_errmsg(handle_))));
}

void Database::refuse(const std::string& message) const { throw InputError(name_ + ": " + message); }

Statement::Statement(Database& database, std::string_view sql) : database_{database} {
  const int size = static_cast<int>(sql.size());
  if (sqlite3_prepare_v2(database.handle_, sql.data(), size, &handle_, nullptr) != SQLITE_OK) database.fail();
}

Statement::~Statement() { sqlite3_finalize(handle_); }

Statement& Statement::bind(int place, std::string_view text) {
  // a null pointer would bind NULL
  const char* data = text.empty() ? "" : text.data();
  if (sqlite3_bind_text64(handle_, place, data, text.size(), SQLITE_STATIC, SQLITE_UTF8) != SQLITE_OK) {
    database_.fail();
  }
  return *this;
}

Statement& Statement::bind(int place, std::int64_t value) {
  if (sqlite3_bind_int64(handle_, place, value) != SQLITE_OK) database_.fail();
  return *this;
}

Statement& Statement::bind(int place, double value) {
  if (sqlite3_bind_double(handle_, place, value) != SQLITE_OK) database_.fail();
  return *this;
}

bool Statement::step() {
  switch (sqlite3_step(handle_)) {
    case SQLITE_ROW:
      return true;
    case SQLITE_DONE:
      reset();
      return false;
    default: {
      const std::string message =
          advice(sqlite3_extended_errcode(database_.handle_), sqlite3_errmsg(database_.handle_));
      reset();
      database_.refuse(message);
    }
  }
}

void Statement::run() {
  while (step()) {
  }
}

void Statement::reset() { sqlite3_reset(handle_); }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_, column); }

double Statement::real(int column) const {
  if (sqlite3_column_type(handle_, column) == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(handle_, column);
}

std::string Statement::text(int column) const {
  const auto* data = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_, column));
  return data == nullptr ? std::string{} : std::string{data, size};
}

Transaction::Transaction(Database& database, Kind kind) : database_{database} {
  database_.execute(kind == Kind::write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const InputError&) {  // SQLite has already rolled back
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace fairway
