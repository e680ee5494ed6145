// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace fairway {

/// RFC 4648, with padding. O(bytes).
std::string base64_of(std::string_view bytes);

/// A zstd frame that says its size.
std::string zstd_of(std::string_view bytes);

}  // namespace fairway
