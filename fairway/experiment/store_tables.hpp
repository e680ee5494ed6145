// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "fairway/experiment/sqlite.hpp"

namespace fairway {

/// In the header of the file, "fway".
inline constexpr std::int64_t store_application_id = 0x66776179;
inline constexpr std::int64_t store_schema_version = 1;

/// A reader holds its lock for as long as all() takes, a writer for one commit.
inline constexpr int store_patience_ms = 30'000;

/// By labels, since runs that differ in their seeds differ in nothing else of their commands. It came later
/// than the rest: a store without it has no commands, and an older fairway does not look at it.
inline constexpr const char* commands_table =
    "CREATE TABLE IF NOT EXISTS commands(labels INTEGER PRIMARY KEY REFERENCES label_sets(id),"
    " command TEXT NOT NULL)";

/// Makes all that a store has before its first run.
void begin_store(Database& database);

/// Puts an empty store in the place of whatever is at `path`, by one rename. Whoever calls it holds the lock.
void make_store(const std::string& path);

}  // namespace fairway
