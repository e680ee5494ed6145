// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace fairway {

/// A SQLite connection. Every failure is an InputError of one line that begins with the file's name and
/// says what to do about it.
class Database {
 public:
  enum class Access { create, existing };

  /// An empty `path` is a database in memory. Waits up to `patience_ms` for other connections' locks.
  Database(const std::string& path, Access access, int patience_ms);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Statements without results, separated by semicolons.
  void execute(const char* sql);

  /// The first column of the first row, or 0.
  std::int64_t integer(const char* sql);

  /// Throws the present error.
  [[noreturn]] void fail() const;

  /// Throws `path: message`.
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  friend class Statement;
  std::string name_;
  sqlite3* handle_{};
};

/// One prepared statement; parameters and columns count as in SQLite, from 1 and from 0.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Text must live until the next step() that returns false, or reset().
  Statement& bind(int place, std::string_view text);
  Statement& bind(int place, std::int64_t value);
  Statement& bind(int place, double value);  ///< a NaN becomes NULL

  /// Goes on to the next row. False at the end, after which the statement is ready for use again.
  bool step();

  /// Steps to the end of a statement without results.
  void run();
  void reset();

  std::int64_t integer(int column) const;
  double real(int column) const;  ///< NULL reads as NaN
  std::string text(int column) const;

 private:
  Database& database_;
  sqlite3_stmt* handle_{};
};

/// begin … commit; rolled back unless commit() was reached.
class Transaction {
 public:
  enum class Kind { read, write };
  Transaction(Database& database, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_{true};
};

}  // namespace fairway
