// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/envelope_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/core/names.hpp"
#include "fairway/core/text.hpp"

namespace fairway {
namespace {

double number_of(const std::string& text, double least, const std::string& path) {
  const ParamValue value = parse_value(text);
  const double* given = std::get_if<double>(&value);
  if (given != nullptr && std::isfinite(*given) && *given >= least) return *given;
  throw InputError({}, path, "is \"" + text + "\"; expected a number" + (least >= 0.0 ? ", 0 or more" : ""));
}

template <std::size_t N>
std::array<double, N> list_of(std::string text, const std::string& path) {
  std::ranges::replace(text, ',', ' ');
  std::istringstream in{text};
  const std::vector<std::string> words{std::istream_iterator<std::string>{in}, {}};
  if (words.size() != N) {
    throw InputError({}, path,
                     "has " + std::to_string(words.size()) + " numbers; expected " + std::to_string(N));
  }
  std::array<double, N> list{};
  std::ranges::transform(words, list.begin(), [&](const std::string& w) { return number_of(w, 0.0, path); });
  return list;
}

void read(double& target, const std::string& text, double least, const std::string& path) {
  target = number_of(text, least, path);
}

template <std::size_t N>
void read(std::array<double, N>& target, const std::string& text, double, const std::string& path) {
  target = list_of<N>(text, path);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for_each_member<Envelope>([&](const auto& m) { all.push_back(m.name_with_unit()); });
  return all;
}

bool is_sound_number(double value, double least) { return std::isfinite(value) && value >= least; }

template <std::size_t N>
bool is_sound_number(const std::array<double, N>& values, double) {
  return std::ranges::all_of(values, [](double value) { return is_sound_number(value, 0.0); });
}

}  // namespace

Envelope envelope_of_numbers(std::span<const std::pair<std::string, std::string>> numbers,
                             std::string_view where) {
  const auto path_of = [&](const std::string& name) { return std::string(where) + name; };
  const std::vector<std::string> known = names();
  for (auto given = numbers.begin(); given != numbers.end(); ++given) {
    const std::string& name = given->first;
    if (std::ranges::find(known, name) == known.end())
      throw InputError({}, path_of(name), "unknown number" + suggestion(name, {known.begin(), known.end()}));
    const auto is_it = [&](const auto& other) { return other.first == name; };
    if (std::any_of(numbers.begin(), given, is_it)) throw InputError({}, path_of(name), "is given twice");
  }

  Envelope envelope;
  for_each_member<Envelope>([&](const auto& m) {
    const std::string name = m.name_with_unit();
    const auto given = std::ranges::find(numbers, name, [](const auto& number) { return number.first; });
    if (given != numbers.end()) {
      read(envelope.*(m.at), given->second, m.least, path_of(name));
    } else if (m.is_required) {
      throw InputError({}, path_of(name), "is missing; expected " + std::string(m.meaning));
    }
  });
  if (const std::string_view why = why_unusable(envelope); !why.empty())
    throw InputError({}, std::string(where.substr(0, where.find_last_not_of('.') + 1)), std::string(why));
  return envelope;
}

std::string_view why_unusable(const Envelope& envelope) noexcept {
  bool is_sound = true;
  for_each_member<Envelope>([&](const auto& m) {
    const auto& value = envelope.*(m.at);
    is_sound = is_sound && is_sound_number(value, m.least);
  });
  if (!is_sound) return "a number of the envelope is not finite, or below zero where it cannot be";
  if (!(envelope.ahead > 0.0)) return "an envelope's greatest speed ahead has to be above zero";
  if (!(envelope.deceleration > 0.0 && envelope.acceleration > 0.0))
    return "an envelope's acceleration and deceleration have to be above zero";
  if (!(envelope.turn_acceleration > 0.0) || *std::ranges::max_element(envelope.turn_rates) <= 0.0)
    return "an envelope has to have a turn acceleration and turn rates above zero";
  if (envelope.least > envelope.ahead) return "an envelope's least speed is above its greatest ahead";
  return {};
}

}  // namespace fairway
