// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/maker.hpp"
#include "fairway/experiment/sqlite.hpp"

namespace fairway {

/// Where the results of a store come from. What an older fairway did not note, or no campaign filled, is
/// empty.
struct Origin {
  std::string campaign{};   ///< its name
  std::string digest{};     ///< Campaign::digest
  std::size_t run_count{};  ///< of the whole campaign
  std::string summary{};
  std::vector<std::string> quantities{};  ///< that the campaign asks about; empty: all
  LabelValues order{};                    ///< of the campaign swept last, and behind it of those before
  std::string version{};
  std::string epoch{};
  std::vector<Maker> makers{};  ///< of its runs, in the order in which they began
};

/// Reads the store's table `meta`.
Origin read_origin(Database& database);

/// Notes a campaign there, in a transaction of its own; the version and epoch of a store do not change. What
/// is noted already is not written again. Throws InputError if the file cannot be written.
void note_campaign(Database& database, Origin campaign);

/// Notes likewise who made the runs that follow.
void note_maker(Database& database, const Maker& maker);

}  // namespace fairway
