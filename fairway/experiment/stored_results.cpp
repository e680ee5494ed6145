// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/stored_results.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "fairway/experiment/store.hpp"

namespace fairway {
namespace {

/// "a, b", each once.
void join(std::string& all, std::set<std::string>& known, const std::string& more) {
  if (more.empty() || !known.insert(more).second) return;
  all += (all.empty() ? "" : ", ") + more;
}

}  // namespace

StoredResults read_stores(std::span<const std::string> files) {
  StoredResults results;
  std::set<std::string> keys, names, summaries, versions, epochs;
  for (const std::string& file : files) {
    const Store store = Store::open_existing(file);
    const Origin origin = store.origin();
    join(results.origin.campaign, names,
         origin.campaign.empty() ? std::filesystem::path(file).stem().string() : origin.campaign);
    join(results.origin.summary, summaries, origin.summary);
    join(results.origin.version, versions, origin.version);
    join(results.origin.epoch, epochs, origin.epoch);
    add_values(results.origin.order, origin.order);
    std::ranges::copy_if(store.all(), std::back_inserter(results.records),
                         [&](const RunRecord& record) { return keys.insert(record.spec.key).second; });
  }
  return results;
}

}  // namespace fairway
