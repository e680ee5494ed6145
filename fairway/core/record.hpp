// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <tuple>

#include "fairway/core/params.hpp"

namespace fairway {

/// One member of a record, which is a struct that crosses a boundary. It is said once, beside the member, and
/// read by whoever writes or reads the record: JSON, recordings and their schema, hashes, CSV, differences,
/// Python.
template <class Owner, class T>
struct RecordMember {
  T Owner::*at;
  std::string_view name;                                   ///< the member's own: "position"
  std::string_view unit;                                   ///< as names end in it, "mps"; empty without one
  std::string_view meaning;                                ///< with unit and frame for people
  double least{-std::numeric_limits<double>::infinity()};  ///< a number that is read must not be below this
  bool is_required{};                                      ///< there has to be one where the record is read

  consteval RecordMember required() const {
    RecordMember m = *this;
    m.is_required = true;
    return m;
  }
  consteval RecordMember not_negative() const {
    RecordMember m = *this;
    m.least = 0.0;
    return m;
  }

  /// "position_m".
  std::string name_with_unit() const {
    return unit.empty() ? std::string(name) : std::string(name) + "_" + std::string(unit);
  }
};

template <auto At>
consteval auto member(std::string_view unit, std::string_view meaning) {
  using Traits = detail::member_of<decltype(At)>;
  using Made = RecordMember<typename Traits::owner, typename Traits::value>;
  return Made{At, detail::member_name<At>(), unit, meaning};
}

/// A struct all of whose members are listed, in their order, by `static consteval auto members()`.
template <class R>
concept RecordType = requires { R::members(); };

template <RecordType R, class Visitor>
constexpr void for_each_member(Visitor&& visit) {
  constexpr auto all = R::members();
  std::apply([&](const auto&... m) { (visit(m), ...); }, all);
}

}  // namespace fairway
