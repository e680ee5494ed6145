// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "fairway/core/text.hpp"
#include "fairway/scenario/tree.hpp"

namespace fairway::yaml {
namespace {

std::string in_quotes(std::string_view text) {
  std::string line = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      line += '\\';
      line += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      line += fmt::format("\\u{:04x}", static_cast<unsigned>(byte));
    } else {
      line += c;
    }
  }
  return line + "\"";
}

/// True if YAML reads these characters, unquoted, as this text and nothing else.
bool is_plain_word(std::string_view text) {
  constexpr std::array<std::string_view, 4> null{"null", "Null", "NULL", "~"};
  if (text.empty() || !std::holds_alternative<std::string>(parse_value(text)) ||
      std::ranges::count(null, text) > 0)
    return false;
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return std::isalpha(static_cast<unsigned char>(text.front())) != 0 && is_word(text.back()) &&
         std::ranges::all_of(
             text, [&](char c) { return is_word(c) || c == ' ' || c == '-' || c == '+' || c == '.'; });
}

std::string key_text(std::string_view key) { return is_plain_word(key) ? std::string(key) : in_quotes(key); }

std::string scalar_text(const Tree& tree) {
  if (tree.is_null()) return "null";
  return tree.plain || is_plain_word(tree.text) ? tree.text : in_quotes(tree.text);
}

bool is_leaf(const Tree& tree) { return tree.is_null() || tree.is_scalar() || tree.items.empty(); }

/// Lists of numbers, and lists of those, stay on one line.
bool fits_on_a_line(const Tree& tree) {
  return is_leaf(tree) || (tree.is_list() && std::ranges::all_of(tree.items, fits_on_a_line));
}

void append_flow(const Tree& tree, std::string& out) {
  if (tree.is_list()) {
    out += '[';
    for (std::size_t i = 0; i < tree.items.size(); ++i) {
      if (i > 0) out += ", ";
      append_flow(tree.items[i], out);
    }
    out += ']';
  } else if (tree.is_map()) {
    out += "{}";
  } else {
    out += scalar_text(tree);
  }
}

/// Writes the tree's lines; the first one continues the line that is open.
void append_block(const Tree& tree, std::size_t indent, std::string& out) {
  for (std::size_t i = 0; i < tree.items.size(); ++i) {
    if (i > 0) out.append(indent, ' ');
    out += tree.is_map() ? fmt::format("{}:", key_text(tree.keys[i])) : "-";
    const Tree& item = tree.items[i];
    if (fits_on_a_line(item)) {
      out += ' ';
      append_flow(item, out);
      out += '\n';
    } else if (tree.is_list()) {
      out += ' ';
      append_block(item, indent + 2, out);
    } else {
      out += '\n';
      out.append(indent + 2, ' ');
      append_block(item, indent + 2, out);
    }
  }
}

void append_json(const Tree& tree, std::size_t indent, std::string& out) {
  if (tree.is_null()) {
    out += "null";
  } else if (tree.is_scalar()) {
    out += tree.plain ? tree.text : in_quotes(tree.text);
  } else {
    const bool one_line = is_leaf(tree) || (tree.is_list() && std::ranges::all_of(tree.items, is_leaf));
    out += tree.is_map() ? '{' : '[';
    for (std::size_t i = 0; i < tree.items.size(); ++i) {
      if (i > 0) out += one_line ? ", " : ",";
      if (!one_line) out.append("\n").append(indent + 2, ' ');
      if (tree.is_map()) out.append(in_quotes(tree.keys[i])).append(": ");
      append_json(tree.items[i], indent + 2, out);
    }
    if (!one_line) out.append("\n").append(indent, ' ');
    out += tree.is_map() ? '}' : ']';
  }
}

}  // namespace

std::string yaml_text(const Tree& tree) {
  std::string out;
  if (fits_on_a_line(tree)) {
    append_flow(tree, out);
    return out + "\n";
  }
  append_block(tree, 0, out);
  return out;
}

std::string json_text(const Tree& tree) {
  std::string out;
  append_json(tree, 0, out);
  return out + "\n";
}

}  // namespace fairway::yaml
