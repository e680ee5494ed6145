// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/tree.hpp"

#include <algorithm>

#include "fairway/core/text.hpp"

namespace fairway::yaml {

Tree Tree::number(double value) { return word(number_text(value)); }

Tree Tree::map(const std::vector<std::pair<std::string, Tree>>& entries) {
  Tree tree{.kind = Kind::map};
  for (const auto& [key, value] : entries) {
    tree.keys.push_back(key);
    tree.items.push_back(value);
  }
  return tree;
}

const Tree* Tree::find(std::string_view key) const {
  const auto found = std::ranges::find(keys, key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

Tree& Tree::set(std::string_view key, Tree value, const Where& where_key) {
  if (Tree* there = find(key)) return *there = std::move(value);
  key_where.resize(keys.size(), where);
  keys.emplace_back(key);
  key_where.push_back(where_key);
  return items.emplace_back(std::move(value));
}

std::size_t Tree::size() const {
  std::size_t nodes = 1;
  for (const Tree& item : items) nodes += item.size();
  return nodes;
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string line;
  for (const char c : text.substr(0, longest))
    line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  // never half a UTF-8 character
  if (text.size() > longest) {
    while (!line.empty() && (static_cast<unsigned char>(text[line.size()]) & 0xC0U) == 0x80U) line.pop_back();
    line += "...";
  }
  return line;
}

}  // namespace fairway::yaml
