// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/store.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/lock_file.hpp"
#include "fairway/experiment/run_marks.hpp"
#include "fairway/experiment/sqlite.hpp"
#include "fairway/experiment/store_tables.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/scenario/tree.hpp"

namespace fairway {
namespace {

/// `{"case":"cube20_8","method":"orca3d"}`, in order.
std::string labels_as_json(const Labels& labels) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const auto& [name, value] : labels) object[name] = value;
  return object.dump();
}

[[noreturn]] void refuse_damage(const Database& database, const std::string& what) {
  database.refuse("is a damaged store (" + what + "); restore a copy, or delete it and run again");
}

Labels labels_of(const std::string& json, const Database& database) {
  Labels labels;
  try {
    const auto object = nlohmann::ordered_json::parse(json);
    for (const auto& [name, value] : object.items()) labels.emplace_back(name, value.get<std::string>());
  } catch (const nlohmann::json::exception&) {
    refuse_damage(database, "labels that are none");
  }
  return labels;
}

void refuse_what_is_no_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path + ": is a folder, not a results store");
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    throw InputError(path + ": is no plain file, and so cannot hold a results store");
}

/// Nothing that is kept is there: no file, or an empty one.
bool is_nothing(const std::string& path) {
  std::error_code missing;
  const auto size = std::filesystem::file_size(path, missing);
  return missing || size == 0;
}

/// A row's id by its unique text, made when it is new. Remembers those it has seen.
class Interned {
 public:
  Interned(Database& database, const std::string& table, const std::string& column)
      : insert_{database, "INSERT OR IGNORE INTO " + table + "(" + column + ") VALUES (?)"},
        select_{database, "SELECT id FROM " + table + " WHERE " + column + " = ?"} {}

  std::int64_t id(const std::string& text) {
    if (const auto known = ids_.find(text); known != ids_.end()) return known->second;
    insert_.bind(1, text).run();
    select_.bind(1, text).step();
    const std::int64_t id = select_.integer(0);
    select_.reset();
    return ids_[text] = id;
  }

  /// After a rollback, which takes ids back.
  void forget() { ids_.clear(); }

 private:
  Statement insert_;
  Statement select_;
  std::map<std::string, std::int64_t> ids_;
};

/// The commands of cells, each written when it is first met.
class KeptCommands {
 public:
  explicit KeptCommands(Database& database)
      : put_{database, "INSERT OR REPLACE INTO commands(labels, command) VALUES (?, ?)"} {}

  void put(std::int64_t labels, const std::string& command) {
    if (command.empty() || known_[labels] == command) return;
    put_.bind(1, labels).bind(2, command).run();
    known_[labels] = command;
  }

  /// After a rollback.
  void forget() { known_.clear(); }

 private:
  Statement put_;
  std::map<std::int64_t, std::string> known_;
};

/// What of a run cannot be as it was stored, or empty; `digest` is that of what was, if it is known.
std::string damage_of(const RunRecord& record, const std::string& digest) {
  if (const std::string fault = fault_of(record); !fault.empty()) return yaml::shown(fault);
  if (digest.empty() || (record.failure.empty() && digest == digest_of(record))) return "";
  return (record.failure.empty() ? "other values than were stored" : "a failure that was not stored") +
         (" of the run " + yaml::shown(labels_text(record.spec.labels))) +
         " seed=" + std::to_string(record.spec.seed);
}

/// The commands of cells by the ids of their labels; none in a store that has no such table.
std::map<std::int64_t, std::string> commands_of(Database& database) {
  if (database.integer("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = 'commands'") == 0)
    return {};
  std::map<std::int64_t, std::string> commands;
  Statement select{database, "SELECT labels, command FROM commands"};
  while (select.step()) commands[select.integer(0)] = select.text(1);
  return commands;
}

}  // namespace

struct Store::Contents {
  std::unique_ptr<LockFile> lock;  // first, so that it is let go of last
  Database database;
  bool writable;

  // prepared once the tables are known to be there
  struct Prepared {
    explicit Prepared(Database& d)
        : status{d, "SELECT failure <> '' FROM runs WHERE key = ?"},
          forget_measures{d, "DELETE FROM measures WHERE run = (SELECT id FROM runs WHERE key = ?)"},
          forget_run{d, "DELETE FROM runs WHERE key = ?"},
          put_run{d,
                  "INSERT INTO runs(key, labels, seed, failure, wall_s) VALUES (?, ?, ?, ?, ?) RETURNING id"},
          put_measure{d, "INSERT INTO measures(run, place, vehicle, quantity, value) VALUES (?, ?, ?, ?, ?)"},
          label_sets{d, "label_sets", "labels"},
          quantities{d, "quantities", "name"} {}
    Statement status, forget_measures, forget_run, put_run, put_measure;
    Interned label_sets, quantities;
  };
  std::optional<Prepared> sql;
  std::optional<KeptCommands> commands;  ///< of a store that may be written
  std::optional<RunMarks> marks;         ///< likewise
  std::string campaign;                  ///< digest of that noted last

