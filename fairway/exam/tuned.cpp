// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/tuned.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "fairway/exam/entrance.hpp"
#include "fairway/experiment/campaign_forms.hpp"
#include "fairway/scenario/block.hpp"

namespace fairway {
namespace {

namespace fs = std::filesystem;

CampaignAlgorithm avoider_in(const std::string& file) {
  const yaml::Tree document = yaml::parse_tree(text_of_file(file), file);
  yaml::Reading reading;
  return yaml::read_algorithm({document, "", reading});
}

std::vector<std::string> avoider_files(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file() && entry.path().extension() == ".yaml")
      files.push_back(entry.path().string());
  if (files.empty())
    throw InputError("--tuned " + path + ": there is no avoider in it, a file such as best.yaml");
  std::ranges::sort(files);
  return files;
}

/// The family that one of the folders above a file is named after; empty: none is.
std::string family_above(const fs::path& file, const std::vector<ExamFamily>& families) {
  for (fs::path folder = fs::absolute(file).parent_path(); folder.has_relative_path();
       folder = folder.parent_path())
    for (const ExamFamily& family : families)
      if (folder.filename() == family.name) return family.name;
  return {};
}

/// What tuning.json beside a file of an avoider says of it; null where it says nothing.
nlohmann::json seen_beside(const std::string& file) {
  const fs::path beside = fs::path(file).parent_path() / "tuning.json";
  if (!fs::is_regular_file(beside)) return {};
  const nlohmann::json document = nlohmann::json::parse(text_of_file(beside.string()), nullptr, false);
  return document.is_object() && document.contains("seen") ? document["seen"] : nlohmann::json{};
}

}  // namespace

bool is_search_told(const std::string& flag, const std::string& file,
                    const std::vector<ExamFamily>& families) {
  const nlohmann::json all_seen = seen_beside(file);
  if (!all_seen.is_object()) return !text_of_file(file).starts_with("# Tuned by fairway");
  for (const auto& [name, seen] : all_seen.items()) {
    const SeedRange range{seen.value("first_seed", std::uint64_t{1}), seen.value("seed_count", 1U)};
    for (const ExamFamily& family : families)
      for (const ExamGround& ground : family.grounds)
        if (range.meets(family.test) &&
            std::ranges::find(seen["scenarios"], nlohmann::json(ground.name)) != seen["scenarios"].end())
          throw InputError(flag + " " + file + ": its " + name + " has the seed " +
                           std::to_string(std::max(range.first, family.test.first)) + " of " + ground.name +
                           ", which is a test seed of " + family.name);
  }
  return true;
}

Candidate candidate_of(const std::string& name, const ExamFile& exam, const Catalog& methods,
                       const std::string& flag) {
  if (name.ends_with(".yaml")) {
    Candidate own{.method = avoider_in(name), .tuned = false, .families = {}};
    own.method.label = fs::path(name).stem().string();
    expect_known(own.method, methods);
    return own;
  }
  for (const CampaignAlgorithm& method : exam.methods) {
    if (method.label != name) continue;
    expect_known(method, methods);
    return {.method = method, .tuned = false, .families = {}};
  }
  try {
    methods.params(name);
  } catch (const InputError& error) {
    throw InputError(flag + " " + name + ": " + error.what());
  }
  return {.method = {.label = name, .avoider = name}, .tuned = false, .families = {}};
}

std::vector<Candidate> tuned_candidates(const std::string& path, const std::vector<ExamFamily>& families,
                                        const Catalog& methods) {
  std::vector<Candidate> candidates;
  for (const std::string& file : avoider_files(path)) {
    Candidate candidate{.method = avoider_in(file), .tuned = true, .families = {}};
    candidate.method.label = algorithm_of(candidate.method);
    expect_known(candidate.method, methods);
    if (std::string family = family_above(file, families); !family.empty())
      candidate.families.push_back(std::move(family));
    if (!is_search_told("--tuned", file, families))
      throw InputError("--tuned " + file + ": was tuned, and no tuning.json beside it says on which seeds");
    for (const Candidate& other : candidates)
      if (other.method.label == candidate.method.label && other.families == candidate.families)
        throw InputError("--tuned " + file + ": a second one of " + candidate.method.label + " for " +
                         (candidate.families.empty() ? "all families" : candidate.families.front()));
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

}  // namespace fairway
