// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "fairway/experiment/agreement.hpp"
#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/origin.hpp"
#include "fairway/experiment/run.hpp"

namespace fairway {

/// The runs of one store or several, and where they come from.
struct StoredResults {
  Origin origin;  ///< of several: their names joined, the values of their labels in the order of the stores,
                  ///< all of their makers, and a digest where it is the same
  std::vector<RunRecord> records;
};

/// Puts results together, one after the other. A run that several of them hold, by its key, is taken once,
/// and rather where it went well.
class GatheredResults {
 public:
  /// `purpose` is one of those of comparing.
  explicit GatheredResults(Together purpose) : agreement_{purpose} {}

  /// `name` is what an error calls them. Throws InputError where they disagree with those before, by
  /// Agreement.
  void add(const std::string& name, const Origin& origin, std::vector<RunRecord> records);

  /// A store, likewise. One that no campaign noted goes by the name of its file.
  void add_store(const std::string& file);

  StoredResults take() { return std::move(results_); }

 private:
  Agreement agreement_;
  StoredResults results_;
  bool is_begun_{};
  std::unordered_map<std::string, std::size_t> places_;  ///< in the records, by key
  std::set<std::string> names_, summaries_, versions_, epochs_;
};

/// GatheredResults of stores, in whatever order. Throws InputError as Store::open_existing() does, too.
StoredResults read_stores(std::span<const std::string> files, Together purpose = Together::compared_mixed);

/// What another campaign asks, of which the records are to follow: its labels' values behind those there, and
/// its quantities besides those there, where none of them asks about all.
void add_questions(StoredResults& results, const Origin& more);

/// The options, with what the campaigns of these results say where the options say nothing: the order of the
/// values compared, and the quantities asked about, each once, of which `all` are those of every run.
CompareOptions options_for(const Origin& origin, CompareOptions options);

}  // namespace fairway
