// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace fairway {

/// A field of a CSV table as RFC 4180 has it: as it is, or in quotes where a comma, a quote or a line break
/// is in it.
std::string csv_field(std::string_view text);

}  // namespace fairway
