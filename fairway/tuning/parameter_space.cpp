// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/parameter_space.hpp"

#include <limits>

#include "fairway/core/text.hpp"

namespace fairway {
namespace {

using Kind = TunedParameter::Kind;

/// How many values a parameter may have.
double count_of(const TunedParameter& parameter) {
  if (parameter.kind == Kind::choice) return static_cast<double>(parameter.choices.size());
  if (parameter.kind == Kind::integer) return parameter.range.hi - parameter.range.lo + 1.0;
  return std::numeric_limits<double>::infinity();
}

/// Each of `settings` with each value of one more parameter. Choices count from 0, as their range begins.
std::vector<Setting> with_each_value(const std::vector<Setting>& settings, const TunedParameter& parameter) {
  const auto count = static_cast<std::size_t>(count_of(parameter));
  std::vector<Setting> longer;
  for (const Setting& setting : settings)
    for (std::size_t step = 0; step < count; ++step) {
      longer.push_back(setting);
      longer.back().push_back(parameter.range.lo + static_cast<double>(step));
    }
  return longer;
}

}  // namespace

std::string value_text(const TunedParameter& parameter, double value) {
  if (parameter.kind != Kind::choice) return number_text(value);
  const auto index = static_cast<std::size_t>(value);
  return index < parameter.choices.size() ? parameter.choices[index] : parameter.beyond;
}

std::string avoider_text(const std::string& avoider, const std::vector<TunedParameter>& parameters,
                         const Setting& setting) {
  const bool is_map = avoider.starts_with('{');
  std::string text = is_map ? avoider.substr(0, avoider.size() - 1) : "{algorithm: " + avoider;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    text += ", " + parameters[i].name + ": " + value_text(parameters[i], setting[i]);
  return text + "}";
}

Setting usual_setting(const std::vector<TunedParameter>& parameters) {
  Setting setting;
  for (const TunedParameter& parameter : parameters) setting.push_back(parameter.usual);
  return setting;
}

std::vector<Setting> all_settings(const std::vector<TunedParameter>& parameters, std::size_t most) {
  std::vector<Setting> settings{{}};
  for (const TunedParameter& parameter : parameters) {
    if (static_cast<double>(settings.size()) * count_of(parameter) > static_cast<double>(most)) return {};
    settings = with_each_value(settings, parameter);
  }
  return settings;
}

}  // namespace fairway
