// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/tuning_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "fairway/core/names.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/campaign.hpp"
#include "fairway/experiment/campaign_forms.hpp"

namespace fairway {
namespace {

using Kind = TunedParameter::Kind;
using yaml::Block;
using yaml::Needed;
using yaml::Tree;
using yaml::Value;

// a range that nobody would search as it stands: the declared bounds only keep nonsense out
constexpr double widest_ratio = 1000.0;

std::int32_t read_version(const Value& value) {
  const auto version = value.whole<std::int32_t>();
  if (version != 1)
    value.refuse("is " + std::to_string(version) + "; this fairway reads specifications of version 1");
  return version;
}

std::string text_of(const ParamValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return number_text(*number);
  return std::get<std::string>(value);
}

std::size_t index_of(const std::vector<ParamValue>& values, const ParamValue& value) {
  return static_cast<std::size_t>(std::ranges::find(values, value) - values.begin());
}

double choosable_number(const Value& entry, const ParamInfo& info) {
  const yaml::Bounds bounds = yaml::from_to(info.range.lo, info.range.hi);
  const bool is_whole = info.type == "integer";
  const std::string expected = (is_whole ? "a whole number in " : "a number in ") + bounds.text();
  if (!entry.tree().is_scalar()) entry.expected(expected);
  const double number = entry.number(bounds);
  if (is_whole && std::floor(number) != number) entry.expected(expected);
  return number;
}

/// What an entry of a list of choices means, however it is written.
ParamValue choosable(const Value& entry, const ParamInfo& info) {
  if (info.type == "boolean") return entry.flag();
  if (info.type != "choice") return choosable_number(entry, info);
  std::string text = yaml::one_line(entry.tree());
  if (std::ranges::find(info.choices, text) == info.choices.end())
    entry.refuse("is " + text + suggestion(text, {info.choices.begin(), info.choices.end()}));
  return text;
}

/// `[none, starboard]`, or of a number `[1, 2, 4]`: the values between which to choose.
void read_choices(const Value& value, const ParamInfo& info, TunedParameter& parameter) {
  parameter.kind = Kind::choice;
  std::vector<ParamValue> values;
  for (std::size_t i = 0; i < value.tree().items.size(); ++i) {
    const Value entry = value.entry(i);
    const std::string text = yaml::one_line(entry.tree());
    values.push_back(choosable(entry, info));
    const std::size_t first = index_of(values, values.back());
    if (first < i)
      entry.refuse(text + " is given twice" +
                   (parameter.choices[first] == text ? "" : ", first as " + parameter.choices[first]));
    parameter.choices.push_back(text);
  }
  const std::size_t usual = index_of(values, info.value);
  parameter.usual = static_cast<double>(usual);
  if (usual == values.size()) parameter.beyond = text_of(info.value);
}

/// `{from: 2, to: 60, scale: log}`; what is not given is as the method declares it.
void read_range(const Value& value, const ParamInfo& info, TunedParameter& parameter) {
  value.expect_keys({"from", "to", "scale"});
  parameter.kind = info.type == "integer" ? Kind::integer : Kind::number;
  const yaml::Bounds bounds = yaml::from_to(info.range.lo, info.range.hi);
  const std::optional<Value> from = value.find("from"), to = value.find("to"), scale = value.find("scale");
  parameter.range = {from ? from->number(bounds) : info.range.lo, to ? to->number(bounds) : info.range.hi};
  const auto [lo, hi] = parameter.range;
  if (!(lo < hi)) value.refuse("from must be less than to");
  const double usual = std::get<double>(info.value);
  parameter.usual = std::clamp(usual, lo, hi);
  if (parameter.usual != usual) parameter.beyond = text_of(info.value);
  if ((!from || !to) && hi - lo > widest_ratio * std::max(1.0, std::fabs(lo)))
    value.refuse("may be anything in [" + number_text(lo) + ", " + number_text(hi) +
                 "], which is no range to search; give from and to");
  if (parameter.kind == Kind::integer && (std::floor(lo) != lo || std::floor(hi) != hi))
    value.refuse("is a whole number: from and to must be such");
  if (!scale) return;
  const std::string text = scale->text();
  if (text != "log" && text != "linear") scale->refuse("is \"" + text + "\"; expected linear or log");
  parameter.logarithmic = text == "log";
  if (parameter.logarithmic && parameter.kind == Kind::integer)
    scale->refuse("is for numbers, not for integers");
  if (parameter.logarithmic && lo <= 0.0) scale->refuse("cannot be log where from is not above 0");
}

/// Nothing written: all that the method declares.
void take_all(const Value& value, const ParamInfo& info, TunedParameter& parameter) {
  if (info.type == "number" || info.type == "integer") {
    Tree nothing = Tree::map();
    nothing.where = value.tree().where;
    return read_range(Value{nothing, value.path(), value.reading()}, info, parameter);
  }
  parameter.kind = Kind::choice;
  parameter.choices = info.type == "boolean" ? std::vector<std::string>{"false", "true"} : info.choices;
  const auto usual = std::ranges::find(parameter.choices, text_of(info.value));
  parameter.usual = static_cast<double>(usual - parameter.choices.begin());
}

TunedParameter read_parameter(const Value& value, const ParamInfo& info, const ParamValues& written) {
  TunedParameter parameter{.name = info.name};
  if (info.type == "list") value.refuse("is a list of structures, which is not searched");
  const bool is_number = info.type == "number" || info.type == "integer";
  if (value.tree().is_null()) {
    take_all(value, info, parameter);
  } else if (value.tree().is_list() && value.tree().items.size() > 1) {
    read_choices(value, info, parameter);
  } else if (value.tree().is_map() && is_number) {
    read_range(value, info, parameter);
  } else {
    value.expected(is_number ? "{from: 1, to: 10}, or a list of values"
                             : "a list of values, or nothing for all");
  }
  const auto set =
      std::ranges::find(written, info.name, [](const auto& w) { return std::string_view{w.first}; });
  if (set != written.end())
    value.refuse("is set by method too, so it is not searched for; leave it out there");
  return parameter;
}

std::vector<TunedParameter> read_parameters(const Value& value, const Catalog& methods,
                                            const Choice& method) {
  value.expect_map("parameters, each with what it may be");
  const std::vector<ParamInfo> known = methods.params(method.name);
  if (value.tree().keys.empty()) value.refuse("none is named, so there is nothing to tune");
  std::vector<TunedParameter> parameters;
  for (std::size_t i = 0; i < value.tree().keys.size(); ++i) {
    const std::string& name = value.tree().keys[i];
    const auto info = std::ranges::find(known, name, &ParamInfo::name);
    if (info == known.end()) {
      std::vector<std::string_view> names;
      for (const ParamInfo& p : known) names.push_back(p.name);
      value.refuse_key(i, "is no parameter of " + method.name + suggestion(name, names));
    }
    parameters.push_back(read_parameter(value.entry(i), *info, method.params));
  }
  return parameters;
}

const Block<TuningSet>& set_block() {
  static const Block<TuningSet> seeds{
      key("first", &TuningSet::first_seed, yaml::seed(), "Default 1."),
      key("count", &TuningSet::seed_count, yaml::seed_count(), "How many in a row.", Needed::yes)};
  static const Block<TuningSet> block{
      key("scenario", &TuningSet::scenarios, yaml::scenario_files(),
          "One scenario or several, relative to this file. Default: those of the specification."),
      group("seeds", seeds, "Under each of which every scenario is run.", Needed::yes)};
  return block;
}

/// The file as it is written, without what only the catalog can read.
struct Written {
  std::int32_t version{};
  std::string name;
  std::string summary;
  std::vector<CampaignScenarioFile> scenarios;  ///< of every set that has none of its own
  Overrides set;
  TuningSet train;
  TuningSet validation;
  TuningSet test;
};

const Block<Written>& tuning_block() {
  static const auto apart = [](const Value&, Written&) {};
  static const auto unwritten = [](const Written&) { return std::optional<Tree>{}; };
  static const auto set = yaml::block_form(set_block());
  static const Block<Written> block{
      key("fairway_tuning", &Written::version,
          yaml::read_only<std::int32_t>(read_version, yaml::schema_text(R"({"const": 1})")),
          "The format's version, 1.", Needed::yes),
      key("name", &Written::name, yaml::title(), "Of the specification.", Needed::yes),
      key("summary", &Written::summary, yaml::text(), "What it is meant to find out."),
      {.name = "method",
       .meaning = "The avoider that is tuned, with what is to stay as it is written.",
       .read = apart,
       .write = unwritten,
       .schema = yaml::schema_text(R"({"type": ["string", "object"]})")},
      {.name = "parameters",
       .meaning =
           "What is searched for: {from, to, scale} of a number, a list of values of anything, nothing for "
           "all that the method declares.",
       .read = apart,
       .write = unwritten,
       .schema = yaml::schema_text(R"({"type": "object", "minProperties": 1})")},
      {.name = "methods",
       .meaning = "In place of these two: several, {method, parameters} each, tuned one after the other.",
       .read = apart,
       .write = unwritten,
       .schema = yaml::schema_text(R"({"type": "array", "minItems": 1, "items": {"type": "object"}})")},
      key("scenario", &Written::scenarios, yaml::scenario_files(),
          "What train, validation and test have unless they say otherwise."),
      key("set", &Written::set, yaml::settings("the keys seeds and method", yaml::AvoiderParameters::refused),
          "Paths as for --set, laid over every scenario."),
      key("train", &Written::train, set, "What is searched on.", Needed::yes),
      key("validation", &Written::validation, set, "What the search never sees; shows its luck.",
          Needed::yes),
      key("test", &Written::test, set, "What the result is reported on.", Needed::yes)};
  return block;
}

/// What all methods have in common. Scenarios and settings of the whole specification go to each of its sets.
TuningFile common_of(const Value& root, const Written& written) {
  TuningFile common{.name = written.name,
                    .summary = written.summary,
                    .method = {},
                    .parameters = {},
                    .train = written.train,
                    .validation = written.validation,
                    .test = written.test};
  for (const auto& [name, set] :
       {std::pair{"train", &common.train}, std::pair{"validation", &common.validation},
        std::pair{"test", &common.test}}) {
    if (set->scenarios.empty()) set->scenarios = written.scenarios;
    if (set->scenarios.empty())
      root.at(name).refuse("has no scenario; give it one, or one for the whole specification");
    set->set = written.set;
  }
  return common;
}

/// What is run of a scenario under a seed, whoever avoids there. Of one that cannot be read, which is refused
/// where it is run, its path.
std::string run_of(const TuningSet& set, const std::string& path, std::uint64_t seed) {
  Overrides overrides = set.set;
  overrides.emplace_back("vehicles[*].avoider", "direct");
  try {
    return canonical_text(load_scenario(path, overrides, seed));
  } catch (const InputError&) {
    return path;
  }
}

/// A run that is in both, as "cube20_8 under seed 7", or "copy, which is cube20_8, under seed 7".
std::optional<std::string> common_run(const TuningSet& a, const TuningSet& b,
                                      const std::filesystem::path& folder) {
  const std::uint64_t first = std::max(a.first_seed, b.first_seed);
  const std::uint64_t last = std::min(a.first_seed + (a.seed_count - 1), b.first_seed + (b.seed_count - 1));
  if (first > last) return {};
  const auto place = [&](const CampaignScenarioFile& file) {
    return (folder / file.path).lexically_normal();
  };
  std::map<std::string, std::string> names;  // of the runs of a
  for (const CampaignScenarioFile& file : a.scenarios)
    names.emplace(run_of(a, place(file).string(), first), place(file).stem().string());
  for (const CampaignScenarioFile& file : b.scenarios) {
    const auto same = names.find(run_of(b, place(file).string(), first));
    if (same == names.end()) continue;
    const std::string name = place(file).stem().string();
    return name + (same->second == name ? "" : ", which is " + same->second + ",") + " under seed " +
           std::to_string(first);
  }
  return {};
}

void refuse_common_runs(const TuningFile& tuning, const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  const std::array<std::pair<const char*, const TuningSet*>, 3> sets{
      {{"train", &tuning.train}, {"validation", &tuning.validation}, {"test", &tuning.test}}};
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t j = i + 1; j < sets.size(); ++j)
      if (const auto run = common_run(*sets[i].second, *sets[j].second, folder))
        throw InputError(sets[j].second->scenarios.front().where, sets[j].first,
                         "has " + *run + " as " + sets[i].first + " has; what is judged by must be new");
}

void refuse_bad_seeds(const Value& root, const TuningFile& tuning) {
  if (tuning.train.seed_count < least_train_seeds)
    root.at("train").at("seeds").at("count").refuse("is " + std::to_string(tuning.train.seed_count) +
                                                    "; nobody can be told apart by fewer than " +
                                                    std::to_string(least_train_seeds));
  for (const auto& [name, set] :
       {std::pair{"train", &tuning.train}, std::pair{"validation", &tuning.validation},
        std::pair{"test", &tuning.test}})
    if (set->first_seed + (set->seed_count - 1) < set->first_seed)
      root.at(name).at("seeds").refuse("pass the largest seed there is");
}

/// One of the methods, from a mapping of `method` and `parameters`.
TuningFile tuning_of(const Value& value, const Catalog& methods, TuningFile tuning) {
  const Value method = value.at("method");
  tuning.method = yaml::read_algorithm(method);
  const Choice choice = yaml::read_choice(method, "algorithm", Needed::yes, {"label"});
  yaml::ask_of(tuning.method.place, [&] { methods.params(choice.name); });
  if (methods.params(choice.name).empty())
    value.find("parameters")
        .value_or(method)
        .refuse(choice.name + " has no parameters, so there is nothing to tune");
  tuning.parameters = read_parameters(value.at("parameters"), methods, choice);
  return tuning;
}

std::vector<TuningFile> tunings_of(const Value& list, const Catalog& methods, const TuningFile& common) {
  list.expect_list("methods, {method, parameters} each");
  std::vector<TuningFile> tunings;
  for (std::size_t i = 0; i < list.tree().items.size(); ++i) {
    const Value entry = list.entry(i);
    entry.expect_keys({"method", "parameters"});
    TuningFile tuning = tuning_of(entry, methods, common);
    const std::string& label = tuning.method.label;
    if (label.find('/') != std::string::npos || label.starts_with('.'))
      entry.at("method").refuse("has the label " + label + ", which cannot name a folder");
    if (std::ranges::any_of(tunings, [&](const TuningFile& t) { return t.method.label == label; }))
      entry.refuse("a second " + label + "; give it a label of its own");
    tuning.name += " " + label;
    tunings.push_back(std::move(tuning));
  }
  if (tunings.empty()) list.refuse("the list is empty");
  return tunings;
}

}  // namespace

TuningSpecification parse_tuning_file(std::string_view text, const std::string& file,
                                      const Catalog& methods) {
  const Tree document = yaml::parse_tree(text, file);
  if (!document.is_map() || document.find("fairway_tuning") == nullptr)
    throw InputError(
        {file, 0, 0}, "",
        "not a specification of a tuning: expected keys such as fairway_tuning, method and train");
  yaml::Reading reading{0};
  const Value root{document, "", reading};
  Written written;
  yaml::read_block(root, tuning_block(), written);
  const TuningFile common = common_of(root, written);
  refuse_bad_seeds(root, common);
  refuse_common_runs(common, file);
  const std::optional<Value> list = root.find("methods");
  if (!list) return {{tuning_of(root, methods, common)}, false};
  for (const char* single : {"method", "parameters"})
    if (const std::optional<Value> other = root.find(single)) other->refuse("is given beside methods");
  return {tunings_of(*list, methods, common), true};
}

}  // namespace fairway
