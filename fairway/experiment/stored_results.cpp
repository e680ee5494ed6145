// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/stored_results.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "fairway/experiment/store.hpp"

namespace fairway {
namespace {

/// "a, b", each once.
void join(std::string& all, std::set<std::string>& known, const std::string& more) {
  if (more.empty() || !known.insert(more).second) return;
  all += (all.empty() ? "" : ", ") + more;
}

}  // namespace

void GatheredResults::add(const std::string& name, const Origin& origin, std::vector<RunRecord> records) {
  agreement_.check(name, origin);
  join(results_.origin.campaign, names_, origin.campaign);
  join(results_.origin.summary, summaries_, origin.summary);
  join(results_.origin.version, versions_, origin.version);
  join(results_.origin.epoch, epochs_, origin.epoch);
  for (const Maker& maker : origin.makers) add_maker(results_.origin.makers, maker);
  if (is_begun_ && results_.origin.digest != origin.digest) results_.origin.digest.clear();
  if (!is_begun_) results_.origin.digest = origin.digest;
  is_begun_ = true;
  add_questions(results_, origin);
  for (RunRecord& record : records) {
    agreement_.check(name, record);
    const auto [place, is_new] = places_.try_emplace(record.spec.key, results_.records.size());
    if (is_new) {
      results_.records.push_back(std::move(record));
    } else if (RunRecord& known = results_.records[place->second]; !known.failure.empty()) {
      known = std::move(record);
    }
  }
}

void GatheredResults::add_store(const std::string& file) {
  const Store store = Store::open_existing(file);
  Origin origin = store.origin();
  if (origin.campaign.empty()) origin.campaign = std::filesystem::path(file).stem().string();
  add(file, origin, store.all());
}

StoredResults read_stores(std::span<const std::string> files, Together purpose) {
  GatheredResults results{purpose};
  for (const std::string& file : files) results.add_store(file);
  return results.take();
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
  if (options.quantities.empty()) {
    for (const std::string& quantity : origin.quantities) {
      if (std::ranges::find(options.quantities, quantity) == options.quantities.end())
        options.quantities.push_back(quantity);
    }
  }
  if (options.quantities == std::vector<std::string>{"all"}) options.quantities.clear();
  return options;
}

}  // namespace fairway
