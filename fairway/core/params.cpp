// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/params.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "fairway/core/text.hpp"

namespace fairway::detail {
namespace {

std::string value_text(const ParamValue& value) {
  if (const double* number = std::get_if<double>(&value)) return number_text(*number);
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  return "\"" + std::get<std::string>(value) + "\"";
}

[[noreturn]] void refuse(std::string_view name, const ParamValue& value, const std::string& expected) {
  throw InputError({}, std::string(name), "is " + value_text(value) + "; expected " + expected);
}

/// "red, green".
std::string list_of(std::span<const char* const> choices) {
  std::string list;
  for (const char* choice : choices) list += (list.empty() ? "" : ", ") + std::string(choice);
  return list;
}

double number_in(std::string_view name, Range range, const ParamValue& value, bool whole) {
  const double* given = std::get_if<double>(&value);
  const bool fits = given != nullptr && *given >= range.lo && *given <= range.hi &&
                    (!whole || *given == std::floor(*given));
  if (!fits) {
    refuse(name, value,
           std::string(whole ? "a whole number in [" : "a number in [") + number_text(range.lo) + ", " +
               number_text(range.hi) + "]");
  }
  return *given;
}

ParamInfo info_of(std::string_view name, std::string_view unit, const char* type, Range range,
                  std::string_view meaning, ParamValue value) {
  return {.name = std::string(name),
          .unit = std::string(unit),
          .type = type,
          .range = range,
          .meaning = std::string(meaning),
          .value = std::move(value),
          .choices = {}};
}

}  // namespace

void assign(double& target, std::string_view name, Range range, const ParamValue& value) {
  target = number_in(name, range, value, false);
}

void assign(int& target, std::string_view name, Range range, const ParamValue& value) {
  target = static_cast<int>(number_in(name, range, value, true));
}

void assign(bool& target, std::string_view name, Range, const ParamValue& value) {
  const bool* given = std::get_if<bool>(&value);
  if (given == nullptr) refuse(name, value, "true or false");
  target = *given;
}

void check(double value, std::string_view name, Range range) { number_in(name, range, value, false); }

void check(int value, std::string_view name, Range range) {
  number_in(name, range, static_cast<double>(value), true);
}

void check_choice(std::size_t index, std::string_view name, std::span<const char* const> choices) {
  if (index >= choices.size()) refuse(name, static_cast<double>(index), "one of " + list_of(choices));
}

std::size_t chosen_index(std::string_view name, std::span<const char* const> choices,
                         const ParamValue& value) {
  const std::string* given = std::get_if<std::string>(&value);
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (given != nullptr && *given == choices[i]) return i;
  }
  refuse(name, value, "one of " + list_of(choices));
}

ParamInfo describe(std::string_view name, std::string_view unit, Range range, std::string_view meaning,
                   double value) {
  return info_of(name, unit, "number", range, meaning, value);
}

ParamInfo describe(std::string_view name, std::string_view unit, Range range, std::string_view meaning,
                   int value) {
  return info_of(name, unit, "integer", range, meaning, static_cast<double>(value));
}

ParamInfo describe(std::string_view name, std::string_view unit, Range range, std::string_view meaning,
                   bool value) {
  return info_of(name, unit, "boolean", range, meaning, value);
}

ParamInfo describe_choice(std::string_view name, std::string_view meaning,
                          std::span<const char* const> choices, std::size_t index) {
  ParamInfo info = info_of(name, "", "choice", {}, meaning, std::string(choices[index]));
  info.choices.assign(choices.begin(), choices.end());
  return info;
}

ParamInfo describe_list(std::string_view name, std::string_view meaning, std::size_t length,
                        std::vector<ParamInfo> items) {
  ParamInfo info = info_of(name, "", "list", {}, meaning, static_cast<double>(length));
  info.items = std::move(items);
  return info;
}

bool names_list(std::string_view name, std::string_view list) {
  return name.starts_with(list) && (name.size() == list.size() || name[list.size()] == '[');
}

std::size_t list_length(std::string_view name, const ParamValue& value) {
  const double* given = std::get_if<double>(&value);
  const bool fits = given != nullptr && *given >= 0.0 && *given <= static_cast<double>(max_list_items) &&
                    *given == std::floor(*given);
  if (!fits) refuse(name, value, "a list of up to " + std::to_string(max_list_items) + " items");
  return static_cast<std::size_t>(*given);
}

ListStep list_step(std::string_view name, std::string_view list, std::size_t length) {
  const std::string_view rest = name.substr(list.size() + 1);
  ListStep step;
  const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), step.index);
  const std::string_view tail{stop, static_cast<std::size_t>(rest.data() + rest.size() - stop)};
  if (error != std::errc{} || !tail.starts_with("].") || tail.size() < 3) {
    throw InputError({}, std::string(name), "expected " + std::string(list) + "[index].parameter");
  }
  if (step.index >= length) {
    throw InputError({}, std::string(name), "the list has " + std::to_string(length) + " items");
  }
  step.member = tail.substr(2);
  return step;
}

InputError in_list(std::string_view name, std::string_view member, const InputError& error) {
  std::string_view message = error.what();
  if (message.starts_with(member)) message.remove_prefix(std::min(message.size(), member.size() + 2));
  return InputError({}, std::string(name), std::string(message));
}

}  // namespace fairway::detail

namespace fairway {

ParamValues merged(ParamValues values, const ParamValues& over) {
  for (const auto& [name, value] : over) {
    const auto same = std::ranges::find(values, name, &ParamValues::value_type::first);
    if (same == values.end()) {
      values.emplace_back(name, value);
    } else {
      same->second = value;
    }
  }
  return values;
}

}  // namespace fairway
