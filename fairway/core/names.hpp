// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fairway {

/// The known name closest to `typed` by edit distance, or empty if none is close enough to be meant.
/// O(known × |typed| × |name|).
std::string_view nearest_name(std::string_view typed, const std::vector<std::string_view>& known);

/// "; did you mean time_horizon_s?" or, if nothing is near, "; known: a, b, c".
std::string suggestion(std::string_view typed, const std::vector<std::string_view>& known);

}  // namespace fairway
