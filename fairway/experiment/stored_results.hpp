// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/origin.hpp"
#include "fairway/experiment/run.hpp"

namespace fairway {

/// The runs of one store or several, and where they come from.
struct StoredResults {
  Origin
      origin;  ///< of several: their names joined, and the values of their labels in the order of the stores
  std::vector<RunRecord> records;
};

/// Reads stores one after the other; a run that several of them hold, by its key, is taken once. A store that
/// no campaign noted goes by the name of its file. Throws InputError as Store::open_existing() does.
StoredResults read_stores(std::span<const std::string> files);

/// What another campaign asks, of which the records are to follow: its labels' values behind those there, and
/// its quantities besides those there, where none of them asks about all.
void add_questions(StoredResults& results, const Origin& more);

/// The options, with what the campaigns of these results say where the options say nothing: the order of the
/// values compared, and the quantities asked about, of which `all` are those of every run.
CompareOptions options_for(const Origin& origin, CompareOptions options);

}  // namespace fairway
