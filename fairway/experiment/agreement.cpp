// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/agreement.hpp"

#include "fairway/core/error.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/run_marks.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

constexpr const char* apart = "; compare them apart, or say that they are to be mixed";

std::string text_of_run(const RunSpec& spec) {
  return labels_text(spec.labels) + " seed=" + std::to_string(spec.seed);
}

std::string campaign_name(const Origin& origin) {
  return origin.campaign.empty() ? "no campaign" : "campaign " + origin.campaign;
}

/// "cubes" of a study's run "cubes/...", empty of a campaign's.
std::string study_of(const RunSpec& spec) {
  const std::size_t slash = spec.key.find('/');
  return slash == std::string::npos ? "" : spec.key.substr(0, slash);
}

}  // namespace

void Agreement::refuse(const std::string& name, const std::string& why) const {
  throw InputError(name + ": " + why + (purpose_ == Together::merged ? "; nothing was merged" : ""));
}

void Agreement::check(const std::string& name, const Origin& origin) {
  if (purpose_ == Together::merged) check_merged(name, origin);
  if (purpose_ == Together::compared) check_compared(name, origin);
}

void Agreement::check_merged(const std::string& name, const Origin& origin) {
  const std::string epoch = std::to_string(results_epoch);
  if (origin.epoch != epoch)
    refuse(name, "is of results epoch " + origin.epoch + ", and this fairway of " + epoch);
  if (first_file_.empty()) {
    first_file_ = name;
    first_ = origin;
  } else if (origin.campaign != first_.campaign) {
    refuse(name, "is of " + campaign_name(origin) + ", and " + first_file_ + " of " + campaign_name(first_));
  } else if (origin.digest != first_.digest) {
    refuse(name, "is of another version of " + campaign_name(origin) + " than " + first_file_);
  }
}

void Agreement::check_compared(const std::string& name, const Origin& origin) {
  for (const Maker& maker : origin.makers) {
    if (!maker.epoch.empty() && !origin.epoch.empty() && maker.epoch != origin.epoch)
      refuse(name, "is of results epoch " + origin.epoch + ", and has runs of " + maker.epoch + apart);
  }
  if (epoch_.digest.empty()) epoch_ = {origin.epoch, name};
  if (!origin.epoch.empty() && origin.epoch != epoch_.digest) {
    refuse(name,
           "is of results epoch " + origin.epoch + ", and " + epoch_.file + " of " + epoch_.digest + apart);
  }
  if (origin.campaign.empty() || origin.digest.empty()) return;
  const auto [known, is_first] = campaigns_.try_emplace(origin.campaign, Known{origin.digest, name});
  if (!is_first && known->second.digest != origin.digest)
    refuse(name, "is of another version of " + campaign_name(origin) + " than " + known->second.file + apart);
}

void Agreement::check_version(const std::string& name, const RunSpec& spec) {
  const std::string study = study_of(spec);
  if (keys_.empty()) study_ = study;
  if (study != study_) refuse(name, "is of study " + study + ", and " + first_file_ + " of study " + study_);
  const auto [same_run, is_new] = keys_.try_emplace(text_of_run(spec), Known{spec.key, name});
  if (!is_new && study.empty() && same_run->second.digest != spec.key)
    refuse(name, "has another version of the run " + same_run->first + " than " + same_run->second.file);
}

void Agreement::check(const std::string& name, const RunRecord& record) {
  if (purpose_ == Together::merged) check_version(name, record.spec);
  if (!record.failure.empty()) return;
  const std::string measures = digest_of(record.measures);
  const auto [made, is_first] = measures_.try_emplace(record.spec.key, Known{measures, name});
  if (!is_first && made->second.digest != measures) {
    refuse(name, "came to other results of the run " + text_of_run(record.spec) + " than " +
                     made->second.file + ": they were made on machines that do not come to the same bits");
  }
}

}  // namespace fairway
