// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/block.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fairway::yaml {
namespace detail {
namespace {

std::string_view stem_of(std::string_view name) { return name.substr(0, name.rfind('_')); }

}  // namespace

std::string with_default(std::string_view meaning, const std::function<std::optional<Tree>()>& usual) {
  std::string text{meaning};
  if (const auto place = text.find("{}"); place != std::string::npos)
    text.replace(place, 2, usual().value_or(Tree{}).text);
  return text;
}

void check_keys(const Value& value, const std::vector<std::string_view>& names,
                const std::vector<std::string_view>& needed) {
  value.expect_keys(names);
  const std::vector<std::string>& keys = value.tree().keys;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (stem_of(keys[i]) == stem_of(keys[j]))
        value.refuse_key(i, "given before as " + keys[j] + "; keep one");
    }
  }

  if (value.reading().partial) return;
  for (const std::string_view name : needed) {
    if (std::ranges::find(keys, name) == keys.end())
      value.refuse("the key " + std::string(name) + " is missing");
  }
}

Tree object_schema(const std::vector<std::pair<std::string, Tree>>& properties,
                   const std::vector<std::string_view>& needed) {
  Tree schema = Tree::map({{"type", Tree::quote("object")}, {"properties", Tree::map(properties)}});
  if (!needed.empty()) {
    Tree names = Tree::list();
    for (const std::string_view name : needed) names.items.push_back(Tree::quote(name));
    schema.set("required", std::move(names));
  }
  schema.set("additionalProperties", Tree::word("false"));
  return schema;
}

Tree described(Tree schema, std::string_view meaning) {
  Tree with = Tree::map({{"description", Tree::quote(meaning)}});
  for (std::size_t i = 0; i < schema.keys.size(); ++i) with.set(schema.keys[i], std::move(schema.items[i]));
  return with;
}

}  // namespace detail

namespace {

Tree type(std::string_view name) { return Tree::map({{"type", Tree::quote(name)}}); }

Tree reference(std::string_view definition) {
  return Tree::map({{"$ref", Tree::quote("#/$defs/" + std::string(definition))}});
}

template <std::integral T>
Form<T> whole(T lo = std::numeric_limits<T>::min(), T hi = std::numeric_limits<T>::max()) {
  return {.read = [lo, hi](const Value& value) { return value.whole<T>(lo, hi); },
          .write = [](const T& value) -> std::optional<Tree> { return Tree::word(std::to_string(value)); },
          .schema = Tree::map({{"type", Tree::quote("integer")},
                               {"minimum", Tree::word(std::to_string(lo))},
                               {"maximum", Tree::word(std::to_string(hi))}})};
}

}  // namespace

Tree vector_tree(const Vec3& v) {
  return Tree::list({Tree::number(v.x()), Tree::number(v.y()), Tree::number(v.z())});
}

Tree number_schema(Bounds bounds) {
  Tree plain = type("number");
  plain.set(bounds.above ? "exclusiveMinimum" : "minimum", Tree::number(bounds.lo));
  plain.set("maximum", Tree::number(bounds.hi));
  return Tree::map({{"anyOf", Tree::list({std::move(plain), reference("distribution")})}});
}

Form<double> number(Bounds bounds) {
  return {.read = [bounds](const Value& value) { return value.number(bounds); },
          .write = [](const double& value) -> std::optional<Tree> { return Tree::number(value); },
          .schema = number_schema(bounds)};
}

Form<Vec3> vector(Bounds each) {
  return {.read = [each](const Value& value) { return value.vector(each); },
          .write = vector_tree,
          .schema = Tree::map({{"type", Tree::quote("array")},
                               {"items", number_schema(each)},
                               {"minItems", Tree::word("3")},
                               {"maxItems", Tree::word("3")}})};
}

Form<bool> flag() {
  return {
      .read = [](const Value& value) { return value.flag(); },
      .write = [](const bool& value) -> std::optional<Tree> { return Tree::word(value ? "true" : "false"); },
      .schema = type("boolean")};
}

Form<std::string> text() {
  return {.read = [](const Value& value) { return value.text(); },
          .write = [](const std::string& value) -> std::optional<Tree> {
            if (value.empty()) return {};
            return Tree::quote(value);
          },
          .schema = type("string")};
}

Form<std::string> name() {
  Form<std::string> form = text();
  form.read = [](const Value& value) {
    std::string name = value.text();
    if (name.empty()) value.expected("a name");
    return name;
  };
  form.schema.set("minLength", Tree::word("1"));
  return form;
}

Form<std::uint64_t> seed() { return whole<std::uint64_t>(); }
Form<std::uint32_t> identifier() { return whole<std::uint32_t>(); }
Form<std::int32_t> integer() { return whole<std::int32_t>(); }
Form<std::int32_t> integer(std::int32_t lo, std::int32_t hi) { return whole(lo, hi); }

