// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "fairway/core/params.hpp"

namespace fairway {

/// The shortest decimal that reads back as the same double; "inf", "-inf" and "nan" spelled so.
std::string number_text(double value);

/// `value` to six significant digits, whatever the locale.
double to_six_digits(double value);

/// `text` as one word of a POSIX shell: as it is where nothing in it means anything to a shell, else quoted.
std::string shell_word(std::string_view text);

/// Where the first byte is that belongs to no character of UTF-8; nothing if all is well. O(text).
std::optional<std::size_t> not_utf8(std::string_view text);

/// What a word on the command line means: "true"/"false", a number, or else text.
ParamValue parse_value(std::string_view text);

}  // namespace fairway
