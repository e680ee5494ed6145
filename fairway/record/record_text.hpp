// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "fairway/core/text.hpp"
#include "fairway/record/record_kinds.hpp"

// Any record as columns of a table: a column for each number, switch and word, covariances row by row.

namespace fairway {
namespace detail {

/// What follows the member's name in the columns of a value.
template <class T>
std::vector<std::string> column_parts() {
  static constexpr std::array axes{"n", "e", "d"};
  std::vector<std::string> parts;
  if constexpr (is_optional<T>) {
    return column_parts<typename T::value_type>();
  } else if constexpr (std::same_as<T, Vec3>) {
    return {axes.begin(), axes.end()};
  } else if constexpr (std::same_as<T, Wrench>) {
    return {"x_n", "y_n", "z_n", "k_nm", "m_nm", "n_nm"};
  } else if constexpr (std::same_as<T, Mat3>) {
    for (const char* row : axes) {
      for (const char* column : axes) parts.push_back(std::string(row) + column);
    }
    return parts;
  } else {
    return {""};
  }
}

template <class T>
void add_texts(const T& value, std::vector<std::string>& texts) {
  if constexpr (is_optional<T>) {
    if (value) return add_texts(*value, texts);
    texts.resize(texts.size() + column_parts<T>().size());
  } else if constexpr (std::same_as<T, bool>) {
    texts.emplace_back(value ? "true" : "false");
  } else if constexpr (Id<T>) {
    texts.push_back(std::to_string(number(value)));
  } else if constexpr (std::is_enum_v<T>) {
    texts.emplace_back(enum_name(value));
  } else if constexpr (std::integral<T>) {
    texts.push_back(std::to_string(value));
  } else if constexpr (std::same_as<T, double>) {
    texts.push_back(number_text(value));
  } else if constexpr (Real<T>) {
    for (Eigen::Index row = 0; row < value.rows(); ++row) {
      for (Eigen::Index column = 0; column < value.cols(); ++column)
        texts.push_back(number_text(value(row, column)));
    }
  } else {
    texts.emplace_back(value);
  }
}

}  // namespace detail

/// The names of the columns: "id", "x_m", "velocity_n_mps", "position_covariance_ne_m2".
template <RecordType R>
std::vector<std::string> record_columns() {
  std::vector<std::string> columns;
  for_each_member<R>([&]<class T>(const RecordMember<R, T>& m) {
    static constexpr std::array place{"x", "y", "z"};
    for (std::size_t i = 0; const std::string& part : detail::column_parts<T>()) {
      std::string name{m.name};
      if (!part.empty()) name = m.name == "position" ? place.at(i++) : name + "_" + part;
      if (!m.unit.empty()) name.append("_").append(m.unit);
      columns.push_back(std::move(name));
    }
  });
  return columns;
}

/// What stands in them, to full precision; empty where an optional member is not there.
template <RecordType R>
std::vector<std::string> record_texts(const R& record) {
  std::vector<std::string> texts;
  for_each_member<R>([&](const auto& m) { detail::add_texts(record.*m.at, texts); });
  return texts;
}

}  // namespace fairway
