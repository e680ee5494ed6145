// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/record/message_parts.hpp"
#include "fairway/record/record_kinds.hpp"

// Any record as part of a message, and the fields of its schema. First stands what is counted or switched,
// then whether each optional member is there, then all real numbers, zero where there is none: so numbers are
// aligned. Texts are not kept.

namespace fairway {
namespace detail {

template <Discrete T>
void put_discrete(CdrWriter& cdr, T value) {
  if constexpr (std::same_as<T, bool>) {
    cdr.boolean(value);
  } else if constexpr (Id<T>) {
    cdr.number(number(value));
  } else if constexpr (std::is_enum_v<T>) {
    cdr.number(static_cast<std::uint8_t>(value));
  } else {
    cdr.number(value);
  }
}

template <Discrete T>
void get_discrete(CdrReader& cdr, T& value, std::string_view name) {
  if constexpr (std::same_as<T, bool>) {
    value = cdr.boolean();
  } else if constexpr (Id<T>) {
    value = T{cdr.number<std::uint32_t>()};
  } else if constexpr (std::is_enum_v<T>) {
    value = enumerator<T>(cdr.number<std::uint8_t>(), name);
  } else {
    value = cdr.number<T>();
  }
}

template <Real T>
void put_real(CdrWriter& cdr, const T& value) {
  if constexpr (std::same_as<T, double>) {
    cdr.number(value);
  } else if constexpr (std::same_as<T, Mat3>) {
    const Mat3 rows = value.transpose();  // row by row, as ROS has it
    cdr.array({rows.data(), 9});
  } else {
    cdr.array(values(value));
  }
}

template <Real T>
void get_real(CdrReader& cdr, T& value) {
  if constexpr (std::same_as<T, double>) {
    value = cdr.number<double>();
  } else if constexpr (std::same_as<T, Mat3>) {
    Mat3 rows;
    cdr.array({rows.data(), 9});
    value = rows.transpose();
  } else {
    cdr.array(values(value));
  }
}

template <Real T>
T zero() {
  if constexpr (std::same_as<T, double>) {
    return 0.0;
  } else {
    return T::Zero();
  }
}

template <class T>
constexpr std::string_view real_type() {
  if constexpr (is_optional<T>) return real_type<typename T::value_type>();
  if constexpr (std::same_as<T, Vec3>) return "float64[3] ";
  if constexpr (std::same_as<T, Wrench>) return "float64[6] ";
  if constexpr (std::same_as<T, Mat3>) return "float64[9] ";
  return "float64 ";
}

template <Discrete T>
constexpr std::string_view discrete_type() {
  if constexpr (std::same_as<T, bool>) return "bool ";
  if constexpr (Id<T>) return "uint32 ";
  if constexpr (std::is_enum_v<T>) return "uint8 ";
  return "int32 ";
}

}  // namespace detail

template <RecordType R>
void put_record(CdrWriter& cdr, const R& record) {
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::Discrete<T>) detail::put_discrete(cdr, record.*m.at);
  });
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::is_optional<T>) cdr.boolean((record.*m.at).has_value());
  });
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::is_optional<T>) {
      detail::put_real(cdr, (record.*m.at).value_or(detail::zero<typename T::value_type>()));
    } else if constexpr (detail::Real<T>) {
      detail::put_real(cdr, record.*m.at);
    }
  });
}

/// Throws Malformed.
template <RecordType R>
void get_record(CdrReader& cdr, R& record) {
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::Discrete<T>) detail::get_discrete(cdr, record.*m.at, m.name);
  });
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::is_optional<T>) {
      (record.*m.at).reset();
      if (cdr.boolean()) (record.*m.at).emplace();
    }
  });
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::is_optional<T>) {
      auto value = detail::zero<typename T::value_type>();
      detail::get_real(cdr, value);
      if (record.*m.at) record.*m.at = value;
    } else if constexpr (detail::Real<T>) {
      detail::get_real(cdr, record.*m.at);
    }
  });
}

/// The lines of a message definition that put_record() fills, each below its meaning. `prefix` comes before
/// the names of real numbers.
template <RecordType R>
std::string record_definition(std::string_view prefix = {}) {
  std::string text;
  const auto add = [&](std::string_view meaning, std::string_view type, const std::string& name) {
    text.append("# ").append(meaning).append("\n").append(type).append(name).append("\n");
  };
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::Discrete<T>) add(m.meaning, detail::discrete_type<T>(), std::string(m.name));
  });
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::is_optional<T>)
      add("the " + std::string(m.name) + " means something", "bool ", "has_" + std::string(m.name));
  });
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    if constexpr (detail::is_optional<T> || detail::Real<T>)
      add(m.meaning, detail::real_type<T>(), std::string(prefix) + m.name_with_unit());
  });
  return text;
}

}  // namespace fairway
