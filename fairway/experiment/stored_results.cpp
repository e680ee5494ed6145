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
    add_questions(results, origin);
    std::ranges::copy_if(store.all(), std::back_inserter(results.records),
                         [&](const RunRecord& record) { return keys.insert(record.spec.key).second; });
  }
  return results;
}

void add_questions(StoredResults& results, const Origin& more) {
  add_values(results.origin.order, more.order);
  std::vector<std::string>& asked = results.origin.quantities;
  if (results.records.empty()) {
    asked = more.quantities;
  } else if (asked.empty() || more.quantities.empty()) {
    asked.clear();
  } else {
    std::ranges::copy_if(more.quantities, std::back_inserter(asked), [&](const std::string& quantity) {
      return std::ranges::find(asked, quantity) == asked.end();
    });
  }
}

CompareOptions options_for(const Origin& origin, CompareOptions options) {
  if (options.order.empty()) options.order = values_of(origin.order, options.by);
  if (options.quantities.empty()) options.quantities = origin.quantities;
  if (options.quantities == std::vector<std::string>{"all"}) options.quantities.clear();
  return options;
}

}  // namespace fairway
