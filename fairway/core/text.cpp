// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace fairway {

std::string number_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

double to_six_digits(double value) {
  if (!std::isfinite(value)) return value;
  std::array<char, 32> buffer{};
  char* const begin = buffer.data();
  const char* const end =
      std::to_chars(begin, begin + buffer.size(), value, std::chars_format::general, 6).ptr;
  std::from_chars(begin, end, value);
  return value;
}

std::string shell_word(std::string_view text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::optional<std::size_t> not_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  for (std::size_t i = 0; i < text.size();) {
    const unsigned first = byte(i);
    std::size_t more = 0;  // bytes that follow, the first of them in [lo, hi] (Unicode 15, table 3-7)
    unsigned lo = 0x80, hi = 0xBF;
    if (first >= 0xF0) {
      more = 3;
      if (first == 0xF0) lo = 0x90;
      if (first == 0xF4) hi = 0x8F;
    } else if (first >= 0xE0) {
      more = 2;
      if (first == 0xE0) lo = 0xA0;
      if (first == 0xED) hi = 0x9F;
    } else if (first >= 0x80) {
      more = 1;
    }
    if (first > 0xF4 || (first >= 0x80 && first < 0xC2)) return i;
    if (more > 0 && (byte(i + 1) < lo || byte(i + 1) > hi)) return i;
    for (std::size_t j = 2; j <= more; ++j)
      if (byte(i + j) < 0x80 || byte(i + j) > 0xBF) return i;
    i += more + 1;
  }
  return {};
}

ParamValue parse_value(std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  double value{};
  const char* end = text.data() + text.size();
  const char* begin = text.starts_with('+') ? text.data() + 1 : text.data();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc{} && stop == end) return value;
  return std::string(text);
}

}  // namespace fairway
