// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/tuned.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "fairway/exam/entrance.hpp"
#include "fairway/experiment/campaign_forms.hpp"
#include "fairway/experiment/ground_digest.hpp"
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

/// A path as it is told from others, without a slash at its end; nothing is asked of the disk.
fs::path plain(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

/// The family that the folder of a file is named after, or one above that as far as `top`; empty: none is.
std::string family_of(const fs::path& file, const fs::path& top, const std::vector<ExamFamily>& families) {
  for (fs::path folder = plain(file).parent_path();; folder = folder.parent_path()) {
    for (const ExamFamily& family : families)
      if (folder.filename() == family.name) return family.name;
    if (folder == top || !folder.has_relative_path()) return {};
  }
}

/// What tuning.json beside a file of an avoider says of it; null where it says nothing.
nlohmann::json seen_beside(const std::string& file) {
  const fs::path beside = fs::path(file).parent_path() / "tuning.json";
  if (!fs::is_regular_file(beside)) return {};
  const nlohmann::json document = nlohmann::json::parse(text_of_file(beside.string()), nullptr, false);
  return document.is_object() && document.contains("seen") ? document["seen"] : nlohmann::json{};
}

std::vector<std::string> texts_in(const nlohmann::json& seen, const char* key) {
  std::vector<std::string> texts;
  if (!seen.contains(key) || !seen[key].is_array()) return texts;
  for (const nlohmann::json& each : seen[key]) texts.push_back(each.is_string() ? each : nlohmann::json(""));
  return texts;
}

/// What a search calls a ground that it saw, if it did, by its name or by what is in it: "four, which", or
/// "copy, which is four, and that".
std::optional<std::string> name_seen(const nlohmann::json& seen, const ExamGround& ground) {
  const std::vector<std::string> names = texts_in(seen, "scenarios"), digests = texts_in(seen, "digests");
  if (std::ranges::find(names, ground.name) != names.end()) return ground.name + ", which";
  if (digests.empty()) return {};
  const auto same = std::ranges::find(digests, ground_digest(ground.text, ground.file));
  if (same == digests.end()) return {};
  const auto place = static_cast<std::size_t>(same - digests.begin());
  return (place < names.size() ? names[place] : "a copy") + ", which is " + ground.name + ", and that";
}

/// Two that would enter a family under one name.
void refuse_second(const std::string& where, const Candidate& one, const Candidate& other) {
  const bool is_for_all = one.families.empty() || other.families.empty();
  if (other.method.label != one.method.label || (!is_for_all && one.families != other.families)) return;
  throw InputError(where + ": a second one of " + one.method.label + " for " +
                   (one.families.empty() ? "all families" : one.families.front()));
}

}  // namespace

bool is_search_told(const std::string& flag, const std::string& file,
                    const std::vector<ExamFamily>& families) {
  const nlohmann::json all_seen = seen_beside(file);
  if (!all_seen.is_object()) return !text_of_file(file).starts_with("# Tuned by fairway");
  for (const auto& [name, seen] : all_seen.items()) {
    const SeedRange range{seen.value("first_seed", std::uint64_t{1}), seen.value("seed_count", 1U)};
    for (const ExamFamily& family : families) {
      if (!range.meets(family.test)) continue;
      for (const ExamGround& ground : family.grounds)
        if (const std::optional<std::string> seen_as = name_seen(seen, ground))
          throw InputError(flag + " " + file + ": its " + name + " has the seed " +
                           std::to_string(std::max(range.first, family.test.first)) + " of " + *seen_as +
                           " is a test seed of " + family.name);
    }
  }
  return true;
}

Candidate candidate_of(const std::string& name, const ExamFile& exam, const Catalog& methods,
                       const std::string& flag) {
  if (name.ends_with(".yaml")) {
    Candidate own{.method = avoider_in(name), .tuned = false, .families = {}, .file = name};
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

std::vector<Candidate> tuned_candidates(const std::string& path, const ExamFile& exam,
                                        const ExamQuestion& question, const Catalog& methods) {
  const bool is_folder = fs::is_directory(path);
  const fs::path top = is_folder ? plain(path) : plain(path).parent_path();
  const auto is_asked = [&](const Candidate& tuned) {
    const auto is_of = [&](const Candidate& named) {
      return algorithm_of(named.method) == tuned.method.label;
    };
    return !is_folder || !question.by_name || std::ranges::any_of(question.candidates, is_of);
  };
  std::vector<Candidate> candidates;
  std::set<std::string> others;
  for (const std::string& file : avoider_files(path)) {
    Candidate candidate{.method = avoider_in(file), .tuned = true, .families = {}};
    candidate.method.label = algorithm_of(candidate.method);
    expect_known(candidate.method, methods);
    if (!is_asked(candidate)) {
      others.insert(candidate.method.label);
      continue;
    }
    if (std::string family = family_of(file, top, exam.families); !family.empty())
      candidate.families.push_back(std::move(family));
    if (!is_search_told("--tuned", file, question.families))
      throw InputError("--tuned " + file + ": was tuned, and no tuning.json beside it says on which seeds");
    for (const Candidate& other : candidates) refuse_second("--tuned " + file, candidate, other);
    candidates.push_back(std::move(candidate));
  }
  if (candidates.empty())
    throw InputError(
        fmt::format("--tuned {}: has parameters of none of the methods that --methods names; it "
                    "has those of {}",
                    path, fmt::join(others, ", ")));
  return candidates;
}

}  // namespace fairway
