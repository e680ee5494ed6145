// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/core/names.hpp"

namespace fairway {

/// Inclusive bounds. They validate a scenario and are the search space of tuning.
struct Range {
  double lo;
  double hi;
};

/// A parameter's value as written in a scenario, on the command line or in JSON.
using ParamValue = std::variant<double, bool, std::string>;
using ParamValues = std::vector<std::pair<std::string, ParamValue>>;

/// The names of an enumeration's values, in order; specialise to use it as a parameter:
/// `template <> struct EnumNames<Drag> { static constexpr std::array names{"linear", "full"}; };`
template <class E>
struct EnumNames;

/// The name of an enumerator.
template <class E>
constexpr const char* enum_name(E value) {
  return EnumNames<E>::names[static_cast<std::size_t>(value)];
}

/// One tunable value of an algorithm, model or sensor: said once, next to its default, and read by
/// the YAML loader, the tuner, `fairway describe` and the report.
template <class Owner, class T>
struct Field {
  T Owner::*member;
  std::string_view name;
  std::string_view unit;
  Range range;
  std::string_view meaning;
};

/// A list of structs as a parameter: `layout: [{x_m: 1}, {x_m: 2}]`. As flat values it is its length and then
/// its items, `layout` = 2, `layout[0].x_m` = 1, `layout[1].x_m` = 2.
inline constexpr std::size_t max_list_items = 64;

/// "layout" of "layout[3].x_m"; any other name as it is.
constexpr std::string_view list_of_param(std::string_view name) { return name.substr(0, name.find('[')); }

/// A field with its present value, its type erased: what `describe` and the schema print.
struct ParamInfo {
  std::string name;
  std::string unit;  ///< "s", "mps", "" for switches and choices
  std::string type;  ///< "number", "integer", "boolean", "choice", "list"
  Range range{};
  std::string meaning;
  ParamValue value;                  ///< default, or present value; of a list its length
  std::vector<std::string> choices;  ///< of a choice
  std::vector<ParamInfo> items;      ///< of a list: what each item has, with its defaults
};

namespace detail {

/// "horizon_s" from `&Params::horizon_s`.
template <auto Member>
consteval std::string_view member_name() {
  constexpr std::string_view signature = __PRETTY_FUNCTION__;  // "... Member = &A::B::name; ..."
  constexpr auto from = signature.find("Member = ");
  constexpr auto path = signature.substr(from, signature.find_first_of(";]", from) - from);
  // clang prints "&Params::x", g++ "&A::Params::x" or "(& Params::x)"
  constexpr auto tail = path.substr(path.rfind("::") + 2);
  return tail.substr(0, tail.find_first_of(" )"));
}

/// "s" from "horizon_s". A number without a known suffix does not compile.
consteval std::string_view unit_of(std::string_view name) {
  constexpr std::array units{"m",      "s",         "mps",      "mps2",  "rad",    "deg",      "radps",
                             "degps",  "hz",        "kg",       "kgm2",  "n",      "nm",       "kgpm",
                             "kgps",   "kgm2ps",    "kgm2prad", "kgpm3", "w",      "count",    "ratio",
                             "radps2", "kgm2prad2", "npm",      "npmps", "nmprad", "nmpradps", "bps"};
  const auto underscore = name.rfind('_');
  const auto suffix = underscore == std::string_view::npos ? "" : name.substr(underscore + 1);
  for (const std::string_view unit : units) {
    if (suffix == unit) return unit;
  }
  throw "name a parameter after its unit: turn_step_deg, clearance_m, swarm_count";
}

template <class T>
inline constexpr bool is_list = false;
template <class Item>
inline constexpr bool is_list<std::vector<Item>> = true;

template <class>
struct member_of;
template <class O, class T>
struct member_of<T O::*> {
  using owner = O;
  using value = T;
};

}  // namespace detail

/// A number, whose name ends in its unit.
template <auto Member>
consteval auto field(Range range, std::string_view meaning) {
  using Traits = detail::member_of<decltype(Member)>;
  constexpr auto name = detail::member_name<Member>();
  return Field<typename Traits::owner, typename Traits::value>{Member, name, detail::unit_of(name), range,
                                                               meaning};
}

/// A switch (bool), a choice (an enumeration with EnumNames), or a list of structs.
template <auto Member>
consteval auto field(std::string_view meaning) {
  using Traits = detail::member_of<decltype(Member)>;
  using Value = typename Traits::value;
  static_assert(std::same_as<Value, bool> || std::is_enum_v<Value> || detail::is_list<Value>,
                "a number needs a range");
  return Field<typename Traits::owner, typename Traits::value>{
      Member, detail::member_name<Member>(), "", {0, 0}, meaning};
}

/// A struct whose every tunable member is listed once by `static consteval auto fields()`.
template <class P>
concept Reflected = std::default_initializable<P> && std::copyable<P> && requires { P::fields(); };

struct NoParams {
  static consteval auto fields() { return std::tuple{}; }
};

template <Reflected P, class Visitor>
constexpr void for_each_field(Visitor&& visit) {
  constexpr auto all = P::fields();  // a name of its own: clang 16 fails on the call in the argument
  std::apply([&](const auto&... f) { (visit(f), ...); }, all);
}

namespace detail {

// out of line: a model may have dozens of parameters, each of which would be compiled apart
void assign(double& target, std::string_view name, Range range, const ParamValue& value);
void assign(int& target, std::string_view name, Range range, const ParamValue& value);
void assign(bool& target, std::string_view name, Range range, const ParamValue& value);
std::size_t chosen_index(std::string_view name, std::span<const char* const> choices,
                         const ParamValue& value);

template <class E>
  requires std::is_enum_v<E>
void assign(E& target, std::string_view name, Range, const ParamValue& value) {
  target = static_cast<E>(chosen_index(name, EnumNames<E>::names, value));
}

ParamInfo describe(std::string_view name, std::string_view unit, Range range, std::string_view meaning,
                   double value);
ParamInfo describe(std::string_view name, std::string_view unit, Range range, std::string_view meaning,
                   int value);
ParamInfo describe(std::string_view name, std::string_view unit, Range range, std::string_view meaning,
                   bool value);
ParamInfo describe_choice(std::string_view name, std::string_view meaning,
                          std::span<const char* const> choices, std::size_t index);

template <class E>
  requires std::is_enum_v<E>
ParamInfo describe(std::string_view name, std::string_view, Range, std::string_view meaning, E value) {
  return describe_choice(name, meaning, EnumNames<E>::names, static_cast<std::size_t>(value));
}

ParamInfo describe_list(std::string_view name, std::string_view meaning, std::size_t length,
                        std::vector<ParamInfo> items);

/// What follows the name of a list in "layout[3].x_m".
struct ListStep {
  std::size_t index{};
  std::string_view member;
};

/// True for "layout" and for "layout[3].x_m" where the list is "layout".
bool names_list(std::string_view name, std::string_view list);
/// The length that a list is given. Throws unless it is one.
std::size_t list_length(std::string_view name, const ParamValue& value);
/// A refusal by an item, told with the whole name.
InputError in_list(std::string_view name, std::string_view member, const InputError& error);
/// Throws if `name` is not an item of a list of `length`.
ListStep list_step(std::string_view name, std::string_view list, std::size_t length);

}  // namespace detail

/// Names of all parameters, in order of declaration.
template <Reflected P>
std::vector<std::string_view> param_names() {
  std::vector<std::string_view> names;
  for_each_field<P>([&](const auto& f) { names.push_back(f.name); });
  return names;
}

template <Reflected P>
bool set_param(P& params, std::string_view name, const ParamValue& value, bool optional = false);

namespace detail {

/// Sets the length, which empties the list, or one value of one item.
template <Reflected Item>
void assign_list(std::vector<Item>& list, std::string_view name, std::string_view list_name,
                 const ParamValue& value) {
  if (name == list_name) {
    list.assign(list_length(name, value), Item{});
    return;
  }
  const ListStep step = list_step(name, list_name, list.size());
  try {
    set_param(list[step.index], step.member, value);
  } catch (const InputError& error) {
    throw in_list(name, step.member, error);
  }
}

}  // namespace detail

/// Sets one parameter by name. Throws InputError naming the parameter, what was given and what is
/// accepted; an unknown name gets the nearest known one. False instead of a throw when `optional`.
template <Reflected P>
bool set_param(P& params, std::string_view name, const ParamValue& value, bool optional) {
  bool known = false;
  for_each_field<P>([&](const auto& f) {
    auto& member = params.*(f.member);
    if constexpr (detail::is_list<std::remove_cvref_t<decltype(member)>>) {
      if (!detail::names_list(name, f.name)) return;
      known = true;
      detail::assign_list(member, name, f.name, value);
    } else {
      if (f.name != name) return;
      known = true;
      detail::assign(member, name, f.range, value);
    }
  });
  if (!known && !optional) {
    throw InputError({}, std::string(name), "unknown parameter" + suggestion(name, param_names<P>()));
  }
  return known;
}

/// `params` with `values` in place of those that they name. Throws as set_param(); `optional` passes over
/// names that there are not.
template <Reflected P>
P params_of(const ParamValues& values, P params = {}, bool optional = false) {
  for (const auto& [name, value] : values) set_param(params, name, value, optional);
  return params;
}

namespace detail {

void check(double value, std::string_view name, Range range);
void check(int value, std::string_view name, Range range);
inline void check(bool, std::string_view, Range) {}
void check_choice(std::size_t index, std::string_view name, std::span<const char* const> choices);

template <class E>
  requires std::is_enum_v<E>
void check(E value, std::string_view name, Range) {
  check_choice(static_cast<std::size_t>(value), name, EnumNames<E>::names);
}

}  // namespace detail

/// Throws InputError, as set_param() does, if a value is outside its range: for parameters that were put
/// together in C++. `prefix` stands before their names.
template <Reflected P>
void check_params(const P& params, const std::string& prefix = {}) {
  for_each_field<P>([&](const auto& f) {
    const auto& member = params.*(f.member);
    if constexpr (detail::is_list<std::remove_cvref_t<decltype(member)>>) {
      const std::string name = prefix + std::string(f.name);
      (void)detail::list_length(name, static_cast<double>(member.size()));
      for (std::size_t i = 0; i < member.size(); ++i)
        check_params(member[i], name + "[" + std::to_string(i) + "].");
    } else if (prefix.empty()) {
      detail::check(member, f.name, f.range);
    } else {
      detail::check(member, prefix + std::string(f.name), f.range);
    }
  });
}

/// `params`, to be initialised with. Throws as check_params().
template <Reflected P>
const P& checked_params(const P& params) {
  check_params(params);
  return params;
}

/// `values`, with those of `over` in place of the same names.
ParamValues merged(ParamValues values, const ParamValues& over);

/// Every parameter with its present value.
template <Reflected P>
std::vector<ParamInfo> describe_params(const P& params = {}) {
  std::vector<ParamInfo> infos;
  for_each_field<P>([&](const auto& f) {
    const auto& member = params.*(f.member);
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (detail::is_list<Member>) {
      infos.push_back(detail::describe_list(f.name, f.meaning, member.size(),
                                            describe_params<typename Member::value_type>()));
    } else {
      infos.push_back(detail::describe(f.name, f.unit, f.range, f.meaning, member));
    }
  });
  return infos;
}

}  // namespace fairway