namespace {

/// One value, or a list of mappings as flat values: its length, then `key[0].x_m` and so on.
void read_param(const Value& value, const std::string& key, const Location& where, Choice& choice) {
  const auto add = [&](std::string name, ParamValue param, const Location& at) {
    choice.params.emplace_back(std::move(name), std::move(param));
    choice.param_where.push_back(at);
  };
  if (!value.tree().is_list()) {
    add(key, value.param(), where);
    return;
  }
  add(key, static_cast<double>(value.tree().items.size()), where);
  for (std::size_t i = 0; i < value.tree().items.size(); ++i) {
    const Value item = value.entry(i);
    if (!item.tree().is_map()) item.expected("a mapping of parameters");
    for (std::size_t k = 0; k < item.tree().keys.size(); ++k) {
      add(fmt::format("{}[{}].{}", key, i, item.tree().keys[k]), item.entry(k).param(),
          item.tree().where_of(k).location());
    }
  }
}

Tree param_tree(const ParamValue& value) {
  if (const double* real = std::get_if<double>(&value)) return Tree::number(*real);
  if (const bool* on = std::get_if<bool>(&value)) return Tree::word(*on ? "true" : "false");
  return Tree::quote(std::get<std::string>(value));
}

/// The list whose length is params[at], from the items that follow; `at` moves to the last of them.
Tree list_tree(const ParamValues& params, std::size_t& at) {
  const std::string prefix = params[at].first + "[";
  Tree list = Tree::list(
      std::vector<Tree>(static_cast<std::size_t>(std::get<double>(params[at].second)), Tree::map()));
  while (at + 1 < params.size() && params[at + 1].first.starts_with(prefix)) {
    const auto& [name, value] = params[++at];
    const std::size_t index = std::stoul(name.substr(prefix.size()));
    if (index < list.items.size()) list.items[index].set(name.substr(name.find("].") + 2), param_tree(value));
  }
  return list;
}

}  // namespace

Choice read_choice(const Value& value, std::string_view name_key, Needed needed,
                   const std::vector<std::string_view>& except) {
  Choice choice{.path = value.path(), .where = value.tree().where.location()};
  if (value.tree().is_scalar()) {
    choice.name = name().read(value);
    return choice;
  }
  if (!value.tree().is_map())
    value.expected("a name, or a mapping of " + std::string(name_key) + " and parameters");

  for (std::size_t i = 0; i < value.tree().keys.size(); ++i) {
    const std::string& key = value.tree().keys[i];
    if (key == name_key) {
      choice.name = name().read(value.entry(i));
      choice.where = value.tree().items[i].where.location();
    } else if (std::ranges::find(except, key) == except.end()) {
      read_param(value.entry(i), key, value.tree().where_of(i).location(), choice);
    }
  }
  if (choice.name.empty() && needed == Needed::yes && !value.reading().partial) {
    value.refuse("the key " + std::string(name_key) + " is missing");
  }
  return choice;
}

ParamValues read_params(const Value& value) {
  value.expect_map("parameters and their values");
  Choice choice;
  for (std::size_t i = 0; i < value.tree().keys.size(); ++i)
    read_param(value.entry(i), value.tree().keys[i], {}, choice);
  return std::move(choice.params);
}

Tree write_choice(const Choice& choice, std::string_view name_key) {
  if (choice.params.empty()) return Tree::quote(choice.name);
  Tree map = Tree::map();
  if (!choice.name.empty()) map.set(name_key, Tree::quote(choice.name));
  for (std::size_t i = 0; i < choice.params.size(); ++i) {
    const std::string key = choice.params[i].first;
    const bool list = i + 1 < choice.params.size() && choice.params[i + 1].first.starts_with(key + "[");
    map.set(key, list ? list_tree(choice.params, i) : param_tree(choice.params[i].second));
  }
  return map;
}

Form<Choice> choice(std::string_view name_key, Needed needed) {
  const std::string named{name_key};
  Tree mapping = Tree::map({{"type", Tree::quote("object")},
                            {"properties", Tree::map({{named, name().schema}})},
                            {"additionalProperties", reference("parameter")}});
  return {.read = [named, needed](const Value& value) { return read_choice(value, named, needed); },
          .write = [named](const Choice& chosen) -> std::optional<Tree> {
            if (chosen.name.empty() && chosen.params.empty()) return {};
            return write_choice(chosen, named);
          },
          .schema = Tree::map({{"anyOf", Tree::list({name().schema, std::move(mapping)})}})};
}

Form<Choice> choice_unless(std::string_view usual, std::string_view name_key) {
  Form<Choice> form = choice(name_key, Needed::yes);
  form.write = [usual = std::string(usual), write = form.write](const Choice& chosen) {
    return chosen.name == usual && chosen.params.empty() ? std::nullopt : write(chosen);
  };
  return form;
}

}  // namespace fairway::yaml
