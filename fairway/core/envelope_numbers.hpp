// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "fairway/core/envelope.hpp"

namespace fairway {

/// What a vehicle can do, given as numbers instead of measured: by the names and in the units that `fairway
/// describe VEHICLE` shows, {"ahead_mps", "1.6"}. `turn_rates_radps` and `following_errors_m` are lists, with
/// blanks or commas between their numbers. The required members of an Envelope and its turn rates have to be
/// given; the others are zero. Throws InputError, one line that begins with `where` and the name.
Envelope envelope_of_numbers(std::span<const std::pair<std::string, std::string>> numbers,
                             std::string_view where = "");

/// What is wrong with an envelope whose numbers are as they came; empty if nothing is. O(1).
std::string_view why_unusable(const Envelope& envelope) noexcept;

}  // namespace fairway