  Contents(const std::string& path, Database::Access access, std::unique_ptr<LockFile> taken,
           bool for_writing)
      : lock{std::move(taken)}, database{path, access, store_patience_ms}, writable{for_writing} {}

  void check_origin();
  void prepare();
  void put(const RunRecord& record);
};

/// Refuses what is no store of ours before a byte of it is changed.
void Store::Contents::check_origin() {
  if (database.integer("PRAGMA page_count") == 0) {
    database.refuse("is not a results store: the file is empty");
  } else if (database.integer("PRAGMA application_id") != store_application_id) {
    database.refuse("is a SQLite database, but not a results store of fairway");
  } else if (const auto version = database.integer("PRAGMA user_version"); version != store_schema_version) {
    database.refuse("is a results store of version " + std::to_string(version) +
                    ", and this fairway reads version " + std::to_string(store_schema_version) +
                    (version > store_schema_version ? "; use a newer fairway" : ""));
  } else {
    Statement sound{database, "PRAGMA quick_check(1)"};
    const std::string finding = sound.step() ? sound.text(0) : "";
    if (finding != "ok") {
      refuse_damage(database, finding.substr(0, finding.find('\n')));
    }
  }
}

void Store::Contents::prepare() {
  sql.emplace(database);
  if (!writable) return;
  database.execute(commands_table);
  database.execute(marks_table);
  commands.emplace(database);
  marks.emplace(database);
}

void Store::Contents::put(const RunRecord& record) {
  const RunSpec& spec = record.spec;
  if (sql->status.bind(1, spec.key).step()) {
    const bool failed = sql->status.integer(0) != 0;
    sql->status.reset();
    if (!failed) return;
    sql->forget_measures.bind(1, spec.key).run();
    sql->forget_run.bind(1, spec.key).run();
  }
  std::string labels;
  try {
    labels = labels_as_json(spec.labels);
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("labels that are not UTF-8");
  }
  const std::int64_t label_set = sql->label_sets.id(labels);
  commands->put(label_set, spec.command);
  sql->put_run.bind(1, spec.key).bind(2, label_set).bind(3, static_cast<std::int64_t>(spec.seed));
  sql->put_run.bind(4, record.failure).bind(5, record.wall_s).step();
  const std::int64_t run = sql->put_run.integer(0);
  sql->put_run.run();
  std::int64_t place = 0;
  marks->put(record, campaign);
  for (const Measure& m : record.measures) {
    sql->put_measure.bind(1, run).bind(2, place++).bind(3, std::int64_t{m.vehicle});
    sql->put_measure.bind(4, sql->quantities.id(m.quantity)).bind(5, m.value).run();
  }
}

