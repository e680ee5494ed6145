// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/claim.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace fairway {

std::string_view name_of(Standing standing) {
  constexpr std::array names{"holds", "does not hold", "reversed", "undecided", "not measured"};
  return names[static_cast<std::size_t>(standing)];
}

MeanEstimate exactly(double value) {
  return {.count = 1, .mean = value, .deviation = 0.0, .low = value, .high = value};
}

Standing is_less(const MeanEstimate& a, const MeanEstimate& b) {
  for (const double number : {a.low, a.high, b.low, b.high}) {
    if (!std::isfinite(number)) return Standing::not_measured;
  }
  if (a.high < b.low) return Standing::holds;
  return b.high < a.low ? Standing::reversed : Standing::undecided;
}

Standing all_are(std::size_t count, std::size_t total) {
  if (total == 0) return Standing::not_measured;
  return count == total ? Standing::holds : Standing::does_not_hold;
}

std::string stated(std::string_view claim, Standing standing, std::string_view numbers) {
  if (standing == Standing::not_measured || numbers.empty())
    return fmt::format("{}: {}.", claim, name_of(standing));
  return fmt::format("{}: {} ({}).", claim, name_of(standing), numbers);
}

}  // namespace fairway
