// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace fairway {

/// A digest of what a scenario file asks of whoever avoids there, as it is drawn for the seed 1: equal for
/// copies of one under whatever name, with whatever comments, summary, expectations and avoiders. `file` is
/// for messages. Throws InputError where it cannot be read.
std::string ground_digest(std::string_view text, const std::string& file);

}  // namespace fairway
