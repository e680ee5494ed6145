// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "fairway/experiment/store.hpp"

namespace fairway {

/// What a merge came to.
struct MergeReport {
  Origin origin;              ///< of all of them: their campaign, and whoever made them
  std::size_t runs{};         ///< in the store now
  std::size_t failed{};       ///< of these
  std::size_t of_campaign{};  ///< of these, others being of another campaign or version that was there before

  /// How many of the campaign are not there, as far as it is known how many it has.
  std::size_t missing() const { return origin.run_count > of_campaign ? origin.run_count - of_campaign : 0; }
};

/// Puts the runs of `files`, in whatever order, into `store`, which is empty or held to them under `name`. A
/// run that several of them hold is taken once; one that went well before one that failed. Throws InputError,
/// which names the files, if one of them is damaged, of another results epoch than this program's, or of
/// another campaign than the first; if two hold different versions of a run (its scenario has changed in
/// between), or different results of one run, as machines have made that do not come to the same bits. What
/// `store` holds is then of no use.
MergeReport merge_into(Store& store, const std::string& name, std::span<const std::string> files);

}  // namespace fairway
