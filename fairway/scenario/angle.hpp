// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/core/angles.hpp"
#include "fairway/scenario/block.hpp"

namespace fairway::yaml {

/// The degrees that read back as exactly these radians, or nothing: about one angle in ten has none.
std::optional<double> exact_degrees(double angle);

/// One angle under two names: degrees for people, radians where degrees would lose the last bit.
/// Infinity stands for "not given".
template <class Owner>
Block<Owner> angle(const std::string& stem, const std::string& in_degrees, const std::string& in_radians,
                   double Owner::*member, Bounds bounds, const std::string& meaning) {
  const Bounds bounds_rad = {radians(bounds.lo), radians(bounds.hi), bounds.above};
  Key<Owner> degree = key(stem + in_degrees, member, number(bounds), meaning);
  Key<Owner> radian = key(stem + in_radians, member, number(bounds_rad), meaning + " In radians.");
  degree.read = [member, bounds](const Value& value, Owner& owner) {
    owner.*member = radians(value.number(bounds));
  };
  degree.write = [member](const Owner& owner) -> std::optional<Tree> {
    const std::optional<double> exact = exact_degrees(owner.*member);
    if (!std::isfinite(owner.*member) || !exact) return {};
    return Tree::number(*exact);
  };
  radian.write = [member](const Owner& owner) -> std::optional<Tree> {
    if (!std::isfinite(owner.*member) || exact_degrees(owner.*member)) return {};
    return Tree::number(owner.*member);
  };
  return {degree, radian};
}

}  // namespace fairway::yaml
