// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/merge.hpp"

#include <vector>

#include "fairway/experiment/agreement.hpp"

namespace fairway {
namespace {

/// The runs of a store, held to what came before; each says whose it is.
std::vector<RunRecord> checked(Agreement& agreement, const std::string& file, const Store& store) {
  const Origin origin = store.origin();
  agreement.check(file, origin);
  std::vector<RunRecord> records = store.all();
  for (RunRecord& record : records) {
    agreement.check(file, record);
    if (record.campaign.empty()) record.campaign = origin.digest;
  }
  return records;
}

}  // namespace

MergeReport merge_into(Store& store, const std::string& name, std::span<const std::string> files) {
  Agreement agreement{Together::merged};
  if (store.size() > 0) checked(agreement, name, store);
  for (const std::string& file : files) {
    const Store part = Store::open_existing(file);
    store.put(checked(agreement, file, part));
    const Origin origin = part.origin();
    if (!origin.campaign.empty()) store.note(origin);
    for (const Maker& maker : origin.makers) store.note(maker);
  }
  return {.origin = store.origin(),
          .runs = store.size(),
          .failed = store.failed_count(),
          .of_campaign = store.campaign_size()};
}

}  // namespace fairway
