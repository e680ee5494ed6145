// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/store_tables.hpp"

#include <filesystem>
#include <system_error>

#include "fairway/experiment/run_marks.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/record/output_file.hpp"

namespace fairway {
namespace {

// `value` has no declared type: SQLite would store a REAL column's -0.0 as 0
constexpr const char* schema = R"(
  PRAGMA application_id = 1719099769;
  PRAGMA user_version = 1;
  CREATE TABLE meta(name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE label_sets(id INTEGER PRIMARY KEY, labels TEXT NOT NULL UNIQUE);
  CREATE TABLE quantities(id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);
  CREATE TABLE runs(id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE,
                    labels INTEGER NOT NULL REFERENCES label_sets(id), seed INTEGER NOT NULL,
                    failure TEXT NOT NULL, wall_s REAL);
  CREATE TABLE measures(run INTEGER NOT NULL REFERENCES runs(id), place INTEGER NOT NULL,
                        vehicle INTEGER NOT NULL, quantity INTEGER NOT NULL REFERENCES quantities(id),
                        value, PRIMARY KEY(run, place)) WITHOUT ROWID;
  CREATE VIEW results AS
    SELECT runs.key, label_sets.labels, runs.seed, measures.vehicle, quantities.name AS quantity,
           measures.value
    FROM measures JOIN runs ON runs.id = measures.run JOIN label_sets ON label_sets.id = runs.labels
                  JOIN quantities ON quantities.id = measures.quantity;
)";
static_assert(store_application_id == 1719099769 && store_schema_version == 1, "as in the schema");

}  // namespace

void begin_store(Database& database) {
  Transaction transaction{database, Transaction::Kind::write};
  database.execute(schema);
  database.execute(commands_table);
  database.execute(marks_table);
  Statement note{database, "INSERT INTO meta(name, value) VALUES (?, ?)"};
  note.bind(1, "fairway_version").bind(2, fairway_version).run();
  note.bind(1, "results_epoch").bind(2, std::to_string(results_epoch)).run();
  transaction.commit();
}

void make_store(const std::string& path) {
  OutputFile file{path};
  {
    Database database{file.part(), Database::Access::existing, store_patience_ms};
    database.execute("PRAGMA journal_mode = MEMORY");  // nobody rolls a temporary file back
    begin_store(database);
  }
  // a journal that the file before left behind would be rolled back into the new one
  std::error_code ignored;
  const std::string followed = std::filesystem::weakly_canonical(path, ignored).string();
  for (const char* beside : {"-journal", "-wal", "-shm"}) std::filesystem::remove(followed + beside, ignored);
  file.commit();
}

}  // namespace fairway
