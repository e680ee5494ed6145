// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/scenario/block.hpp"

namespace fairway::yaml {

/// One kind of something that is written as `{kind: {its keys}}`: `sphere: {…}`, `transit: {…}`.
template <class T>
struct Kind {
  std::string name;
  std::string meaning;
  Block<T> block;
  std::function<void(const Value&, const T&)>
      check;  ///< throws if the keys contradict each other; may be empty
};

/// In the order of the enumeration `T::kind`.
template <class T>
using Kinds = std::vector<Kind<T>>;

template <class T>
T read_tagged(const Value& value, const Kinds<T>& kinds) {
  std::vector<std::string_view> names;
  for (const Kind<T>& kind : kinds) names.push_back(kind.name);
  const Tree& tree = value.tree();
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  if (tree.is_map() && tree.items.size() > 1)
    value.refuse("expected a mapping with one key of " + list + ", got one with " +
                 std::to_string(tree.items.size()) + ", such as " + shown(tree.keys[0]) + " and " +
                 shown(tree.keys[1]));
  if (!tree.is_map() || tree.items.size() != 1) value.expected("a mapping with one key of " + list);

  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (tree.keys[0] != kinds[i].name) continue;
    T read{};
    read.kind = static_cast<decltype(T::kind)>(i);
    read_block(value.entry(0), kinds[i].block, read);
    if (kinds[i].check && !value.reading().partial) kinds[i].check(value.entry(0), read);
    return read;
  }
  value.refuse_key(0, "unknown kind" + suggestion(std::string_view(tree.keys[0]).substr(0, 64), names));
}

template <class T>
Tree write_tagged(const T& item, const Kinds<T>& kinds) {
  const Kind<T>& kind = kinds[static_cast<std::size_t>(item.kind)];
  return Tree::map({{kind.name, write_block(kind.block, item).value_or(Tree::map())}});
}

/// One schema for each kind.
template <class T>
std::vector<Tree> tagged_schemas(const Kinds<T>& kinds) {
  std::vector<Tree> schemas;
  for (const Kind<T>& kind : kinds) {
    schemas.push_back(detail::object_schema(
        {{kind.name, detail::described(schema_of(kind.block), kind.meaning)}}, {kind.name}));
  }
  return schemas;
}

}  // namespace fairway::yaml
