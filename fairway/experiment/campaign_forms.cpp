// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/campaign_forms.hpp"

#include <algorithm>
#include <filesystem>

namespace fairway::yaml {
namespace {

constexpr std::string_view scenario_schema_text =
    R"({"anyOf": [{"type": "string", "minLength": 1},
                 {"type": "array", "items": {"type": "string", "minLength": 1}, "minItems": 1}]})";

std::vector<CampaignScenarioFile> read_scenarios(const Value& value) {
  const auto one = [](const Value& v) {
    if (!v.tree().is_scalar() || v.tree().text.empty())
      v.expected("the path of a scenario, or a list of such");
    return CampaignScenarioFile{v.tree().text, v.tree().where.location()};
  };
  if (!value.tree().is_list()) return {one(value)};
  std::vector<CampaignScenarioFile> files;
  for (std::size_t i = 0; i < value.tree().items.size(); ++i) files.push_back(one(value.entry(i)));
  if (files.empty()) value.refuse("the list is empty");
  return files;
}

/// `{file: tuned.yaml, label: tuned}`: the mapping that stands in a file, relative to this one.
CampaignAlgorithm read_algorithm_file(const Value& value, const Value& file) {
  value.expect_keys({"file", "label"});
  const std::filesystem::path folder =
      std::filesystem::path(value.tree().where.location().file).parent_path();
  const std::string path = (folder / file.text()).lexically_normal().string();
  const std::optional<std::string> text = document_in(path);
  if (!text) file.refuse(path + " cannot be read");
  const Tree document = parse_tree(*text, path);
  Reading reading;
  CampaignAlgorithm algorithm = read_algorithm({document, "", reading});
  const std::optional<Value> label = value.find("label");
  algorithm.label = label ? title().read(*label) : std::filesystem::path(path).stem().string();
  return algorithm;
}

}  // namespace

Tree schema_text(std::string_view json) { return parse_tree(json, "schema"); }

std::string one_line(const Tree& tree, bool nested) {
  if (tree.is_scalar() || tree.is_null()) {
    // a comma or bracket ends a bare word inside brackets
    const bool breaks = nested && tree.is_scalar() && tree.text.find_first_of(",[]{}") != std::string::npos;
    std::string text = yaml_text(breaks ? Tree::quote(tree.text) : tree);
    return text.substr(0, text.find_last_not_of('\n') + 1);
  }
  std::string text;
  for (std::size_t i = 0; i < tree.items.size(); ++i) {
    if (i > 0) text += ", ";
    if (tree.is_map()) text += one_line(Tree::quote(tree.keys[i])) + ": ";
    text += one_line(tree.items[i], true);
  }
  return tree.is_map() ? "{" + text + "}" : "[" + text + "]";
}

Form<std::vector<CampaignScenarioFile>> scenario_files() {
  return read_only<std::vector<CampaignScenarioFile>>(read_scenarios, schema_text(scenario_schema_text));
}

CampaignAlgorithm read_algorithm(const Value& value) {
  if (const std::optional<Value> file = value.tree().is_map() ? value.find("file") : std::nullopt)
    return read_algorithm_file(value, *file);
  const Choice choice = read_choice(value, "algorithm", Needed::yes, {"label"});
  CampaignAlgorithm algorithm{
      .label = choice.name, .avoider = one_line(value.tree()), .place = {choice.where, choice.path}};
  if (!value.tree().is_map()) return algorithm;

  Tree avoider = Tree::map();
  for (std::size_t i = 0; i < value.tree().keys.size(); ++i) {
    if (value.tree().keys[i] == "label") {
      algorithm.label = title().read(value.entry(i));
    } else {
      avoider.set(value.tree().keys[i], value.tree().items[i]);
    }
  }
  algorithm.avoider = one_line(avoider);
  return algorithm;
}

Form<Overrides> settings(std::string_view others, AvoiderParameters parameters) {
  return read_only<Overrides>(
      [others = std::string(others), parameters](const Value& value) {
        value.expect_map("paths as for --set");
        Overrides settings;
        for (std::size_t i = 0; i < value.tree().keys.size(); ++i) {
          const std::string& path = value.tree().keys[i];
          const bool avoids = names_avoider(path) || (parameters == AvoiderParameters::refused &&
                                                      path.find(".avoider.") != std::string::npos);
          if (path == "seed" || avoids) value.refuse_key(i, "is set by " + others);
          settings.emplace_back(path, one_line(value.tree().items[i]));
        }
        return settings;
      },
      schema_text(R"({"type": "object"})"));
}

Form<std::string> title() {
  Form<std::string> form = name();
  form.read = [](const Value& value) {
    std::string title = name().read(value);
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    if (std::ranges::any_of(title, is_control))
      value.refuse("\"" + shown(title) + "\" has a line break or another control character; expected a name");
    return title;
  };
  return form;
}

Form<std::uint32_t> seed_count() {
  return read_only<std::uint32_t>([](const Value& v) { return v.whole<std::uint32_t>(1, 1'000'000); },
                                  schema_text(R"({"type": "integer", "minimum": 1, "maximum": 1000000})"));
}

}  // namespace fairway::yaml
