// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/core/params.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// A JSON value as written; numbers are finite.
struct Json {
  enum class Kind { null, boolean, number, text, list, object };

  Kind kind{Kind::null};
  bool on{};
  bool whole{};  ///< the number was written without fraction and exponent
  double number{};
  std::string text;
  std::vector<std::string> keys;  ///< of an object, as many as items; each once
  std::vector<Json> items;
};

/// Throws InputError: "line 17: not JSON at column 5", a key given twice, nested too deep.
Json parse_json(std::string_view text, std::size_t line);

/// A place in a line's JSON. It reads a value, or throws InputError naming line and path:
/// "line 17: tracks[0].position: expected three numbers". The path is put together only then.
class JsonAt {
 public:
  JsonAt(const Json& value, std::size_t line) : value_{&value}, line_{line} {}

  /// Throws unless this is an object with no other keys than these.
  void expect_keys(std::span<const std::string_view> known) const;
  void expect_keys(std::initializer_list<std::string_view> known) const {
    expect_keys(std::span{known.begin(), known.size()});
  }

  /// The value of an object's key; throws if it is missing.
  JsonAt at(std::string_view key) const;
  std::optional<JsonAt> find(std::string_view key) const;

  /// A list's length and items.
  std::size_t size() const;
  JsonAt item(std::size_t i) const { return {*this, value_->items[i], {}, i}; }

  double number() const;
  double not_negative() const;
  Vec3 vector() const;
  const std::string& text() const;
  /// A whole number in [lo, hi], both exact in a double.
  double whole(double lo, double hi) const;
  bool flag() const;
  ParamValue param() const;

  const Json& value() const { return *value_; }
  const std::vector<std::string>& keys() const { return value_->keys; }

  [[noreturn]] void refuse(std::string_view message) const;

 private:
  JsonAt(const JsonAt& parent, const Json& value, std::string_view key, std::size_t index)
      : value_{&value}, parent_{&parent}, key_{key}, index_{index}, line_{parent.line_} {}

  std::string path() const;

  const Json* value_;
  const JsonAt* parent_{};  ///< outlives its children: both live in one function's scope
  std::string_view key_;    ///< of the parent's object; empty in a list
  std::size_t index_{};
  std::size_t line_;
};

}  // namespace fairway