Store::Store(std::unique_ptr<Contents> contents) : contents_{std::move(contents)} {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::open(const std::string& path, Foreign foreign) {
  if (path.empty()) throw InputError("a results store needs a file name");
  refuse_what_is_no_file(path);
  auto lock = std::make_unique<LockFile>(path);
  if (is_nothing(path) || (foreign == Foreign::replace && !is_of_kind(path, store_file))) make_store(path);
  auto contents = std::make_unique<Contents>(path, Database::Access::existing, std::move(lock), true);
  contents->check_origin();
  contents->prepare();
  return Store{std::move(contents)};
}

Store Store::open_existing(const std::string& path) {
  refuse_what_is_no_file(path);
  if (!std::filesystem::exists(path)) throw InputError(path + ": no such results store");
  auto contents = std::make_unique<Contents>(path, Database::Access::existing, nullptr, false);
  contents->check_origin();
  contents->prepare();
  return Store{std::move(contents)};
}

Store Store::in_memory() {
  auto contents = std::make_unique<Contents>("", Database::Access::create, nullptr, true);
  begin_store(contents->database);
  contents->prepare();
  return Store{std::move(contents)};
}

Store::Status Store::status(std::string_view key) const {
  Statement& statement = contents_->sql->status;
  if (!statement.bind(1, key).step()) return Status::missing;
  const bool failed = statement.integer(0) != 0;
  statement.reset();
  return failed ? Status::failed : Status::done;
}

void Store::put(std::span<const RunRecord> records) {
  if (!contents_->writable) throw std::logic_error("put() into a store opened for reading");
  for (const RunRecord& record : records) {
    if (const std::string fault = fault_of(record); !fault.empty()) throw std::invalid_argument(fault);
  }
  Transaction transaction{contents_->database, Transaction::Kind::write};
  try {
    for (const RunRecord& record : records) contents_->put(record);
    transaction.commit();
  } catch (...) {
    contents_->sql->label_sets.forget();
    contents_->sql->quantities.forget();
    contents_->commands->forget();
    throw;
  }
}

void Store::note(const Origin& campaign) {
  if (!contents_->writable) throw std::logic_error("note() into a store opened for reading");
  note_campaign(contents_->database, campaign);
  contents_->campaign = campaign.digest;
}

void Store::note(const Maker& maker) {
  if (!contents_->writable) throw std::logic_error("note() into a store opened for reading");
  note_maker(contents_->database, maker);
}

void Store::claim(std::span<const RunSpec> specs) {
  if (!contents_->writable) throw std::logic_error("claim() in a store opened for reading");
  if (size() == 0) return;
  Transaction transaction{contents_->database, Transaction::Kind::write};
  for (const RunSpec& spec : specs) contents_->marks->claim(spec, contents_->campaign);
  transaction.commit();
}

void Store::refuse_other_epoch() const {
  const std::string epoch = origin().epoch, own = std::to_string(results_epoch);
  if (epoch.empty() || epoch == own) return;
  contents_->database.refuse("was begun under results epoch " + epoch + ", and this fairway is of " + own +
                             ": runs of both do not belong together; write to another file");
}

Origin Store::origin() const { return read_origin(contents_->database); }

std::size_t Store::size() const {
  return static_cast<std::size_t>(contents_->database.integer("SELECT count(*) FROM runs"));
}

std::size_t Store::failed_count() const {
  return static_cast<std::size_t>(
      contents_->database.integer("SELECT count(*) FROM runs WHERE failure <> ''"));
}

std::size_t Store::campaign_size() const {
  return count_of_campaign(contents_->database, origin().digest, false);
}

std::size_t Store::campaign_failed_count() const {
  return count_of_campaign(contents_->database, origin().digest, true);
}

std::vector<RunRecord> Store::all() const {
  Database& database = contents_->database;
  Transaction snapshot{database, Transaction::Kind::read};

  std::map<std::int64_t, Labels> label_sets;
  Statement select_labels{database, "SELECT id, labels FROM label_sets"};
  while (select_labels.step()) {
    label_sets[select_labels.integer(0)] = labels_of(select_labels.text(1), database);
  }
  std::map<std::int64_t, std::string> quantities;
  Statement select_quantities{database, "SELECT id, name FROM quantities"};
  while (select_quantities.step()) quantities[select_quantities.integer(0)] = select_quantities.text(1);

  const std::map<std::int64_t, std::string> commands = commands_of(database);

  // both tables by run, side by side
  std::vector<RunRecord> records;
  records.reserve(size());
  Statement runs{database,
                 has_marks(database)
                     ? "SELECT id, runs.key, labels, seed, failure, wall_s, campaign, version, digest"
                       " FROM runs LEFT JOIN marks ON marks.key = runs.key ORDER BY id"
                     : "SELECT id, key, labels, seed, failure, wall_s, '', '', '' FROM runs ORDER BY id"};
  Statement measures{database, "SELECT run, quantity, vehicle, value FROM measures ORDER BY run, place"};
  bool more = measures.step();
  while (runs.step()) {
    const std::int64_t id = runs.integer(0);
    const auto seed = static_cast<std::uint64_t>(runs.integer(3));
    const auto command = commands.find(runs.integer(2));
    const auto labels = label_sets.find(runs.integer(2));
    if (labels == label_sets.end()) refuse_damage(database, "a run whose labels are not there");
    RunRecord& record =
        records.emplace_back(RunRecord{.spec = {.key = runs.text(1),
                                                .labels = labels->second,
                                                .seed = seed,
                                                .command = command == commands.end() ? "" : command->second,
                                                .version = runs.text(7)},
                                       .measures = {},
                                       .wall_s = runs.real(5),
                                       .failure = runs.text(4),
                                       .campaign = runs.text(6)});
    while (more && measures.integer(0) == id) {
      const auto quantity = quantities.find(measures.integer(1));
      if (quantity == quantities.end()) refuse_damage(database, "a measure of a quantity that is not there");
      record.measures.push_back({.quantity = quantity->second,
                                 .vehicle = static_cast<int>(measures.integer(2)),
                                 .value = measures.real(3)});
      more = measures.step();
    }
    if (const std::string fault = damage_of(record, runs.text(8)); !fault.empty())
      refuse_damage(database, fault);
  }
  if (more) refuse_damage(database, "measures of no run");
  snapshot.commit();

  std::sort(records.begin(), records.end(), [](const RunRecord& a, const RunRecord& b) {
    if (const auto labels = label_order(a.spec.labels, b.spec.labels); labels != 0) return labels < 0;
    return std::tie(a.spec.seed, a.spec.key) < std::tie(b.spec.seed, b.spec.key);
  });
  return records;
}

void Store::export_csv(std::ostream& out) const { write_csv(out, all()); }

}  // namespace fairway
