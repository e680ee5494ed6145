// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/experiment/origin.hpp"
#include "fairway/experiment/run.hpp"
#include "fairway/record/output_check.hpp"

namespace fairway {

/// A store by the first bytes of its file: SQLite, and in the header whose application it is.
inline constexpr FileKind store_file{
    .name = "a results store of fairway", .begins = "SQLite format 3", .holds = "fway"};

/// write_csv() of a store.
inline constexpr FileKind store_table{
    .name = "a table of results", .begins = "", .holds = "seed,vehicle,quantity,value\n", .is_table = true};

/// The results of runs in one SQLite file. A process that is killed loses at most the put() it was in,
/// and no run is ever stored twice. One process writes at a time; others may read meanwhile.
/// Not for use by several threads at once.
class Store {
 public:
  enum class Foreign { refuse, replace };

  /// For writing: continues the store at `path`, or begins one, which appears under its name with all of its
  /// tables. Holds `path` + ".lock" while it lives. Throws InputError if the file is damaged, of a newer
  /// version, cannot be written, another process writes to it, or if it is something else that is not to be
  /// replaced.
  static Store open(const std::string& path, Foreign foreign = Foreign::refuse);

  /// For reading a store that is there. Throws InputError likewise.
  static Store open_existing(const std::string& path);

  /// For results that nobody keeps.
  static Store in_memory();

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  enum class Status { missing, failed, done };
  Status status(std::string_view key) const;
  bool contains(std::string_view key) const { return status(key) != Status::missing; }

  /// All of them or, if it throws, none. A run that is stored as done stays as it is; one that had failed
  /// is replaced. Throws std::invalid_argument for records that make no sense (an empty key, a label twice,
  /// a quantity measured twice), std::logic_error on a store opened for reading, InputError if the file
  /// cannot be written.
  void put(std::span<const RunRecord> records);

  /// What campaign the runs that follow are of; see note_campaign(). Throws as put() does.
  void note(const Origin& campaign);
  /// Who makes the runs that follow. Throws as put() does.
  void note(const Maker& maker);
  Origin origin() const;

  /// Those of the runs that are stored are of the campaign noted last, too, whoever had them made. Throws as
  /// put() does.
  void claim(std::span<const RunSpec> specs);

  /// Throws InputError if it was begun under another results epoch than this program's.
  void refuse_other_epoch() const;

  std::size_t size() const;
  std::size_t failed_count() const;  ///< of these, with a failure
  /// Of the campaign noted last alone. Runs of which it is not known whose they are count as its own.
  std::size_t campaign_size() const;
  std::size_t campaign_failed_count() const;

  /// Every run, by labels, seed and key, whatever order they were made in; measures in the order they
  /// were given. Numbers come back to the bit, but for NaNs, which all come back as the same one. Throws
  /// InputError where the file is damaged, by what is known of each run that was stored.
  std::vector<RunRecord> all() const;

  /// write_csv() of all().
  void export_csv(std::ostream& out) const;

 private:
  struct Contents;
  explicit Store(std::unique_ptr<Contents> contents);
  std::unique_ptr<Contents> contents_;
};

/// One line per measure: the labels, seed, vehicle (empty for the fleet), quantity, value. Numbers are the
/// shortest that read back as the same. A run that failed is one line, `failure_count` of 1. The same
/// records in the same order give the same bytes; wall times are left out.
void write_csv(std::ostream& out, std::span<const RunRecord> records);

}  // namespace fairway
