// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/core/error.hpp"

namespace fairway::yaml {

/// Where a piece of a tree was written. Cheap to copy: the source's name is shared.
struct Where {
  std::shared_ptr<const std::string> source;
  int line{};
  int column{};

  Location location() const { return {source ? *source : "", line, column}; }
};

/// A YAML document as a plain value: what was written and where, nothing interpreted. Copies are
/// independent of each other, so that overrides and defaults can be applied without side effects.
struct Tree {
  enum class Kind { null, scalar, list, map };

  Kind kind{Kind::null};
  bool plain{true};               ///< a scalar without quotes: it may be a number or a switch
  std::string text;               ///< of a scalar
  std::vector<std::string> keys;  ///< of a map, as many as items
  std::vector<Where> key_where;   ///< likewise; empty if built by a program
  std::vector<Tree> items;        ///< of a list or map
  Where where;

  static Tree word(std::string_view text) {
    return {.kind = Kind::scalar, .plain = true, .text = std::string(text)};
  }
  static Tree quote(std::string_view text) {
    return {.kind = Kind::scalar, .plain = false, .text = std::string(text)};
  }
  static Tree number(double value);
  static Tree list(std::vector<Tree> items = {}) { return {.kind = Kind::list, .items = std::move(items)}; }
  static Tree map(const std::vector<std::pair<std::string, Tree>>& entries = {});

  bool is_null() const { return kind == Kind::null; }
  bool is_scalar() const { return kind == Kind::scalar; }
  bool is_list() const { return kind == Kind::list; }
  bool is_map() const { return kind == Kind::map; }

  /// The value of a map's key, or null. O(keys).
  const Tree* find(std::string_view key) const;
  Tree* find(std::string_view key) { return const_cast<Tree*>(std::as_const(*this).find(key)); }

  /// Appends to a map, or replaces the value that is there.
  Tree& set(std::string_view key, Tree value, const Where& where_key = {});

  /// Where a map's i-th key was written; where the map was, if nobody knows.
  const Where& where_of(std::size_t i) const { return i < key_where.size() ? key_where[i] : where; }

  /// This node and all below it.
  std::size_t size() const;
};

/// What a document may hold. A scenario of a hundred thousand vehicles, written out, needs half of it.
inline constexpr std::size_t max_document_bytes = 160 << 20;
/// Where aliases are written out; as many as there are bytes, if those are more.
inline constexpr std::size_t max_tree_nodes = 1'000'000;
inline constexpr std::size_t max_filled_nodes = 5'000'000;  ///< of defaults, for all vehicles together
inline constexpr std::size_t max_tree_depth = 64;
inline constexpr std::size_t max_key_bytes = 100;  ///< YAML itself ends a key, escapes and all, at 1024

/// What is in a text file; nothing where it cannot be read. Of one that is longer than a document may be, a
/// byte more than that.
std::optional<std::string> document_in(const std::string& file);

/// The one document in `yaml`. Anchors and aliases are written out. Throws InputError with line and
/// column: bad syntax, a key given twice, tags, more than one document, or beyond the bounds above.
/// With `located` false (a value from the command line) lines and columns are left out.
Tree parse_tree(std::string_view yaml, const std::string& source, bool located = true);

/// `tree` as YAML that parse_tree() reads back to the same tree.
std::string yaml_text(const Tree& tree);

/// `tree` as JSON, indented by two.
std::string json_text(const Tree& tree);

/// `text` fit for one line of an error message: no control characters, at most 60 bytes.
std::string shown(std::string_view text);

}  // namespace fairway::yaml
