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
  double usual{};  ///< what the method has where nobody sets it: a value, or an index. If it is not searched:
                   ///< the end of the range that is nearest, or the index behind the last choice
  std::string beyond;  ///< then the YAML of what the method has, else empty
};

/// One setting of all parameters, in their order: the value of a number or integer, the index of a choice.
using Setting = std::vector<double>;

/// The YAML of a value: 12.5, 8, starboard. Of the index behind the last choice, what the method has.
std::string value_text(const TunedParameter& parameter, double value);

/// `avoider`, a mapping on one line or a name, with the values of `setting` in it.
std::string avoider_text(const std::string& avoider, const std::vector<TunedParameter>& parameters,
                         const Setting& setting);

/// What every method has where nobody sets anything.
Setting usual_setting(const std::vector<TunedParameter>& parameters);

/// Every setting of a space that has at most `most`, in the order in which the values are written; none of a
/// larger space, as any is in which a number is searched.
std::vector<Setting> all_settings(const std::vector<TunedParameter>& parameters, std::size_t most);

}  // namespace fairway
