// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/core/params.hpp"

namespace fairway {

/// One parameter that is searched for.
struct TunedParameter {
  enum class Kind { number, integer, choice };

  std::string name;
  Kind kind{Kind::number};
  Range range{};                     ///< of numbers and integers
  bool logarithmic{false};           ///< a number whose order of magnitude is searched
  std::vector<std::string> choices;  ///< YAML of each
  double usual{};                    ///< what the method has where nobody sets it: a value, or an index
};

/// One setting of all parameters, in their order: the value of a number or integer, the index of a choice.
using Setting = std::vector<double>;

/// The YAML of a value: 12.5, 8, starboard.
std::string value_text(const TunedParameter& parameter, double value);

/// `avoider`, a mapping on one line or a name, with the values of `setting` in it.
std::string avoider_text(const std::string& avoider, const std::vector<TunedParameter>& parameters,
                         const Setting& setting);

/// What every method has where nobody sets anything.
Setting usual_setting(const std::vector<TunedParameter>& parameters);

}  // namespace fairway
