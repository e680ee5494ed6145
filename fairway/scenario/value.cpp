// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "fairway/core/names.hpp"
#include "fairway/core/text.hpp"

namespace fairway::yaml {
namespace {

/// A number as written without quotes, finite or not; nothing if it is not one.
std::optional<double> parsed_number(const Tree& tree) {
  if (!tree.is_scalar() || !tree.plain) return {};
  std::string_view text = tree.text;
  for (const std::string_view infinite : {".inf", "+.inf", "-.inf", ".Inf", ".nan", ".NaN"}) {
    if (text == infinite) return std::numeric_limits<double>::infinity();
  }
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (stop != text.data() + text.size() || error == std::errc::invalid_argument) return {};
  return error == std::errc{} ? value : std::numeric_limits<double>::infinity();
}

std::string what_is_there(const Tree& tree) {
  switch (tree.kind) {
    case Tree::Kind::null:
      return "nothing";
    case Tree::Kind::list:
      return "a list of " + std::to_string(tree.items.size());
    case Tree::Kind::map:
      return tree.items.empty() ? "an empty mapping" : "a mapping with the key " + shown(tree.keys.front());
    case Tree::Kind::scalar:
      break;
  }
  return tree.plain ? shown(tree.text) : "the text \"" + shown(tree.text) + "\"";
}

constexpr std::string_view hint_of_vector = "three numbers [n, e, d]";

}  // namespace

std::string Bounds::text() const {
  return fmt::format("{}{}, {}]", above ? '(' : '[', number_text(lo), number_text(hi));
}

void refuse_at(const Where& where, const std::string& path, const std::string& message) {
  const Location location = where.location();
  const bool said = location.file.starts_with(override_prefix) &&
                    std::string_view(location.file).substr(override_prefix.size()) == path;
  throw InputError(location, said ? "" : path, message);
}

void Value::refuse(const std::string& message) const { refuse_at(tree_->where, path_, message); }

void Value::refuse_key(std::size_t i, const std::string& message) const {
  const std::string& key = tree_->keys[i];
  refuse_at(tree_->where_of(i), path_.empty() ? shown(key) : path_ + "." + shown(key), message);
}

void Value::expected(const std::string& what) const {
  refuse("expected " + what + ", got " + what_is_there(*tree_));
}

Value Value::entry(std::size_t i) const {
  const Tree& item = tree_->items[i];
  if (tree_->is_list()) return {item, path_ + "[" + std::to_string(i) + "]", *reading_};
  return {item, path_.empty() ? tree_->keys[i] : path_ + "." + tree_->keys[i], *reading_};
}

std::optional<Value> Value::find(std::string_view key) const {
  const auto found = std::ranges::find(tree_->keys, key);
  if (found == tree_->keys.end()) return {};
  return entry(static_cast<std::size_t>(found - tree_->keys.begin()));
}

Value Value::at(std::string_view key) const {
  const std::optional<Value> found = find(key);
  if (!found) refuse("the key " + std::string(key) + " is missing");
  return *found;
}

void Value::expect_list(std::string_view of) const {
  if (!tree_->is_list() && !tree_->is_null()) expected("a list of " + std::string(of));
}

void Value::expect_map(std::string_view of) const {
  if (!tree_->is_map() && !tree_->is_null()) expected("a mapping: " + std::string(of));
}

void Value::expect_keys(const std::vector<std::string_view>& known) const {
  if (!tree_->is_map()) expect_map(fmt::format("{}", fmt::join(known, ", ")));
  for (std::size_t i = 0; i < tree_->keys.size(); ++i) {
    const std::string& key = tree_->keys[i];
    if (std::ranges::find(known, key) == known.end())
      refuse_key(i, "unknown key" + suggestion(std::string_view(key).substr(0, 64), known));
  }
}

double Value::number(Bounds bounds) const {
  if (tree_->is_map() && reading_->rng) return draw(bounds);
  const std::optional<double> value = parsed_number(*tree_);
  if (!value) expected("a number in " + bounds.text());
  if (!std::isfinite(*value)) expected("a finite number in " + bounds.text());
  if (!bounds.holds(*value)) expected("a number in " + bounds.text());
  return *value;
}

double Value::draw(Bounds bounds) const {
  const bool uniform = tree_->keys.size() == 1 && tree_->keys[0] == "uniform";
  const bool normal = tree_->keys.size() == 1 && tree_->keys[0] == "normal";
  if (!uniform && !normal) expected("a number, {uniform: [lo, hi]} or {normal: [mean, deviation]}");

  const Value pair = entry(0);
  if (!pair.tree().is_list() || pair.tree().items.size() != 2) {
    pair.expected(uniform ? "two numbers [lo, hi]" : "two numbers [mean, deviation]");
  }
  const double first = pair.entry(0).number(bounds);
  Rng rng = reading_->rng->stream(path_);

  if (uniform) {
    const double hi = pair.entry(1).number(bounds);
    if (first > hi) pair.refuse("lo is " + number_text(first) + ", above hi, " + number_text(hi));
    return rng.uniform(first, hi);
  }

  // the part of the bell that lies in the range
  const double deviation = pair.entry(1).number(from_to(0.0, bounds.hi - bounds.lo));
  for (int i = 0; i < 1000; ++i) {
    const double value = first + deviation * rng.normal();
    if (bounds.holds(value)) return value;
  }
  pair.refuse("none of 1000 draws lies in " + bounds.text());
}

double Value::item(std::size_t i, Bounds bounds) const {
  const std::optional<double> value = parsed_number(tree_->items[i]);
  // its path is put together where it is drawn or refused
  return value && std::isfinite(*value) && bounds.holds(*value) ? *value : entry(i).number(bounds);
}

Vec3 Value::vector(Bounds each) const {
  if (!tree_->is_list() || tree_->items.size() != 3) expected(std::string(hint_of_vector));
  return {item(0, each), item(1, each), item(2, each)};
}

Vec3 Value::vertex(Bounds each) const {
  if (!tree_->is_list() || tree_->items.size() != 2) return vector(each);
  return {item(0, each), item(1, each), 0.0};
}

bool Value::flag() const {
  if (tree_->is_scalar() && tree_->plain && tree_->text == "true") return true;
  if (tree_->is_scalar() && tree_->plain && tree_->text == "false") return false;
  expected("true or false");
}

std::string Value::text() const {
  if (!tree_->is_scalar()) expected("text");
  return tree_->text;
}

ParamValue Value::param() const {
  if (tree_->is_map()) return number(from_to(-1e100, 1e100));
  if (!tree_->is_scalar()) expected("a number, true, false or a word");
  if (!tree_->plain) return tree_->text;
  if (const std::optional<double> value = parsed_number(*tree_)) {
    if (!std::isfinite(*value)) expected("a finite number; leave the key out for its default");
    return *value;
  }
  if (tree_->text == "true" || tree_->text == "false") return tree_->text == "true";
  return tree_->text;
}

template <std::integral T>
T Value::whole(T lo, T hi) const {
  const auto refuse_number = [&] { expected(fmt::format("a whole number in [{}, {}]", lo, hi)); };
  if (!tree_->is_scalar() || !tree_->plain) refuse_number();
  const char* begin = tree_->text.data();
  const char* end = begin + tree_->text.size();
  T value{};
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end || value < lo || value > hi) refuse_number();
  return value;
}

template std::int32_t Value::whole(std::int32_t, std::int32_t) const;
template std::uint32_t Value::whole(std::uint32_t, std::uint32_t) const;
template std::uint64_t Value::whole(std::uint64_t, std::uint64_t) const;

}  // namespace fairway::yaml
