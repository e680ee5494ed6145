// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/core/names.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/scenario/value.hpp"

namespace fairway::yaml {

/// How one kind of value is read, written and described to an editor. A value that is not to be
/// written, because its absence says the same, is written as nothing.
template <class T>
struct Form {
  std::function<T(const Value&)> read;
  std::function<std::optional<Tree>(const T&)> write;
  Tree schema;  ///< JSON schema
};

enum class Needed { no, yes };

/// One key of a mapping that describes an Owner. Said once: the loader, the writer, the suggestion
/// for a misspelt key and the published schema all read it here.
template <class Owner>
struct Key {
  std::string name;
  std::string meaning;
  Needed needed{Needed::no};
  std::function<void(const Value&, Owner&)> read;
  std::function<std::optional<Tree>(const Owner&)> write;
  Tree schema;
};

template <class Owner>
using Block = std::vector<Key<Owner>>;

/// All keys of some blocks.
template <class Owner>
Block<Owner> joined(std::initializer_list<Block<Owner>> blocks) {
  Block<Owner> all;
  for (const Block<Owner>& block : blocks) all.insert(all.end(), block.begin(), block.end());
  return all;
}

namespace detail {

/// `meaning` with what is usual in place of "{}".
std::string with_default(std::string_view meaning, const std::function<std::optional<Tree>()>& usual);

}  // namespace detail

/// "Default {}." in `meaning` tells the value that an Owner has from its declaration.
template <class Owner, class T>
Key<Owner> key(std::string_view name, T Owner::*member, const Form<T>& form, std::string_view meaning,
               Needed needed = Needed::no) {
  return {
      .name = std::string(name),
      .meaning = detail::with_default(meaning, [&] { return form.write(Owner{}.*member); }),
      .needed = needed,
      .read = [member, read = form.read](const Value& value, Owner& owner) { owner.*member = read(value); },
      .write = [member, write = form.write](const Owner& owner) { return write(owner.*member); },
      .schema = form.schema};
}

/// The same of what an Owner may have in common with others.
template <class Owner, class T>
Key<Owner> key(std::string_view name, Shared<T> Owner::*member, const Form<T>& form, std::string_view meaning,
               Needed needed = Needed::no) {
  const Form<Shared<T>> shared{
      .read = form.read,
      .write = [write = form.write](const Shared<T>& value) { return write(*value); },
      .schema = form.schema};
  return key<Owner, Shared<T>>(name, member, shared, meaning, needed);
}

namespace detail {

/// The checks of a mapping against its table: it is one, it has no other keys, no quantity in two
/// units, and none missing. `names` and `needed` are the table's.
void check_keys(const Value& value, const std::vector<std::string_view>& names,
                const std::vector<std::string_view>& needed);

/// A JSON schema's object of the given properties.
Tree object_schema(const std::vector<std::pair<std::string, Tree>>& properties,
                   const std::vector<std::string_view>& needed);
Tree described(Tree schema, std::string_view meaning);

template <class Owner>
std::vector<std::string_view> names_of(const Block<Owner>& block, bool only_needed) {
  std::vector<std::string_view> names;
  for (const Key<Owner>& key : block) {
    if (!only_needed || key.needed == Needed::yes) names.push_back(key.name);
  }
  return names;
}

}  // namespace detail

/// Reads a mapping into `owner`; what is not written keeps the value it has.
template <class Owner>
void read_block(const Value& value, const Block<Owner>& block, Owner& owner) {
  detail::check_keys(value, detail::names_of(block, false), detail::names_of(block, true));
  for (const Key<Owner>& key : block) {
    if (const std::optional<Value> given = value.find(key.name)) key.read(*given, owner);
  }
}

/// Nothing if none of the keys has anything to say.
template <class Owner>
std::optional<Tree> write_block(const Block<Owner>& block, const Owner& owner) {
  Tree map = Tree::map();
  for (const Key<Owner>& key : block) {
    if (std::optional<Tree> tree = key.write(owner)) map.set(key.name, std::move(*tree));
  }
  return map.items.empty() ? std::nullopt : std::optional{std::move(map)};
}

template <class Owner>
Tree schema_of(const Block<Owner>& block) {
  std::vector<std::pair<std::string, Tree>> properties;
  for (const Key<Owner>& key : block)
    properties.emplace_back(key.name, detail::described(key.schema, key.meaning));
  return detail::object_schema(properties, detail::names_of(block, true));
}

/// A mapping as a value of its own.
template <class T>
Form<T> block_form(const Block<T>& block) {
  return {.read =
              [block](const Value& value) {
                T read{};
                read_block(value, block, read);
                return read;
              },
          .write = [block](const T& value) { return write_block(block, value); },
          .schema = schema_of(block)};
}

/// A mapping that only groups some of the owner's members: `start: {…}`.
template <class Owner>
Key<Owner> group(std::string_view name, const Block<Owner>& block, std::string_view meaning,
                 Needed needed = Needed::no) {
  return {.name = std::string(name),
          .meaning = std::string(meaning),
          .needed = needed,
          .read = [block](const Value& value, Owner& owner) { read_block(value, block, owner); },
          .write = [block](const Owner& owner) { return write_block(block, owner); },
          .schema = schema_of(block)};
}

template <class T>
Form<std::vector<T>> list_of(const Form<T>& form, std::string_view of) {
  return {.read =
              [form, of = std::string(of)](const Value& value) {
                value.expect_list(of);
                std::vector<T> list;
                for (std::size_t i = 0; i < value.tree().items.size(); ++i)
                  list.push_back(form.read(value.entry(i)));
                return list;
              },
          .write = [form](const std::vector<T>& list) -> std::optional<Tree> {
            if (list.empty()) return {};
            Tree tree = Tree::list();
            for (const T& item : list) tree.items.push_back(form.write(item).value_or(Tree::map()));
            return tree;
          },
          .schema = Tree::map({{"type", Tree::quote("array")}, {"items", form.schema}})};
}

/// The same form, `usual` standing for "not given".
template <class T>
Form<T> unless(const std::type_identity_t<T>& usual, Form<T> form) {
  form.write = [usual, write = form.write](const T& value) -> std::optional<Tree> {
    return value == usual ? std::nullopt : write(value);
  };
  return form;
}

/// A number, or a distribution to draw it from.
Form<double> number(Bounds bounds);
Form<Vec3> vector(Bounds each);
Form<bool> flag();
Form<std::string> text();
/// Text that says something.
Form<std::string> name();
Form<std::uint64_t> seed();
Form<std::uint32_t> identifier();
Form<std::int32_t> integer();
/// From `lo` to `hi`.
Form<std::int32_t> integer(std::int32_t lo, std::int32_t hi);

/// One of the names of an enumeration. `of` is what it is called where the name is not known.
template <class E>
Form<E> enumeration(std::string_view of) {
  constexpr auto& names = EnumNames<E>::names;
  Tree listed = Tree::list();
  for (const std::string_view name : names) listed.items.push_back(Tree::quote(name));
  return {.read =
              [of = std::string(of)](const Value& value) {
                const std::string text = value.text();
                const std::vector<std::string_view> known(names.begin(), names.end());
                const auto found = std::ranges::find(known, text);
                if (found == known.end()) value.refuse("unknown " + of + suggestion(text, known));
                return static_cast<E>(found - known.begin());
              },
          .write = [](const E& value) -> std::optional<Tree> { return Tree::quote(enum_name(value)); },
          .schema = Tree::map({{"enum", std::move(listed)}})};
}

/// Something chosen by name, with parameters of its own: `orca3d`, or a mapping in which `name_key`
/// holds the name and all other keys are parameters.
Form<Choice> choice(std::string_view name_key, Needed name);
/// The same, `usual` without parameters standing for "not given".
Form<Choice> choice_unless(std::string_view usual, std::string_view name_key);
/// The same from a mapping whose keys in `except` are not the choice's.
Choice read_choice(const Value& value, std::string_view name_key, Needed name,
                   const std::vector<std::string_view>& except = {});
Tree write_choice(const Choice& choice, std::string_view name_key);
/// The parameters in a mapping, a list of mappings as flat values.
ParamValues read_params(const Value& value);

/// [n, e, d] as it is written.
Tree vector_tree(const Vec3& v);

/// The JSON schema of a number, referring to `#/$defs/distribution`.
Tree number_schema(Bounds bounds);

}  // namespace fairway::yaml
