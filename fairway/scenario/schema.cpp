// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/load.hpp"
#include "fairway/scenario/parts.hpp"

namespace fairway {
namespace yaml {
namespace {

Tree pair_schema(std::string_view key) {
  const Tree number = Tree::map({{"type", Tree::quote("number")}});
  const Tree pair = Tree::map({{"type", Tree::quote("array")},
                               {"items", number},
                               {"minItems", Tree::word("2")},
                               {"maxItems", Tree::word("2")}});
  return detail::object_schema({{std::string(key), pair}}, {key});
}

Tree definitions() {
  Tree distribution =
      Tree::map({{"description", Tree::quote("Drawn once, from the seed and the value's path.")},
                 {"oneOf", Tree::list({pair_schema("uniform"), pair_schema("normal")})}});
  const Tree drawn = Tree::map({{"$ref", Tree::quote("#/$defs/distribution")}});
  const Tree plain = Tree::map(
      {{"type", Tree::list({Tree::quote("number"), Tree::quote("boolean"), Tree::quote("string")})}});
  const Tree value = Tree::map({{"anyOf", Tree::list({plain, drawn})}});
  const Tree item = Tree::map({{"type", Tree::quote("object")}, {"additionalProperties", value}});
  const Tree list = Tree::map({{"type", Tree::quote("array")},
                               {"items", item},
                               {"maxItems", Tree::word(std::to_string(max_list_items))}});
  Tree parameter = Tree::map({{"anyOf", Tree::list({plain, drawn, list})}});
  return Tree::map({{"distribution", std::move(distribution)}, {"parameter", std::move(parameter)}});
}

/// Vehicles are listed, or a fleet, which the loader makes vehicles of before it asks for them.
void let_fleet_do(Tree& schema) {
  Tree& required = *schema.find("required");
  std::erase_if(required.items, [](const Tree& key) { return key.text == "vehicles"; });
  const auto needs = [](std::string_view key) {
    return Tree::map({{"required", Tree::list({Tree::quote(key)})}});
  };
  schema.set("anyOf", Tree::list({needs("vehicles"), needs("fleet")}));
}

}  // namespace
}  // namespace yaml

std::string scenario_schema() {
  using yaml::Tree;
  Tree schema = Tree::map(
      {{"$schema", Tree::quote("https://json-schema.org/draft/2020-12/schema")},
       {"title", Tree::quote("fairway scenario")},
       {"description", Tree::quote("SI units, north-east-down; the unit is in the name of each key.")}});
  Tree body = yaml::schema_of(yaml::scenario_block());
  for (std::size_t i = 0; i < body.keys.size(); ++i) schema.set(body.keys[i], std::move(body.items[i]));
  yaml::let_fleet_do(schema);
  schema.set("$defs", yaml::definitions());
  return json_text(schema);
}

}  // namespace fairway
