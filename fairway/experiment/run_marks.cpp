// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/run_marks.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/labels.hpp"

namespace fairway {
namespace {

void add_measures(Digest& digest, std::span<const Measure> measures) {
  for (const Measure& m : measures) {
    const double value = std::isnan(m.value) ? std::numeric_limits<double>::quiet_NaN() : m.value;
    digest.add(m.quantity).add(std::to_string(m.vehicle));
    digest.add(std::to_string(std::bit_cast<std::uint64_t>(value)));
  }
}

}  // namespace

bool has_marks(Database& database) {
  return database.integer("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = 'marks'") > 0;
}

std::string fault_of(const RunRecord& record) {
  if (record.spec.key.empty()) return "a run without a key";
  std::set<std::string_view> names;
  for (const auto& [name, value] : record.spec.labels) {
    if (!can_be_label(name)) return "'" + name + "' cannot be a label's name";
    if (!names.insert(name).second) return "label " + name + " twice in one run";
  }
  std::set<std::pair<int, std::string_view>> measured;
  for (const Measure& m : record.measures) {
    if (!measured.emplace(m.vehicle, m.quantity).second)
      return m.quantity + " measured twice in one run, vehicle " + std::to_string(m.vehicle);
  }
  return "";
}

std::string digest_of(std::span<const Measure> measures) {
  Digest digest;
  add_measures(digest, measures);
  return digest.hex();
}

std::string digest_of(const RunRecord& record) {
  Digest digest;
  for (const auto& [name, value] : record.spec.labels) digest.add(name).add(value);
  digest.add(std::to_string(record.spec.seed));
  add_measures(digest, record.measures);
  return digest.hex();
}

RunMarks::RunMarks(Database& database)
    : put_{database, "INSERT OR REPLACE INTO marks(key, campaign, version, digest) VALUES (?, ?, ?, ?)"},
      claim_{
          database,
          "INSERT INTO marks(key, campaign, version, digest) SELECT ?1, ?2, ?3, '' FROM runs WHERE key = ?1"
          " ON CONFLICT(key) DO UPDATE SET campaign = excluded.campaign, version = excluded.version"
          " WHERE campaign <> excluded.campaign OR version <> excluded.version"} {}

void RunMarks::put(const RunRecord& record, const std::string& campaign) {
  const std::string digest = record.failure.empty() ? digest_of(record) : "";
  put_.bind(1, record.spec.key).bind(2, record.campaign.empty() ? campaign : record.campaign);
  put_.bind(3, record.spec.version).bind(4, digest).run();
}

void RunMarks::claim(const RunSpec& spec, const std::string& campaign) {
  claim_.bind(1, spec.key).bind(2, campaign).bind(3, spec.version).run();
}

std::size_t count_of_campaign(Database& database, const std::string& campaign, bool failed_alone) {
  const std::string failed = failed_alone ? " AND runs.failure <> ''" : "";
  const bool is_told = !campaign.empty() && has_marks(database);
  Statement count{database, is_told
                                ? "SELECT count(*) FROM runs LEFT JOIN marks ON marks.key = runs.key WHERE"
                                  " (marks.campaign IS NULL OR marks.campaign IN (?, ''))" +
                                      failed
                                : "SELECT count(*) FROM runs WHERE TRUE" + failed};
  if (is_told) count.bind(1, campaign);
  return count.step() ? static_cast<std::size_t>(count.integer(0)) : 0;
}

}  // namespace fairway
