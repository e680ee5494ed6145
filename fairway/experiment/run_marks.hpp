// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "fairway/experiment/run.hpp"
#include "fairway/experiment/sqlite.hpp"

/// What a store keeps of each run beside its results: whose it is, and what they have to be.
namespace fairway {

/// By key: the digest of the campaign that asked for the run last, the version of its cell
/// (RunSpec::version), and digest_of() what it came to, empty of a run that failed. It came later than the
/// rest: a store without it is read like one whose marks are all unknown, and an older fairway does not look
/// at it.
inline constexpr const char* marks_table =
    "CREATE TABLE IF NOT EXISTS marks(key TEXT PRIMARY KEY, campaign TEXT NOT NULL, version TEXT NOT NULL,"
    " digest TEXT NOT NULL) WITHOUT ROWID";

bool has_marks(Database& database);

/// Why this is no run that a store may have, or empty: no key, a label twice, a quantity measured twice.
std::string fault_of(const RunRecord& record);

/// Of measures alone; every NaN is the same one.
std::string digest_of(std::span<const Measure> measures);

/// Of labels, seed and measures.
std::string digest_of(const RunRecord& record);

/// Writes marks.
class RunMarks {
 public:
  explicit RunMarks(Database& database);

  /// Of a run that is stored; `campaign` where the record itself does not say whose it is.
  void put(const RunRecord& record, const std::string& campaign);

  /// The run, if it is stored, is asked for by that campaign.
  void claim(const RunSpec& spec, const std::string& campaign);

 private:
  Statement put_;
  Statement claim_;
};

/// How many runs are of that campaign, or failed ones alone; those without a mark are taken for its own.
std::size_t count_of_campaign(Database& database, const std::string& campaign, bool failed_alone);

}  // namespace fairway
