// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <concepts>
#include <limits>
#include <string>

#include "fairway/core/text.hpp"

/// How numbers are read from the command line: to their last character, as
/// `option->transform(whole_number<T>())`. What CLI11 does by itself takes -1 for the greatest unsigned
/// number, 010 for eight and nan for a number.
namespace fairway::cli {

/// More threads than that are a slip of the finger.
inline constexpr unsigned max_jobs = 1024;

/// A whole number in [lo, hi], in decimal digits.
template <std::integral T>
CLI::Validator whole_number(T lo = std::numeric_limits<T>::min(), T hi = std::numeric_limits<T>::max()) {
  return {[lo, hi](std::string& text) -> std::string {
            T value{};
            const char* end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error != std::errc{} || stop != end || value < lo || value > hi) {
              return "expected a whole number in [" + std::to_string(lo) + ", " + std::to_string(hi) +
                     "], got \"" + text + "\"";
            }
            text = std::to_string(value);  // a zero before it would make it octal
            return {};
          },
          ""};
}

/// A finite number in [lo, hi].
inline CLI::Validator finite_number(double lo = std::numeric_limits<double>::lowest(),
                                    double hi = std::numeric_limits<double>::max()) {
  return {[lo, hi](std::string& text) -> std::string {
            double value{};
            const char* end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc{} && stop == end && value >= lo && value <= hi) return {};
            const bool bounded = lo > std::numeric_limits<double>::lowest();
            const bool closed = hi < std::numeric_limits<double>::max();
            return "expected a finite number" +
                   (closed    ? " in [" + number_text(lo) + ", " + number_text(hi) + "]"
                    : bounded ? " from " + number_text(lo)
                              : std::string{}) +
                   ", got \"" + text + "\"";
          },
          ""};
}

}  // namespace fairway::cli
