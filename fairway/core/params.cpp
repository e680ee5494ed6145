// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/params.hpp"

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

std::size_t chosen_index(std::string_view name, std::span<const char* const> choices,
                         const ParamValue& value) {
  const std::string* given = std::get_if<std::string>(&value);
  std::string list;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (given != nullptr && *given == choices[i]) return i;
    list += (i == 0 ? "" : ", ") + std::string(choices[i]);
  }
  refuse(name, value, "one of " + list);
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

}  // namespace fairway::detail
