// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_file.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include "fairway/experiment/campaign_forms.hpp"

namespace fairway {
namespace {

using yaml::Block;
using yaml::Form;
using yaml::Needed;
using yaml::read_only;
using yaml::schema_text;
using yaml::Tree;
using yaml::Value;

Form<std::int32_t> version_form() {
  return read_only<std::int32_t>(
      [](const Value& value) {
        const auto version = value.whole<std::int32_t>();
        if (version != 1) value.refuse("is " + std::to_string(version) + "; this fairway reads version 1");
        return version;
      },
      schema_text(R"({"const": 1})"));
}

Form<std::vector<std::string>> names_form(std::string_view of) { return yaml::list_of(yaml::name(), of); }

Form<Overrides> settings_form() {
  return yaml::settings("the exam itself", yaml::AvoiderParameters::refused);
}

Form<CampaignAlgorithm> algorithm_form() {
  return read_only<CampaignAlgorithm>(yaml::read_algorithm, schema_text(R"({"type": ["string", "object"]})"));
}

const Block<SeedRange>& seeds_block() {
  static const Block<SeedRange> block{
      key("first", &SeedRange::first, yaml::seed(), "The first of them.", Needed::yes),
      key("count", &SeedRange::count, yaml::seed_count(), "How many in a row.", Needed::yes)};
  return block;
}

/// What a family asks of a method.
void read_needs(const Value& value, ExamFamily& family) {
  const std::array<std::pair<std::string_view, bool*>, 4> known{{{"movers", &family.needs_movers},
                                                                 {"obstacles", &family.needs_obstacles},
                                                                 {"space", &family.needs_space},
                                                                 {"way", &family.needs_way}}};
  value.expect_list("movers, obstacles, space and way");
  for (std::size_t i = 0; i < value.tree().items.size(); ++i) {
    const std::string need = value.entry(i).text();
    const auto found = std::ranges::find(known, need, &std::pair<std::string_view, bool*>::first);
    if (found == known.end())
      value.entry(i).refuse("is " + need + suggestion(need, {"movers", "obstacles", "space", "way"}));
    *found->second = true;
  }
}

const Block<ExamFamily>& family_block() {
  static const auto unwritten = [](const ExamFamily&) { return std::optional<Tree>{}; };
  static const auto range = yaml::block_form(seeds_block());
  static const Block<ExamFamily> seeds{
      key("train", &ExamFamily::train, range, "Parameters are searched on these.", Needed::yes),
      key("validation", &ExamFamily::validation, range, "Luck of the search shows on these.", Needed::yes),
      key("test", &ExamFamily::test, range, "The exam is held on these.", Needed::yes)};
  static const Block<ExamFamily> block{
      key("fairway_family", &ExamFamily::version, version_form(), "The format's version, 1.", Needed::yes),
      key("name", &ExamFamily::name, yaml::title(), "As it stands in results.", Needed::yes),
      key("summary", &ExamFamily::summary, yaml::name(), "What happens on these grounds.", Needed::yes),
      key("source", &ExamFamily::source, yaml::name(), "Where they come from, and what is drawn.",
          Needed::yes),
      {.name = "needs",
       .meaning = "What a method must be made for: movers, obstacles, space, way (not all there can stop).",
       .needed = Needed::yes,
       .read = read_needs,
       .write = unwritten,
       .schema =
           schema_text(R"({"type": "array", "items": {"enum": ["movers", "obstacles", "space", "way"]}})")},
      key("grounds", &ExamFamily::scenarios, yaml::scenario_files(), "Its scenarios, relative to this file.",
          Needed::yes),
      key("train_on", &ExamFamily::train_on, names_form("names of grounds"),
          "The grounds that parameters may be searched on."),
      key("keep_named_avoiders", &ExamFamily::keep_named_avoiders, yaml::flag(),
          "Whether vehicles that name an avoider of their own keep it."),
      key("set", &ExamFamily::set, settings_form(), "Laid over its scenarios."),
      group("seeds", seeds, "Ranges that share no seed.", Needed::yes)};
  return block;
}

ConditionOf read_of(const Value& value) {
  const std::string text = value.text();
  if (text == "told") return ConditionOf::told;
  if (text == "seen") return ConditionOf::seen;
  if (text != "all") value.refuse("is " + text + suggestion(text, {"all", "told", "seen"}));
  return ConditionOf::all;
}

const Block<ExamCondition>& condition_block() {
  static const Block<ExamCondition> block{
      key("name", &ExamCondition::name, yaml::title(), "As it stands in results.", Needed::yes),
      key("meaning", &ExamCondition::meaning, yaml::name(), "In a sentence.", Needed::yes),
      key("of", &ExamCondition::of,
          read_only<ConditionOf>(read_of, schema_text(R"({"enum": ["all", "told", "seen"]})")),
          "Where it makes a difference: everywhere; where somebody tells; where something is seen."),
      key("set", &ExamCondition::set, settings_form(), "Laid over every scenario.")};
  return block;
}

const Block<ExamOmission>& omission_block() {
  static const Block<ExamOmission> block{
      key("method", &ExamOmission::method, yaml::name(), "Its label.", Needed::yes),
      key("families", &ExamOmission::families, names_form("names of families"), "Where it is left out.",
          Needed::yes),
      key("why", &ExamOmission::why, yaml::name(), "In a few words.", Needed::yes)};
  return block;
}

const Block<ExamFile>& exam_block() {
  static const Block<ExamFile> block{
      key("fairway_exam", &ExamFile::version, version_form(), "The format's version, 1.", Needed::yes),
      key("name", &ExamFile::name, yaml::title(), "Of the exam.", Needed::yes),
      key("summary", &ExamFile::summary, yaml::text(), "What it is meant to find out."),
      key("baseline", &ExamFile::baseline, algorithm_form(),
          "What times, lengths and energies are relative to; it enters every family and no ranking.",
          Needed::yes),
      key("methods", &ExamFile::methods,
          read_only<std::vector<CampaignAlgorithm>>(
              [](const Value& value) {
                value.expect_list("methods");
                std::vector<CampaignAlgorithm> methods;
                for (std::size_t i = 0; i < value.tree().items.size(); ++i)
                  methods.push_back(yaml::read_algorithm(value.entry(i)));
                return methods;
              },
              schema_text(R"({"type": "array", "minItems": 1})")),
          "Who is asked unless --methods says so.", Needed::yes),
      key("conditions", &ExamFile::conditions,
          yaml::list_of(yaml::block_form(condition_block()), "conditions"),
          "The first is the one that the others are held against.", Needed::yes),
      key("omissions", &ExamFile::omissions, yaml::list_of(yaml::block_form(omission_block()), "omissions"),
          "Cells that are left out unless the method is asked for by name."),
      key("families", &ExamFile::family_files, names_form("paths of family files"), "Relative to this file.",
          Needed::yes)};
  return block;
}

template <class T>
void refuse_twice(const std::vector<T>& all, const std::string& file, const char* what,
                  std::string T::*name = &T::name, const char* advice = "") {
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (all[i].*name == all[j].*name)
        throw InputError({file, 0, 0}, what, "a second one named " + all[i].*name + advice);
}

void refuse_common_seeds(const ExamFamily& family) {
  const std::array<std::pair<const char*, const SeedRange*>, 3> ranges{
      {{"train", &family.train}, {"validation", &family.validation}, {"test", &family.test}}};
  for (const auto& [name, range] : ranges)
    if (range->last() < range->first)
      throw InputError({family.file, 0, 0}, std::string{"seeds."} + name, "passes the largest seed there is");
  for (std::size_t i = 0; i < ranges.size(); ++i)
    for (std::size_t j = i + 1; j < ranges.size(); ++j)
      if (ranges[i].second->meets(*ranges[j].second))
        throw InputError({family.file, 0, 0}, std::string{"seeds."} + ranges[j].first,
                         "has the seed " +
                             std::to_string(std::max(ranges[i].second->first, ranges[j].second->first)) +
                             " as " + ranges[i].first + " has; what is judged by must be new");
}

Tree document_of(const std::string& text, const std::string& file, const char* key, const char* what) {
  Tree document = yaml::parse_tree(text, file);
  if (!document.is_map() || document.find(key) == nullptr)
    throw InputError({file, 0, 0}, "", std::string{"not "} + what + ": it would begin with " + key + ": 1");
  return document;
}

}  // namespace

std::string text_of_file(const std::string& file) {
  std::optional<std::string> text = yaml::document_in(file);
  if (!text) throw InputError({file, 0, 0}, "", "cannot be read");
  return std::move(*text);
}

ExamFamily parse_family(const std::string& text, const std::string& file) {
  const Tree document = document_of(text, file, "fairway_family", "a family of scenarios");
  yaml::Reading reading{0};
  ExamFamily family;
  family.file = file;
  yaml::read_block(Value{document, "", reading}, family_block(), family);
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (const CampaignScenarioFile& scenario : family.scenarios) {
    const std::filesystem::path path = (folder / scenario.path).lexically_normal();
    if (!std::filesystem::is_regular_file(path))
      throw InputError(scenario.where, "grounds", path.string() + " cannot be read");
    family.grounds.push_back({path.stem().string(), path.string(), text_of_file(path.string())});
  }
  refuse_twice(family.grounds, file, "grounds");
  std::vector<std::string_view> names;
  for (const ExamGround& ground : family.grounds) names.push_back(ground.name);
  for (const std::string& name : family.train_on)
    if (std::ranges::find(names, name) == names.end())
      throw InputError({file, 0, 0}, "train_on", "no ground is named " + name + suggestion(name, names));
  refuse_common_seeds(family);
  return family;
}

ExamFile load_exam(const std::string& file) {
  const Tree document = document_of(text_of_file(file), file, "fairway_exam", "an exam");
  yaml::Reading reading{0};
  ExamFile exam;
  exam.file = file;
  yaml::read_block(Value{document, "", reading}, exam_block(), exam);
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (const std::string& name : exam.family_files) {
    const std::string path = (folder / name).lexically_normal().string();
    exam.families.push_back(parse_family(text_of_file(path), path));
  }
  refuse_twice(exam.methods, file, "methods", &CampaignAlgorithm::label, "; give it a label of its own");
  if (exam.conditions.empty()) throw InputError({file, 0, 0}, "conditions", "the list is empty");
  if (exam.families.empty()) throw InputError({file, 0, 0}, "families", "the list is empty");
  refuse_twice(exam.conditions, file, "conditions");
  refuse_twice(exam.families, file, "families");
  return exam;
}

}  // namespace fairway
