// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/merge.hpp"

#include <bit>
#include <unordered_map>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

std::string text_of_run(const RunSpec& spec) {
  return labels_text(spec.labels) + " seed=" + std::to_string(spec.seed);
}

std::string digest_of_measures(const RunRecord& record) {
  Digest digest;
  for (const Measure& m : record.measures) {
    digest.add(m.quantity).add(std::to_string(m.vehicle));
    digest.add(std::to_string(std::bit_cast<std::uint64_t>(m.value)));
  }
  return digest.hex();
}

std::string campaign_name(const Origin& origin) {
  return origin.campaign.empty() ? "no campaign" : "campaign " + origin.campaign;
}

/// "cubes" of a study's run "cubes/...", empty of a campaign's.
std::string study_of(const RunSpec& spec) {
  const std::size_t slash = spec.key.find('/');
  return slash == std::string::npos ? "" : spec.key.substr(0, slash);
}

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw InputError(file + ": " + why + "; nothing was merged");
}

/// Holds every store to the first, and every run to what was met of it before.
class Agreement {
 public:
  /// Throws InputError where `store` or one of its runs, which come back, disagrees with what came before.
  std::vector<RunRecord> checked(const std::string& file, const Store& store) {
    check(file, store.origin());
    std::vector<RunRecord> records = store.all();
    for (const RunRecord& record : records) check(file, record);
    return records;
  }

 private:
  void check(const std::string& file, const Origin& origin) {
    const std::string epoch = std::to_string(results_epoch);
    if (origin.epoch != epoch)
      refuse(file, "is of results epoch " + origin.epoch + ", and this fairway of " + epoch);
    if (first_file_.empty()) {
      first_file_ = file;
      first_ = origin;
    } else if (origin.campaign != first_.campaign) {
      refuse(file,
             "is of " + campaign_name(origin) + ", and " + first_file_ + " of " + campaign_name(first_));
    } else if (origin.digest != first_.digest) {
      refuse(file, "is of another version of " + campaign_name(origin) + " than " + first_file_);
    }
  }

  void check(const std::string& file, const RunRecord& record) {
    const RunSpec& spec = record.spec;
    const std::string study = study_of(spec);
    if (keys_.empty()) study_ = study;
    if (study != study_)
      refuse(file, "is of study " + study + ", and " + first_file_ + " of study " + study_);

    const auto [same_run, is_new] = keys_.try_emplace(text_of_run(spec), Known{spec.key, file});
    if (!is_new && study.empty() && same_run->second.digest != spec.key)
      refuse(file, "has another version of the run " + same_run->first + " than " + same_run->second.file);
    if (!record.failure.empty()) return;
    const std::string measures = digest_of_measures(record);
    const auto [made, is_first] = measures_.try_emplace(spec.key, Known{measures, file});
    if (!is_first && made->second.digest != measures) {
      refuse(file, "came to other results of the run " + text_of_run(spec) + " than " + made->second.file +
                       ": they were made on machines that do not come to the same bits");
    }
  }

  /// A digest, and the file in which it was met.
  struct Known {
    std::string digest;
    std::string file;
  };
  std::string first_file_;
  Origin first_;
  std::string study_;
  std::unordered_map<std::string, Known> keys_;      ///< by labels and seed
  std::unordered_map<std::string, Known> measures_;  ///< by key
};

}  // namespace

MergeReport merge_into(Store& store, const std::string& name, std::span<const std::string> files) {
  Agreement agreement;
  if (store.size() > 0) agreement.checked(name, store);
  for (const std::string& file : files) {
    const Store part = Store::open_existing(file);
    store.put(agreement.checked(file, part));
    const Origin origin = part.origin();
    if (!origin.campaign.empty()) store.note(origin);
    for (const Maker& maker : origin.makers) store.note(maker);
  }
  return {.origin = store.origin(), .runs = store.size(), .failed = store.failed_count()};
}

}  // namespace fairway
