// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/names.hpp"

#include <algorithm>
#include <numeric>

namespace fairway {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

/// A missing or wrong unit suffix is the commonest slip, so a shared stem counts as near.
bool shares_stem(std::string_view typed, std::string_view name) {
  const auto stem = [](std::string_view s) { return s.substr(0, s.rfind('_')); };
  return name.starts_with(typed) || (stem(typed).size() >= 4 && stem(typed) == stem(name));
}

}  // namespace

std::string_view nearest_name(std::string_view typed, const std::vector<std::string_view>& known) {
  if (typed.empty()) return {};
  std::string_view best;
  std::size_t best_distance = typed.size() / 3 + 1;
  for (const std::string_view name : known) {
    const std::size_t distance = shares_stem(typed, name) ? 1 : edit_distance(typed, name);
    if (distance < best_distance || (distance == best_distance && best.empty())) {
      best = name;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(std::string_view typed, const std::vector<std::string_view>& known) {
  if (const std::string_view name = nearest_name(typed, known); !name.empty()) {
    return "; did you mean " + std::string(name) + "?";
  }
  std::string list;
  for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string(name);
  return list.empty() ? "" : "; known: " + list;
}

}  // namespace fairway
