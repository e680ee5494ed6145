// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/labels.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace fairway {
namespace {

std::optional<double> finite_number(std::string_view text) {
  double value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return {};
  return value;
}

void add_value(LabelValues& known, const std::string& name, const std::string& value) {
  auto label = std::ranges::find(known, name, &LabelValues::value_type::first);
  if (label == known.end()) label = known.insert(label, {name, {}});
  if (std::ranges::find(label->second, value) == label->second.end()) label->second.push_back(value);
}

}  // namespace

void add_values(LabelValues& known, const Labels& labels) {
  for (const auto& [name, value] : labels) add_value(known, name, value);
}

void add_values(LabelValues& known, const LabelValues& more) {
  for (const auto& [name, values] : more) {
    for (const std::string& value : values) add_value(known, name, value);
  }
}

std::vector<std::string> values_of(const LabelValues& known, std::string_view name) {
  const auto label = std::ranges::find(known, name, &LabelValues::value_type::first);
  return label == known.end() ? std::vector<std::string>{} : label->second;
}

const std::string* find_label(const Labels& labels, std::string_view name) {
  const auto found =
      std::find_if(labels.begin(), labels.end(), [&](const auto& l) { return l.first == name; });
  return found == labels.end() ? nullptr : &found->second;
}

Labels without_label(const Labels& labels, std::string_view name) {
  Labels others;
  std::copy_if(labels.begin(), labels.end(), std::back_inserter(others),
               [&](const auto& l) { return l.first != name; });
  return others;
}

std::string labels_text(const Labels& labels) {
  std::string text;
  for (const auto& [name, value] : labels)
    text.append(text.empty() ? "" : " ").append(name).append("=").append(value);
  return text;
}

std::strong_ordering natural_order(std::string_view a, std::string_view b) {
  const auto x = finite_number(a);
  const auto y = finite_number(b);
  if (x.has_value() != y.has_value()) {
    return x.has_value() ? std::strong_ordering::less : std::strong_ordering::greater;
  }
  if (x.has_value() && *x < *y) return std::strong_ordering::less;
  if (x.has_value() && *x > *y) return std::strong_ordering::greater;
  return a <=> b;
}

std::strong_ordering label_order(const Labels& a, const Labels& b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (const auto names = a[i].first <=> b[i].first; names != 0) return names;
    if (const auto values = natural_order(a[i].second, b[i].second); values != 0) return values;
  }
  return a.size() <=> b.size();
}

bool can_be_label(std::string_view name) {
  constexpr std::array taken{"seed", "vehicle", "quantity", "value"};
  return !name.empty() && std::find(taken.begin(), taken.end(), name) == taken.end();
}

}  // namespace fairway
