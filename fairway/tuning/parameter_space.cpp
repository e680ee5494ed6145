// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/parameter_space.hpp"

#include "fairway/core/text.hpp"

namespace fairway {

std::string value_text(const TunedParameter& parameter, double value) {
  if (parameter.kind == TunedParameter::Kind::choice)
    return parameter.choices[static_cast<std::size_t>(value)];
  return number_text(value);
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

}  // namespace fairway
