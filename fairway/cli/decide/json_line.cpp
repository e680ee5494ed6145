// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/json_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fairway/core/text.hpp"

namespace fairway {
namespace {

constexpr std::size_t max_depth = 16;

/// At most 60 bytes of what was written, fit for a line of an error message.
std::string shown(std::string_view text) {
  std::string line{text.substr(0, 60)};
  std::ranges::replace_if(
      line, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
  return text.size() > line.size() ? line + "..." : line;
}

[[noreturn]] void refuse_line(std::size_t line, std::string_view message) {
  throw InputError(fmt::format("line {}: {}", line, message));
}

/// Builds the value from nlohmann's events, as its own tree would keep the last of two equal keys.
class Builder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Builder(std::size_t line) : line_{line} { open_.reserve(max_depth); }
  Json take() { return std::move(root_); }

  bool null() override { return add({}); }
  bool boolean(bool on) override { return add({.kind = Json::Kind::boolean, .on = on}); }
  bool number_integer(number_integer_t value) override {
    return add_number(static_cast<double>(value), true);
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add_number(static_cast<double>(value), true);
  }
  bool number_float(number_float_t value, const string_t&) override { return add_number(value, false); }
  bool string(string_t& text) override { return add({.kind = Json::Kind::text, .text = std::move(text)}); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Json::Kind::object); }
  bool start_array(std::size_t) override { return open(Json::Kind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    std::vector<std::string>& keys = open_.back().keys;
    if (std::ranges::find(keys, name) != keys.end()) refuse_line(line_, shown(name) + ": given twice");
    if (keys.size() >= 100) refuse_line(line_, shown(name) + ": more than 100 keys");
    keys.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception&) override {
    refuse_line(line_, fmt::format("not JSON at column {}", position));
  }

 private:
  bool add_number(double value, bool whole) {
    return add({.kind = Json::Kind::number, .whole = whole, .number = value});
  }

  bool open(Json::Kind kind) {
    if (open_.size() >= max_depth) refuse_line(line_, fmt::format("nested deeper than {} levels", max_depth));
    Json& opened = open_.emplace_back();
    opened.kind = kind;
    // most lists are three numbers, most objects have four to seven keys
    opened.items.reserve(kind == Json::Kind::list ? 3 : 7);
    if (kind == Json::Kind::object) opened.keys.reserve(7);
    return true;
  }

  bool close() {
    Json done = std::move(open_.back());
    open_.pop_back();
    return add(std::move(done));
  }

  bool add(Json value) {
    (open_.empty() ? root_ : open_.back().items.emplace_back()) = std::move(value);
    return true;
  }

  std::size_t line_;
  Json root_;
  std::vector<Json> open_;
};

}  // namespace

Json parse_json(std::string_view text, std::size_t line) {
  Builder builder{line};
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

std::string JsonAt::path() const {
  if (parent_ == nullptr) return "";
  const std::string above = parent_->path();
  if (key_.empty()) return fmt::format("{}[{}]", above, index_);
  return above.empty() ? std::string(key_) : fmt::format("{}.{}", above, key_);
}

void JsonAt::refuse(std::string_view message) const {
  const std::string where = path();
  refuse_line(line_, where.empty() ? std::string(message) : fmt::format("{}: {}", where, message));
}

void JsonAt::expect_keys(std::span<const std::string_view> known) const {
  if (value_->kind != Json::Kind::object) refuse("expected an object");
  for (const std::string& key : value_->keys) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string where = path();
    const std::string name = where.empty() ? shown(key) : fmt::format("{}.{}", where, shown(key));
    refuse_line(line_,
                fmt::format("{}: unknown key{}", name,
                            suggestion(std::string_view(key).substr(0, 64), {known.begin(), known.end()})));
  }
}

std::optional<JsonAt> JsonAt::find(std::string_view key) const {
  const auto found = std::ranges::find(value_->keys, key);
  if (found == value_->keys.end()) return {};
  return JsonAt{*this, value_->items[static_cast<std::size_t>(found - value_->keys.begin())], *found, 0};
}

JsonAt JsonAt::at(std::string_view key) const {
  const std::optional<JsonAt> found = find(key);
  if (!found) refuse(fmt::format("the key {} is missing", key));
  return *found;
}

std::size_t JsonAt::size() const {
  if (value_->kind != Json::Kind::list) refuse("expected a list");
  return value_->items.size();
}

double JsonAt::number() const {
  if (value_->kind != Json::Kind::number || !std::isfinite(value_->number)) refuse("expected a number");
  return value_->number;
}

double JsonAt::not_negative() const {
  if (number() < 0.0)
    refuse(fmt::format("expected a number that is not negative, got {}", number_text(value_->number)));
  return value_->number;
}

Vec3 JsonAt::vector() const {
  const std::vector<Json>& items = value_->items;
  const auto is_number = [](const Json& json) {
    return json.kind == Json::Kind::number && std::isfinite(json.number);
  };
  if (value_->kind != Json::Kind::list || items.size() != 3 || !std::ranges::all_of(items, is_number)) {
    refuse("expected three numbers");
  }
  return {items[0].number, items[1].number, items[2].number};
}

const std::string& JsonAt::text() const {
  if (value_->kind != Json::Kind::text) refuse("expected text");
  return value_->text;
}

double JsonAt::whole(double lo, double hi) const {
  const bool fits =
      value_->kind == Json::Kind::number && value_->whole && value_->number >= lo && value_->number <= hi;
  if (!fits) refuse(fmt::format("expected a whole number in [{:.0f}, {:.0f}]", lo, hi));
  return value_->number;
}

bool JsonAt::flag() const {
  if (value_->kind != Json::Kind::boolean) refuse("expected true or false");
  return value_->on;
}

ParamValue JsonAt::param() const {
  if (value_->kind == Json::Kind::boolean) return value_->on;
  if (value_->kind == Json::Kind::text) return value_->text;
  if (value_->kind != Json::Kind::number) refuse("expected a number, true, false or text");
  return number();
}

}  // namespace fairway
