// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/json_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fairway/core/text.hpp"

namespace fairway {
namespace {

using yaml::shown;
using yaml::Tree;

constexpr std::size_t max_depth = 16;

/// Builds the tree from nlohmann's events, as its own tree would keep the last of two equal keys.
class Builder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Builder(std::size_t line)
      : where_{.source = std::make_shared<const std::string>(fmt::format("line {}", line))} {
    open_.reserve(max_depth);
  }
  Tree take() { return std::move(root_); }

  bool null() override { return add(Tree::word("null")); }
  bool boolean(bool on) override { return add(Tree::word(on ? "true" : "false")); }
  bool number_integer(number_integer_t value) override { return add(Tree::word(std::to_string(value))); }
  bool number_unsigned(number_unsigned_t value) override { return add(Tree::word(std::to_string(value))); }
  bool number_float(number_float_t value, const string_t& text) override {
    // what rounds to zero is zero
    return add(value == 0.0 ? Tree::number(value) : Tree::word(text));
  }
  bool string(string_t& text) override { return add(Tree::quote(text)); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Tree::Kind::map); }
  bool start_array(std::size_t) override { return open(Tree::Kind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    std::vector<std::string>& keys = open_.back().keys;
    if (std::ranges::find(keys, name) != keys.end()) refuse(shown(name) + ": given twice");
    if (keys.size() >= 100) refuse(shown(name) + ": more than 100 keys");
    keys.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception&) override {
    refuse(fmt::format("not JSON at column {}", position));
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(where_.location(), "", message);
  }

  bool open(Tree::Kind kind) {
    if (open_.size() >= max_depth) refuse(fmt::format("nested deeper than {} levels", max_depth));
    Tree& opened = open_.emplace_back();
    opened.kind = kind;
    // most lists are three numbers, most objects have four to seven keys
    opened.items.reserve(kind == Tree::Kind::list ? 3 : 7);
    if (kind == Tree::Kind::map) opened.keys.reserve(7);
    return true;
  }

  bool close() {
    Tree done = std::move(open_.back());
    open_.pop_back();
    return add(std::move(done));
  }

  bool add(Tree value) {
    value.where = where_;
    (open_.empty() ? root_ : open_.back().items.emplace_back()) = std::move(value);
    return true;
  }

  yaml::Where where_;
  Tree root_;
  std::vector<Tree> open_;
};

}  // namespace

Tree parse_json(std::string_view text, std::size_t line) {
  Builder builder{line};
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace fairway
